#include "raytracer/shading.h"

#include <algorithm>

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

// v mirrored at the unit vector n: 2 (n.v) n - v.
Vec3 mirrored(const Vec3& v, const Vec3& n) { return 2 * glm::dot(n, v) * n - v; }

}  // namespace

ShadingPoint::ShadingPoint(const Ray& ray, const Intersection& intersection)
    : hit(&intersection),
      V(normalized(-ray.direction)),
      N(intersection.normal),
      entering(glm::dot(V, intersection.normal) >= 0),
      K_D(intersection.material->color_diffuse) {
    if (!entering) N = -N;
    if (const Texture* texture = intersection.material->diffuse_texture) K_D *= lookUp(*texture, intersection.texCoord);
}

Ray ShadingPoint::leave(const Vec3& direction, Side side) const {
    const bool inside = entering == (side == Side::Far);
    return {hit->position, direction, {hit->shape, hit->primitive, inside, hit->positionError}};
}

DirectLight directLight(const ShadingPoint& point, const Light& light) {
    const Material& material = *point.hit->material;
    DirectLight result;
    result.ambient = material.color_ambient * light.color_ambient;
    result.toLight = light.position - point.hit->position;

    // A light in the surface's own plane lights nothing; whether it is must not be left to rounding, since the specular
    // term would jump from nothing to all.
    const Vec3 error = point.hit->positionError + gamma(4) * abs(result.toLight);
    if (!(glm::dot(point.N, result.toLight) > glm::dot(abs(point.N), error))) return result;

    const Vec3 L = normalized(result.toLight);
    result.N_L = glm::dot(point.N, L);
    result.V_R = glm::clamp(glm::dot(point.V, mirrored(L, point.N)), Real(0), Real(1));
    result.lit = point.K_D * light.color * result.N_L;
    if (result.V_R > 0 && !isBlack(material.color_specular))
        result.lit += material.color_specular * light.color * power(result.V_R, material.shininess);
    return result;
}

Vec3 reflectedDirection(const ShadingPoint& point) { return mirrored(point.V, point.N); }

bool refractedDirection(const ShadingPoint& point, Vec3& direction) {
    const Real ior = point.hit->material->index_of_refraction;
    const Real eta = point.entering ? 1 / ior : ior;
    const Real cosine = glm::dot(point.N, point.V);
    const Real squared = 1 - eta * eta * (1 - cosine * cosine);
    if (squared < 0) return false;
    direction = (eta * cosine - std::sqrt(squared)) * point.N - eta * point.V;
    return true;
}

Color lookUp(const Texture& texture, const Vec2& texCoord) {
    const auto nearest = [](Real fraction, int count) {
        const Real texel = std::floor(fraction * static_cast<Real>(count));
        return static_cast<int>(glm::clamp(texel, Real(0), static_cast<Real>(count - 1)));
    };
    const int column = nearest(texCoord.x, texture.width), row = nearest(1 - texCoord.y, texture.height);
    const std::size_t texel = static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.width) +
                              static_cast<std::size_t>(column);
    const std::uint8_t* rgb = &texture.texels[3 * texel];
    return Color(rgb[0], rgb[1], rgb[2]) / Real(255);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
