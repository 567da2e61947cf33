// A polygon of a mesh, projected onto a plane, in whole numbers: then the side of a line that a point is on
// is exact.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raytracer {

struct PlanePoint {
    std::int64_t x, y;  // at most 2^51
    bool operator==(const PlanePoint&) const = default;
};

// A total order of points.
inline bool isBefore(const PlanePoint& a, const PlanePoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// On which side of the line from a to b the point c lies: 1 left, -1 right, 0 on it. sideOf is exact;
// clearSideOf is 0 also where the side may be due to the roundings of projectPolygon.
int sideOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);
int clearSideOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

// Whether the way from a to b goes back along itself to c, up to the same roundings.
bool turnsBack(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

// The index of the corner with which the least of all rotations of this sequence begins. This corner does not
// depend on the one that comes first.
std::size_t leastCorner(std::span<const glm::dvec3> corners);

// The polygon seen along its Newell normal, counter-clockwise. In units of the result, the largest difference
// from the first corner along an axis of the mesh is 2^49 to 2^50. Each coordinate is off by less than a
// unit. Empty where the polygon has no normal.
std::vector<PlanePoint> projectPolygon(std::span<const glm::dvec3> corners);

// Whether it is convex, up to the roundings of projectPolygon. The first corner must be on the convex hull.
bool isConvex(std::span<const PlanePoint> polygon);

}  // namespace raytracer
