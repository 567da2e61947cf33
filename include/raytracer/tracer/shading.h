// Phong's light model at a point: the geometry and the colours, without casting rays. For one ray, or several
// that meet the same material.
#pragma once

#include "raytracer/geometry/shape.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

template <class T>
using ColorT = Vec3T<T>;

// The nearest texel.
Color lookUp(const Texture& texture, const Vec2& texCoord);

// The four nearest texels, weighted by nearness. Beyond the image's edge come its last texels again or, where
// it is periodic, those of the opposite edge.
Color lookUpBilinear(const Texture& texture, const Vec2& texCoord, const Periodic& periodic);

// A hit as the light model sees it: the symbols of the assignment.
template <class T>
struct ShadingPointT {
    ShadingPointT(const RayT<T>& ray, const IntersectionT<T>& hit, bool bilinear);

    const IntersectionT<T>* hit;
    Vec3T<T> V;     // unit, towards the ray's origin
    Vec3T<T> N;     // unit, the normal turned to the side that the ray comes from
    bool entering;  // the ray hits the exterior side; it turns N, since V.N may be 0 up to rounding
    ColorT<T> K_D;  // color_diffuse times the texture's colour

    // The only maker of secondary rays: from this point, on the side that the ray came from (Near) or on the
    // other one (Far). isScattered: the direction was reflected or refracted, and has unit length.
    enum class Side { Near, Far };
    RayT<T> leave(const Vec3T<T>& direction, Side side, bool isScattered = false) const;
};
using ShadingPoint = ShadingPointT<Real>;

// One light's contribution: K_A I_AL, which always counts, and K_D I_L (N.L) + K_S I_L (V.R)^n, which a
// shadow takes away.
template <class T>
struct DirectLightT {
    ColorT<T> ambient{0}, diffuse{0}, specular{0};
    Vec3T<T> toLight{0};  // from the point to the light, world units
    T N_L{0}, V_R{0};     // 0 where the light is behind the surface or reflected away from the viewer

    ColorT<T> lit() const { return diffuse + specular; }
};
using DirectLight = DirectLightT<Real>;

template <class T>
DirectLight laneOf(const DirectLightT<T>& direct, int lane) {
    return {laneOf(direct.ambient, lane), laneOf(direct.diffuse, lane), laneOf(direct.specular, lane),
            laneOf(direct.toLight, lane), laneOf(direct.N_L, lane),     laneOf(direct.V_R, lane)};
}

// v mirrored at the unit vector n: 2 (n.v) n - v.
template <class T>
Vec3T<T> mirrored(const Vec3T<T>& v, const Vec3T<T>& n) {
    return T(2) * glm::dot(n, v) * n - v;
}

template <class T>
ShadingPointT<T>::ShadingPointT(const RayT<T>& ray, const IntersectionT<T>& intersection, bool bilinear)
    : hit(&intersection),
      V(normalized(-ray.direction)),
      N(intersection.normal),
      entering(intersection.entering),
      K_D(intersection.material->color_diffuse) {
    if (!entering) N = -N;
    const Texture* const texture = intersection.material->diffuse_texture;
    if (!texture) return;
    const Periodic periodic =
        bilinear ? intersection.shape->periodic(faceOf(intersection.primitive)) : Periodic();
    K_D *= laneByLane<ColorT<T>>(
        [&](const Vec2& uv) {
            return bilinear ? lookUpBilinear(*texture, uv, periodic) : lookUp(*texture, uv);
        },
        intersection.texCoord);
}

template <class T>
RayT<T> ShadingPointT<T>::leave(const Vec3T<T>& direction, Side side, bool isScattered) const {
    const bool inside = entering == (side == Side::Far);
    return {hit->position, direction, {hit->shape, hit->primitive, inside, isScattered, hit->positionError}};
}

template <class T>
DirectLightT<T> directLight(const ShadingPointT<T>& point, const Light& light) {
    const Material& material = *point.hit->material;
    DirectLightT<T> result;
    result.ambient = ColorT<T>(material.color_ambient * light.color_ambient);
    result.toLight = Vec3T<T>(light.position) - point.hit->position;

    // A light in the surface's own plane lights nothing. Rounding must not decide whether a light is in the
    // plane: the specular term would jump from nothing to all.
    const Vec3T<T> error = point.hit->positionError + T(gamma(4)) * abs(result.toLight);
    const Truth<T> before = glm::dot(point.N, result.toLight) > glm::dot(abs(point.N), error);
    if (!any(before)) return result;

    const Vec3T<T> L = normalized(result.toLight);
    result.N_L = select(before, glm::dot(point.N, L), T(0));
    result.diffuse = select(before, point.K_D * ColorT<T>(light.color) * result.N_L, ColorT<T>(T(0)));
    const T V_R = glm::dot(point.V, mirrored(L, point.N));
    result.V_R = select(before, min(max(V_R, T(0)), T(1)), T(0));
    const Truth<T> shines = result.V_R > T(0);
    if (any(shines) && !isBlack(material.color_specular))
        result.specular = select(
            shines, ColorT<T>(material.color_specular * light.color) * power(result.V_R, material.shininess),
            ColorT<T>(T(0)));
    return result;
}

// The direction of the mirror image that the viewer sees.
template <class T>
Vec3T<T> reflectedDirection(const ShadingPointT<T>& point) {
    return mirrored(point.V, point.N);
}

// The direction by Snell's law; false on total internal reflection.
template <class T>
Truth<T> refractedDirection(const ShadingPointT<T>& point, Vec3T<T>& direction) {
    const Real ior = point.hit->material->index_of_refraction;
    const T eta(point.entering ? 1 / ior : ior);
    const Vec3T<T> sine = eta * (glm::dot(point.N, point.V) * point.N - point.V);  // along the surface
    const T squared = T(1) - glm::dot(sine, sine);
    const Truth<T> passes = squared >= T(0);
    if (any(passes)) direction = sine - sqrt(select(passes, squared, T(0))) * point.N;
    return passes;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
