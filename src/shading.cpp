#include "raytracer/shading.h"

#include <algorithm>

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

// v mirrored at the unit vector n: 2 (n.v) n - v.
Vec3 mirrored(const Vec3& v, const Vec3& n) { return 2 * glm::dot(n, v) * n - v; }

// The texel of a column and row that are whole numbers, kept within the image.
Color texel(const Texture& texture, Real column, Real row) {
    const auto within = [](Real place, int count) {
        return static_cast<std::size_t>(glm::clamp(place, Real(0), static_cast<Real>(count - 1)));
    };
    const std::size_t index = within(row, texture.height) * static_cast<std::size_t>(texture.width) +
                              within(column, texture.width);
    const std::uint8_t* rgb = &texture.texels[3 * index];
    return Color(rgb[0], rgb[1], rgb[2]) / Real(255);
}

}  // namespace

ShadingPoint::ShadingPoint(const Ray& ray, const Intersection& intersection, bool bilinear)
    : hit(&intersection),
      V(normalized(-ray.direction)),
      N(intersection.normal),
      entering(intersection.entering),
      K_D(intersection.material->color_diffuse) {
    if (!entering) N = -N;
    if (const Texture* texture = intersection.material->diffuse_texture)
        K_D *= bilinear ? lookUpBilinear(*texture, intersection.texCoord) : lookUp(*texture, intersection.texCoord);
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
    result.diffuse = point.K_D * light.color * result.N_L;
    if (result.V_R > 0 && !isBlack(material.color_specular))
        result.specular = material.color_specular * light.color * power(result.V_R, material.shininess);
    return result;
}

Vec3 reflectedDirection(const ShadingPoint& point) { return mirrored(point.V, point.N); }

bool refractedDirection(const ShadingPoint& point, Vec3& direction) {
    const Real ior = point.hit->material->index_of_refraction;
    const Real eta = point.entering ? 1 / ior : ior;
    const Real cosine = glm::dot(point.N, point.V);
    const Real squared = 1 - eta * eta * (1 - cosine * cosine);
    if (!(squared >= 0)) return false;
    direction = (eta * cosine - std::sqrt(squared)) * point.N - eta * point.V;
    return true;
}

Color lookUp(const Texture& texture, const Vec2& texCoord) {
    return texel(texture, std::floor(texCoord.x * static_cast<Real>(texture.width)),
                 std::floor((1 - texCoord.y) * static_cast<Real>(texture.height)));
}

Color lookUpBilinear(const Texture& texture, const Vec2& texCoord) {
    const Real x = texCoord.x * static_cast<Real>(texture.width) - Real(0.5);
    const Real y = (1 - texCoord.y) * static_cast<Real>(texture.height) - Real(0.5);
    const Real left = std::floor(x), top = std::floor(y);
    const Color upper = glm::mix(texel(texture, left, top), texel(texture, left + 1, top), x - left);
    const Color lower = glm::mix(texel(texture, left, top + 1), texel(texture, left + 1, top + 1), x - left);
    return glm::mix(upper, lower, y - top);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
