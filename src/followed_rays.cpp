#include "raytracer/followed_rays.h"

#include <algorithm>

#include <glm/common.hpp>

namespace raytracer {

std::span<const FollowedRay> FollowedRays::of(std::size_t pixel) const {
    const std::size_t begin = pixel == 0 ? 0 : ends[pixel - 1];
    return std::span(rays).subspan(begin, ends[pixel] - begin);
}

PixelAndRays shallower(const FollowedRays& followed, std::size_t pixel, int max_recursion, double cutoff) {
    // As Scene::isWorthCasting has it. A ray that is worth it comes from one that was, since it can change no more.
    const auto isCast = [&](const FollowedRay& ray) {
        if (ray.depth == 0) return true;
        if (ray.depth > max_recursion) return false;
        const glm::dvec3 most = glm::abs(ray.weight) * followed.brightest[static_cast<std::size_t>(max_recursion - ray.depth)];
        return std::max({most.x, most.y, most.z}) >= cutoff;
    };
    PixelAndRays result;
    for (const FollowedRay& ray : followed.of(pixel)) {
        if (!isCast(ray)) {
            result.isWhole = false;
            continue;
        }
        result.color += ray.light;
        result.rays += 1 + ray.shadows;
    }
    return result;
}

}  // namespace raytracer
