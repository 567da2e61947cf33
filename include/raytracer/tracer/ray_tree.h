// The ray trees behind some points of the picture, with each ray's contribution. They give the colours for
// every smaller max_recursion and larger cutoff without tracing another ray.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raytracer {

struct RayTreeNode {
    glm::dvec3 light{0};        // of all lights at its hit, with the ambient terms, times the weight
    glm::dvec3 weight{1};       // throughput: the factor of the ray's colour in the point's colour
    std::uint16_t depth = 0;    // reflections and refractions before this ray
    std::uint32_t shadows = 0;  // shadow rays from its hit
};

// The trees of several points, traced with one max_recursion and one cutoff.
struct RayTrees {
    std::vector<RayTreeNode> rays;      // point by point, each tree's root first
    std::vector<std::size_t> ends;      // per point: the end of its tree in `rays`
    std::vector<glm::dvec3> brightest;  // upper bounds on a ray's colour, by the max_recursion it has left

    std::span<const RayTreeNode> of(std::size_t point) const;
};

// The smallest max_recursion at which a ray is traced with this cutoff; alwaysTerminated if there is none.
int leastRecursion(const RayTrees& trees, const RayTreeNode& ray, double cutoff);
inline constexpr int alwaysTerminated = std::numeric_limits<int>::max();

}  // namespace raytracer
