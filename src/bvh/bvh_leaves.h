// The part of bvh_kernel.cpp that tests leaves: balls, and triangles eight at a time. Only that file includes
// it.
#pragma once

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "raytracer/bvh/bvh.h"
#include "raytracer/numerics/lanes.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {
namespace {

using FloatLanes = LanesOf<float>;

// Of the children that are balls, those that the ray's line might hit: |c|^2 |d|^2 - (c.d)^2 <= r^2 |d|^2,
// with c the vector to the centre. The error of the left side is at most 14 roundings of |c|^2 |d|^2. That of
// c is at most four roundings of |c| + |origin|. The part relative to |origin| is added to r (ballMargin);
// the part relative to |c| changes the square in its seventh digit only. The radius r is half of the box's
// largest side, enlarged by 2^-6: a ball around the box's middle, which need not be the centre of the ball
// itself, must be up to 2^-7 larger.
inline LaneBits hitBalls(const BvhTraversal& s, const BvhNode& node) {
    FloatLanes squared = 0, along = 0, radius = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto low = FloatLanes::load(node.planes[2 * axis]),
                   high = FloatLanes::load(node.planes[2 * axis + 1]);
        const FloatLanes toCenter = (low + high) * 0.5f - s.ballOrigin[axis];
        squared = toCenter * toCenter + squared;
        along = toCenter * s.ballDirection[axis] + along;
        radius = max(radius, high - low);
    }
    float length = 0;  // of the direction, squared
    for (int axis = 0; axis < 3; ++axis) length += s.ballDirection[axis] * s.ballDirection[axis];
    radius = radius * (0.5f * (1 + 0x1p-6f)) + s.ballMargin;
    const FloatLanes reach = (radius * radius + squared * 0x1p-20f) * length;
    return ~bits(reach < squared * length - along * along);
}

// A block's triangles seen along the line (sheared as in Woop, Benthin and Wald, Watertight Ray/Triangle
// Intersection, 2013), in steps of the block's grid. Every corner is within 2^17 of the line, because the
// line passes through the block's box.
struct SeenTriangles {
    double scale, depth;  // grid steps per unit; the line's start above the block's base, in steps
    FloatLanes x[3], y[3];
};

[[gnu::always_inline]] inline SeenTriangles seen(const BvhTraversal& s, const BvhBlock& block,
                                                 const std::uint16_t* grid) {
    SeenTriangles seen;
    seen.scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + block.exponent) << 52);
    const auto start = [&](std::uint32_t axis) {
        return (s.origin[axis] - static_cast<double>(block.base[axis])) * seen.scale;
    };
    seen.depth = start(s.z);
    const FloatLanes centerX = static_cast<float>(start(s.x) - s.shearX * seen.depth);
    const FloatLanes centerY = static_cast<float>(start(s.y) - s.shearY * seen.depth);
    const FloatLanes shearX = static_cast<float>(s.shearX), shearY = static_cast<float>(s.shearY);
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const auto along = [&](std::uint32_t axis) {
            return integers(grid + (std::size_t{3} * corner + axis) * block.count);
        };
        const FloatLanes z = along(s.z);
        seen.x[corner] = along(s.x) - multiplyAdd(shearX, z, centerX);
        seen.y[corner] = along(s.y) - multiplyAdd(shearY, z, centerY);
    }
    return seen;
}

// The edge function: the signed distance of the line from the edge from corner a to corner b, times the
// edge's length.
inline FloatLanes edge(const SeenTriangles& t, int a, int b) {
    return multiplySubtract(t.x[b], t.y[a], t.y[b] * t.x[a]);
}

// The error of a coordinate, in steps: half a step of the grid in itself and half in the depth, roundings (of
// numbers below 2^18, so less than 1/16 in all), and the error of the hit itself.
inline float coordinateError(const BvhTraversal& s, const SeenTriangles& t) {
    return static_cast<float>(1.07 + 2 * s.slack * t.scale);
}

// The triangles that a ray's line surely misses. NaN (an overflow) is not a miss.
inline LaneBits missedByRay(const BvhTraversal& s, const SeenTriangles& t) {
    // e: the error of a coordinate. That of the products is 4 e 2^17 + 2 e^2, and their own roundings, 2^12
    // at most.
    const float e = coordinateError(s, t), error = e * (0x1p19f * 1.01f + 4 * e);
    const FloatLanes u = edge(t, 1, 2), v = edge(t, 2, 0), w = edge(t, 0, 1);
    const FloatLanes least = min(u, min(v, w)), most = max(u, max(v, w));
    return bits(least < -error) & bits(error < most);
}

// The triangles that all of a beam's lines surely miss. A line differs from the middle one by up to `beside`
// at the block's base. This moves all three corners alike, so it counts only in proportion to an edge's
// length. On its way through the block the line differs by up to `parting` more.
inline LaneBits missedByBeam(const BvhTraversal& s, const SeenTriangles& t) {
    const auto beside =
        static_cast<float>((s.originHalf * t.scale + s.shearHalf * std::abs(t.depth)) * (1 + 0x1p-20));
    const auto parting = static_cast<float>(s.shearHalf * 0x1p16 * (1 + 0x1p-20)) + coordinateError(s, t);
    const FloatLanes rest = parting * (4 * beside + 2 * parting) + 0x1p13f;
    FloatLanes size[3];
    for (int corner = 0; corner < 3; ++corner) size[corner] = abs(t.x[corner]) + abs(t.y[corner]);
    FloatLanes least = std::numeric_limits<float>::infinity(), most = -least;
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3;
        const FloatLanes length = abs(t.x[a] - t.x[b]) + abs(t.y[a] - t.y[b]);
        const FloatLanes error = multiplyAdd(beside, length, multiplyAdd(parting, size[a] + size[b], rest));
        const FloatLanes passes = edge(t, a, b);
        least = min(passes + error, least);
        most = max(passes - error, most);
    }
    return bits(least < 0) & bits(most > 0);
}

inline bool findTriangles(BvhTraversal& s, const std::uint32_t* words) {
    BvhBlock block;
    std::memcpy(&block, words, sizeof block);
    const std::uint32_t* primitives = words + BvhBlock::words;
    const auto triangles = seen(s, block, reinterpret_cast<const std::uint16_t*>(primitives + block.count));
    const LaneBits missed = s.isBeam ? missedByBeam(s, triangles) : missedByRay(s, triangles);
    LaneBits hits = ((1u << block.count) - 1) & ~missed;
    s.foundCount = 0;
    for (; hits != 0; hits &= hits - 1) s.found[s.foundCount++] = primitives[std::countr_zero(hits)];
    return s.foundCount != 0;
}

}  // namespace
}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
