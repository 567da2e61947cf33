#include "raytracer/tracer/followed_rays.h"

#include <algorithm>
#include <cmath>

namespace raytracer {

std::span<const FollowedRay> FollowedRays::of(std::size_t pixel) const {
    const std::size_t begin = pixel == 0 ? 0 : ends[pixel - 1];
    return std::span(rays).subspan(begin, ends[pixel] - begin);
}

// As Scene::isWorthCasting has it.
static bool isWorthIt(const FollowedRay& ray, const glm::dvec3& brightest, double cutoff) {
    return std::abs(ray.weight.x) * brightest.x >= cutoff || std::abs(ray.weight.y) * brightest.y >= cutoff ||
           std::abs(ray.weight.z) * brightest.z >= cutoff;
}

// A ray that is worth it comes from one that was, since it can change no more; with more max_recursion left
// it can change no less.
int followedFrom(const FollowedRays& followed, const FollowedRay& ray, double cutoff) {
    if (ray.depth == 0) return 0;
    const auto& brightest = followed.brightest;
    const auto least = std::ranges::partition_point(
        brightest, [&](const auto& each) { return !isWorthIt(ray, each, cutoff); });
    return least == brightest.end() ? neverFollowed : ray.depth + static_cast<int>(least - brightest.begin());
}

PixelAndRays shallower(const FollowedRays& followed, std::size_t pixel, int max_recursion, double cutoff) {
    const auto isFollowed = [&](const FollowedRay& ray) {
        const int left = max_recursion - ray.depth;
        return ray.depth == 0 ||
               (left >= 0 && isWorthIt(ray, followed.brightest[static_cast<std::size_t>(left)], cutoff));
    };
    PixelAndRays result;
    for (const FollowedRay& ray : followed.of(pixel))
        if (isFollowed(ray)) {
            result.color += ray.light;
            result.rays += 1 + ray.shadows;
        }
    return result;
}

}  // namespace raytracer
