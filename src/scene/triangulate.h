// Cuts polygons that are not convex into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raytracer {

// The n - 2 triangles, as indices of corners, that together cover the polygon and nothing else. They do not
// depend on the corner that comes first. Nothing for a convex polygon. One that crosses itself gets some
// triangles. Takes time of about n log n.
std::vector<std::array<std::uint32_t, 3>> triangulateConcave(std::span<const glm::dvec3> corners);

}  // namespace raytracer
