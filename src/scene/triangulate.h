// Polygons that are not convex, cut into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raytracer {

// The n - 2 triangles, as numbers of corners, that together cover the polygon and nothing else; which ones
// does not depend on the corner that comes first. Nothing for a convex polygon. One that crosses itself gets
// some triangles. Time about n log n.
std::vector<std::array<std::uint32_t, 3>> triangulateConcave(std::span<const glm::dvec3> corners);

}  // namespace raytracer
