#include "raytracer/tracer/shading.h"

#include <algorithm>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// The texel of a column and row that are whole numbers, kept within the image.
Color texel(const Texture& texture, Real column, Real row) {
    const auto within = [](Real place, int count) {
        return static_cast<std::size_t>(glm::clamp(place, Real(0), static_cast<Real>(count - 1)));
    };
    const std::size_t index =
        within(row, texture.height) * static_cast<std::size_t>(texture.width) + within(column, texture.width);
    const std::uint8_t* rgb = &texture.texels[3 * index];
    return Color(rgb[0], rgb[1], rgb[2]) / Real(255);
}

}  // namespace

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

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
