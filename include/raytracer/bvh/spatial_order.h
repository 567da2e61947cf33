// An order of points in which neighbours in space are near each other.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raytracer {

// The points' indices along a Morton curve (Morton 1966). The order is stable. Points must be finite.
std::vector<std::uint32_t> spatialOrder(std::span<const glm::vec3> points);

}  // namespace raytracer
