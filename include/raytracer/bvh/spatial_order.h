// An order in which what is near in space is near in the order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raytracer {

// The points' indices along a Morton curve (Morton 1966): of equal ones the first stays first. Points must be
// finite.
std::vector<std::uint32_t> spatialOrder(std::span<const glm::vec3> points);

}  // namespace raytracer
