#include "raytracer/tracer/ray_tree.h"

#include <algorithm>

#include "raytracer/tracer/cutoff.h"

namespace raytracer {

std::span<const RayTreeNode> RayTrees::of(std::size_t point) const {
    const std::size_t begin = point == 0 ? 0 : ends[point - 1];
    return std::span(rays).subspan(begin, ends[point] - begin);
}

// `brightest` grows with the recursion that is left. A ray's throughput bound is at most its parent's, so the
// parent of a traced ray is traced too.
int leastRecursion(const RayTrees& trees, const RayTreeNode& ray, double cutoff) {
    if (ray.depth == 0) return 0;
    const auto& brightest = trees.brightest;
    const auto least = std::ranges::partition_point(
        brightest, [&](const auto& color) { return throughputBound(ray.weight, color) < cutoff; });
    return least == brightest.end() ? alwaysTerminated
                                    : ray.depth + static_cast<int>(least - brightest.begin());
}

}  // namespace raytracer
