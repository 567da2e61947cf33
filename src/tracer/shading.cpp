#include "raytracer/tracer/shading.h"

#include <algorithm>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// A column or row (a whole number) clamped to the image. A periodic one, from -1 to `count`, wraps around.
std::size_t within(Real place, int count, bool periodic) {
    const auto last = static_cast<Real>(count - 1);
    if (periodic && place < 0) return static_cast<std::size_t>(last);
    if (periodic && place > last) return 0;
    return place > 0 ? static_cast<std::size_t>(std::min(place, last)) : 0;
}

Color texel(const Texture& texture, Real column, Real row, const Periodic& periodic = {}) {
    const std::size_t index =
        3 * (within(row, texture.height, periodic.v) * static_cast<std::size_t>(texture.width) +
             within(column, texture.width, periodic.u));
    const auto color = [&](const auto& texels) {
        return Color(texels[index], texels[index + 1], texels[index + 2]);
    };
    return texture.deepTexels.empty() ? color(texture.texels) / Real(255)
                                      : color(texture.deepTexels) / Real(65535);
}

}  // namespace

Color lookUp(const Texture& texture, const Vec2& texCoord) {
    return texel(texture, std::floor(texCoord.x * static_cast<Real>(texture.width)),
                 std::floor((1 - texCoord.y) * static_cast<Real>(texture.height)));
}

Color lookUpBilinear(const Texture& texture, const Vec2& texCoord, const Periodic& periodic) {
    const Real x = texCoord.x * static_cast<Real>(texture.width) - Real(0.5);
    const Real y = (1 - texCoord.y) * static_cast<Real>(texture.height) - Real(0.5);
    const Real left = std::floor(x), top = std::floor(y);
    const auto row = [&](Real at) {
        return glm::mix(texel(texture, left, at, periodic), texel(texture, left + 1, at, periodic), x - left);
    };
    return glm::mix(row(top), row(top + 1), y - top);
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
