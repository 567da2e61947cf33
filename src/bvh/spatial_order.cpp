#include "raytracer/bvh/spatial_order.h"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

namespace raytracer {
namespace {

constexpr int bitsOfAxis = 10, bitsOfPass = 10, passes = 3;

// abc -> a00b00c
std::uint32_t spread(std::uint32_t bits) {
    bits = (bits | bits << 16) & 0x030000ff;
    bits = (bits | bits << 8) & 0x0300f00f;
    bits = (bits | bits << 4) & 0x030c30c3;
    return (bits | bits << 2) & 0x09249249;
}

struct Coded {
    std::uint32_t code, point;
};

std::vector<Coded> coded(std::span<const glm::vec3> points) {
    glm::vec3 low = points[0], high = low;
    for (const glm::vec3& p : points) low = glm::min(low, p), high = glm::max(high, p);
    const glm::vec3 half = high / 2.f - low / 2.f;  // a difference may overflow
    std::vector<Coded> all;
    all.reserve(points.size());
    for (const glm::vec3& p : points) {
        std::uint32_t code = 0;
        for (int axis = 0; axis < 3; ++axis) {
            constexpr float cells = 1 << bitsOfAxis;
            const float place = half[axis] > 0 ? (p[axis] / 2 - low[axis] / 2) / half[axis] * cells : 0;
            code |= spread(static_cast<std::uint32_t>(std::clamp(place, 0.f, cells - 1))) << axis;
        }
        all.push_back({code, static_cast<std::uint32_t>(all.size())});
    }
    return all;
}

}  // namespace

// A radix sort, from the least significant digit on.
std::vector<std::uint32_t> spatialOrder(std::span<const glm::vec3> points) {
    if (points.empty()) return {};
    std::vector<Coded> order = coded(points), sorted(points.size());
    for (int pass = 0; pass < passes; ++pass) {
        const auto digit = [&](const Coded& of) {
            return of.code >> pass * bitsOfPass & ((1u << bitsOfPass) - 1);
        };
        std::vector<std::uint32_t> place((1u << bitsOfPass) + 1, 0);
        for (const Coded& one : order) ++place[digit(one) + 1];
        std::partial_sum(place.begin(), place.end(), place.begin());
        for (const Coded& one : order) sorted[place[digit(one)]++] = one;
        order.swap(sorted);
    }
    std::vector<std::uint32_t> result;
    result.reserve(order.size());
    for (const Coded& one : order) result.push_back(one.point);
    return result;
}

}  // namespace raytracer
