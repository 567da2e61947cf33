// Phong's light model at a point: the geometry and the colours, without casting rays.
#pragma once

#include "raytracer/shape.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// A hit as the light model sees it: the symbols of the assignment.
struct ShadingPoint {
    ShadingPoint(const Ray& ray, const Intersection& hit, bool bilinear);

    const Intersection* hit;
    Vec3 V;         // unit, towards the ray's origin
    Vec3 N;         // unit, the normal turned to the side that the ray comes from
    bool entering;  // the ray meets the exterior side; N is turned by it, though V.N may be 0 but for rounding
    Color K_D;      // color_diffuse times the texture's colour

    // The one maker of secondary rays: from this point, on the side that the ray came from or on the other one.
    enum class Side { Near, Far };
    Ray leave(const Vec3& direction, Side side) const;
};

// One light's share: K_A I_AL, which always counts, and K_D I_L (N.L) + K_S I_L (V.R)^n, which a shadow takes away.
struct DirectLight {
    Color ambient{0}, diffuse{0}, specular{0};
    Vec3 toLight{0};      // from the point to the light, world units
    Real N_L = 0, V_R = 0;  // 0 where the light is behind the surface or reflected away from the viewer

    Color lit() const { return diffuse + specular; }
};
DirectLight directLight(const ShadingPoint& point, const Light& light);

// The direction in which the viewer sees a mirror image.
Vec3 reflectedDirection(const ShadingPoint& point);

// By Snell's law; false on total internal reflection.
bool refractedDirection(const ShadingPoint& point, Vec3& direction);

// The nearest texel.
Color lookUp(const Texture& texture, const Vec2& texCoord);

// The four texels around, weighted by nearness; beyond the image's edge its last ones.
Color lookUpBilinear(const Texture& texture, const Vec2& texCoord);

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
