// The part of bvh_kernel.cpp, which alone includes it, that looks at leaves: balls, and triangles eight at a
// time.
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

// Of the children that are balls, those that the ray's line might meet: |c|^2 |d|^2 - (c.d)^2 <= r^2 |d|^2
// with c the way to the centre. The left side is wrong by 14 roundings of |c|^2 |d|^2, c itself by four of
// |c| + |origin|, which r is made larger by: what is relative to |c| only matters to the square's seventh
// digit. The radius, half the box, is at most 2^-7 less than what a ball around the box's middle needs, which
// is not the ball's own.
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

// A block's triangles seen along the line (sheared as by Woop, Benthin and Wald, Watertight Ray/Triangle
// Intersection, 2013), on the block's grid, where every corner is within 2^17 of the line because the line
// passes through the block's box.
struct SeenTriangles {
    double scale, depth;  // of the grid; of the line's start above the block's base
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

// How far the line passes by the edge from corner a to corner b, times its length.
inline FloatLanes edge(const SeenTriangles& t, int a, int b) {
    return multiplySubtract(t.x[b], t.y[a], t.y[b] * t.x[a]);
}

// A coordinate is wrong by e: half a step of the grid in it and half in the depth, roundings (of numbers
// below 2^18, so less than 1/16 in all), and what the hit itself may be off by.
inline float coordinateError(const BvhTraversal& s, const SeenTriangles& t) {
    return static_cast<float>(1.07 + 2 * s.slack * t.scale);
}

// Those of the triangles that a ray's line is surely outside of. NaN (an overflow) is not.
inline LaneBits missedByRay(const BvhTraversal& s, const SeenTriangles& t) {
    // The products' error is 4 e 2^17 + 2 e^2, and their own roundings, 2^12 at most.
    const float e = coordinateError(s, t), error = e * (0x1p19f * 1.01f + 4 * e);
    const FloatLanes u = edge(t, 1, 2), v = edge(t, 2, 0), w = edge(t, 0, 1);
    const FloatLanes least = min(u, min(v, w)), most = max(u, max(v, w));
    return bits(least < -error) & bits(error < most);
}

// Those that all of a beam's lines are surely outside of. They run beside its middle: by up to `beside` where
// they pass the block's base, which moves all three corners alike and so counts by an edge's length only, and
// by up to `parting` more on their way through the block.
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
