#include "plane_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace raytracer {
namespace {

std::int64_t distance(const PlanePoint& a, const PlanePoint& b) {
    return std::abs(a.x - b.x) + std::abs(a.y - b.y);
}

__extension__ using WideInteger = __int128;

// Twice the signed area of the triangle.
WideInteger twiceArea(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return static_cast<WideInteger>(b.x - a.x) * (c.y - a.y) -
           static_cast<WideInteger>(b.y - a.y) * (c.x - a.x);
}

// Scales by the power of two that brings the largest coordinate into [1/2, 1). In two steps, since a double
// may not hold that power.
void scaleToUnit(std::vector<glm::dvec3>& points) {
    double largest = 0;
    for (const glm::dvec3& p : points)
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    int exponent = 0;
    std::frexp(largest, &exponent);
    const double half = std::ldexp(1.0, -exponent / 2), rest = std::ldexp(1.0, -exponent - -exponent / 2);
    for (glm::dvec3& p : points) p = p * half * rest;
}

bool areTogether(const PlanePoint& a, const PlanePoint& b) { return distance(a, b) <= 4; }

// Keeps the first of neighbours that lie together: the others hide how the outline turns there.
std::vector<PlanePoint> apart(std::span<const PlanePoint> polygon) {
    std::vector<PlanePoint> corners;
    std::ranges::unique_copy(polygon, std::back_inserter(corners), areTogether);
    while (corners.size() > 1 && areTogether(corners.back(), corners.front())) corners.pop_back();
    return corners;
}

bool isLess(const glm::dvec3& a, const glm::dvec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

}  // namespace

int sideOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    const WideInteger area = twiceArea(a, b, c);
    return (area > 0) - (area < 0);
}

int clearSideOf(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    // Each difference of two points is off by at most two units along each axis.
    const WideInteger area = twiceArea(a, b, c), roundings = 2 * (distance(a, b) + distance(a, c)) + 8;
    return (area > roundings) - (area < -roundings);
}

bool turnsBack(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return clearSideOf(a, b, c) == 0 && static_cast<WideInteger>(a.x - b.x) * (c.x - b.x) +
                                                static_cast<WideInteger>(a.y - b.y) * (c.y - b.y) >=
                                            0;
}

// Compares the rotations at two candidates. The candidate with the greater one moves on, behind all that was
// compared (Shiloach, Fast Canonization of Circular Strings, 1981).
std::size_t leastCorner(std::span<const glm::dvec3> corners) {
    const std::size_t count = corners.size();
    std::size_t first = 0, second = 1, same = 0;
    while (std::max(first, second) < count && same < count) {
        const glm::dvec3 &a = corners[(first + same) % count], &b = corners[(second + same) % count];
        if (a == b) {
            ++same;
            continue;
        }
        (isLess(b, a) ? first : second) += same + 1;
        second += first == second;
        same = 0;
    }
    return std::min(first, second);
}

std::vector<PlanePoint> projectPolygon(std::span<const glm::dvec3> corners) {
    std::vector<glm::dvec3> points(corners.begin(), corners.end());
    scaleToUnit(points);
    for (const glm::dvec3 origin = points[0]; glm::dvec3 & p : points) p -= origin;
    scaleToUnit(points);

    glm::dvec3 normal = glm::cross(points.back(), points.front());
    for (std::size_t i = 1; i < points.size(); ++i) normal += glm::cross(points[i - 1], points[i]);
    const glm::dvec3 size = glm::abs(normal);
    const int z = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    if (size[z] == 0) return {};
    const int x = (z + (normal[z] > 0 ? 1 : 2)) % 3, y = 3 - x - z;
    const auto along = [&](const glm::dvec3& p, int axis) {
        return std::llround(0x1p50 * (p[axis] - p[z] * (normal[axis] / normal[z])));
    };
    std::vector<PlanePoint> polygon;
    polygon.reserve(points.size());
    for (const glm::dvec3& p : points) polygon.push_back({along(p, x), along(p, y)});
    return polygon;
}

bool isConvex(std::span<const PlanePoint> polygon) {
    const std::size_t count = polygon.size();
    if (count < 3) return true;
    for (std::size_t i = 0; i < count; ++i) {
        const PlanePoint &before = polygon[(i + count - 1) % count], &here = polygon[i],
                         &after = polygon[(i + 1) % count];
        if (areTogether(here, after)) return isConvex(apart(polygon));
        // The second test finds a polygon that goes round more than once.
        if (clearSideOf(before, here, after) < 0 || clearSideOf(polygon[0], here, after) < 0) return false;
    }
    return true;
}

}  // namespace raytracer
