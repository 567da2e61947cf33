// A polygon of a mesh in a plane, in whole numbers, so that what is left or right of what is exact.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raytracer {

struct PlanePoint {
    std::int64_t x, y;  // at most 2^51
    bool operator==(const PlanePoint&) const = default;
};

// Any order of points.
inline bool isBefore(const PlanePoint& a, const PlanePoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// On which side of the line from a to b the point c lies: 1 left, -1 right, 0 on it; exactly, or but for the
// roundings of projectPolygon.
int sideOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);
int clearSideOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

// The corner with which the least of all rotations of this sequence begins: one that does not depend on the
// corner that comes first.
std::size_t leastCorner(std::span<const glm::dvec3> corners);

// The polygon seen along its Newell normal, counter-clockwise, with 2^49 to 2^50 units for its longest extent
// along an axis. Each coordinate is off by less than a unit. Empty where the polygon has no normal.
std::vector<PlanePoint> projectPolygon(std::span<const glm::dvec3> corners);

// But for the roundings of projectPolygon. The first corner must be one of the convex hull.
bool isConvex(std::span<const PlanePoint> polygon);

}  // namespace raytracer
