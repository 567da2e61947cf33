#include "raytracer/followed_rays.h"

#include <algorithm>

#include <glm/common.hpp>

namespace raytracer {

std::span<const FollowedRay> FollowedRays::of(std::size_t pixel) const {
    const std::size_t begin = pixel == 0 ? 0 : ends[pixel - 1];
    return std::span(rays).subspan(begin, ends[pixel] - begin);
}

PixelAndRays shallower(const FollowedRays& followed, std::size_t pixel, int max_recursion, double cutoff) {
    const auto isCast = [&](const FollowedRay& ray) {  // as Scene::isWorthCasting has it
        if (ray.depth > max_recursion) return false;
        const glm::vec3 most = glm::abs(ray.weight) * followed.brightest[static_cast<std::size_t>(max_recursion - ray.depth)];
        return static_cast<double>(std::max({most.x, most.y, most.z})) >= cutoff;
    };
    const std::span<const FollowedRay> rays = followed.of(pixel);
    PixelAndRays result;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i > 0 && !isCast(rays[i])) {
            i += rays[i].descendants;
            result.isWhole = false;
            continue;
        }
        result.color += glm::dvec3(rays[i].light);
        result.rays += 1 + rays[i].shadows;
    }
    return result;
}

}  // namespace raytracer
