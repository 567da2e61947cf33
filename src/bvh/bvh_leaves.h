// The part of bvh_kernel.cpp, which alone includes it, that looks at leaves: balls, and triangles eight at a
// time.
#pragma once

#include <bit>
#include <cmath>
#include <cstring>

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

// The triangles of a block that the ray's line might meet: those of which it is not surely outside an edge.
// Seen along the ray (sheared as by Woop, Benthin and Wald, Watertight Ray/Triangle Intersection, 2013), on
// the block's grid, where every corner is within 2^17 of the line because the line passes through the block's
// box.
inline LaneBits hitTriangles(const BvhTraversal& s, const BvhBlock& block, const std::uint16_t* grid) {
    const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + block.exponent) << 52);
    const double depth = (s.origin[s.z] - static_cast<double>(block.base[s.z])) * scale;
    const double centerX = (s.origin[s.x] - static_cast<double>(block.base[s.x])) * scale - s.shearX * depth;
    const double centerY = (s.origin[s.y] - static_cast<double>(block.base[s.y])) * scale - s.shearY * depth;

    const FloatLanes cx = static_cast<float>(centerX), cy = static_cast<float>(centerY);
    const FloatLanes shearX = static_cast<float>(s.shearX), shearY = static_cast<float>(s.shearY);
    FloatLanes px[3], py[3];
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        const std::uint16_t* axes = grid + std::size_t{3} * corner * block.count;
        const FloatLanes z = integers(axes + std::size_t{s.z} * block.count);
        px[corner] = integers(axes + std::size_t{s.x} * block.count) - multiplyAdd(shearX, z, cx);
        py[corner] = integers(axes + std::size_t{s.y} * block.count) - multiplyAdd(shearY, z, cy);
    }
    const FloatLanes u = multiplySubtract(px[2], py[1], py[2] * px[1]);
    const FloatLanes v = multiplySubtract(px[0], py[2], py[0] * px[2]);
    const FloatLanes w = multiplySubtract(px[1], py[0], py[1] * px[0]);

    const unsigned all = (1u << block.count) - 1;
    // A coordinate is wrong by e: half a step of the grid in it and half in the depth, roundings (of numbers
    // below 2^18, so less than 1/16 in all), and what the hit itself may be off by. The products' error is
    // then 4 e 2^17 + 2 e^2 and their own roundings, 2^12 at most.
    const auto e = static_cast<float>(1.07 + 2 * s.slack * scale);
    if (!s.isBeam) {
        const float error = e * (0x1p19f * 1.01f + 4 * e);
        const FloatLanes least = min(u, min(v, w)), most = max(u, max(v, w));
        // NaN (an overflow) passes.
        return all & ~(bits(least < -error) & bits(error < most));
    }

    // A beam's lines run beside its middle: by up to `beside` where they pass the block's base, which moves
    // all three corners alike and so counts by an edge's length only, and by up to `parting` more on their
    // way through the block.
    const auto beside =
        static_cast<float>((s.originHalf * scale + s.shearHalf * std::abs(depth)) * (1 + 0x1p-20));
    const auto parting = static_cast<float>(s.shearHalf * 0x1p16 * (1 + 0x1p-20)) + e;
    const FloatLanes rest = parting * (4 * beside + 2 * parting) + 0x1p13f;
    FloatLanes size[3];
    for (int corner = 0; corner < 3; ++corner) size[corner] = abs(px[corner]) + abs(py[corner]);
    const auto errorOf = [&](int a, int b) {
        const FloatLanes edge = abs(px[a] - px[b]) + abs(py[a] - py[b]);
        return multiplyAdd(beside, edge, multiplyAdd(parting, size[a] + size[b], rest));
    };
    const FloatLanes errorU = errorOf(1, 2), errorV = errorOf(0, 2), errorW = errorOf(0, 1);
    const FloatLanes least = min(u + errorU, min(v + errorV, w + errorW)),
                     most = max(u - errorU, max(v - errorV, w - errorW));
    return all & ~(bits(least < 0) & bits(most > 0));
}

inline bool findTriangles(BvhTraversal& s, const std::uint32_t* words) {
    BvhBlock block;
    std::memcpy(&block, words, sizeof block);
    const std::uint32_t* primitives = words + BvhBlock::words;
    LaneBits hits = hitTriangles(s, block, reinterpret_cast<const std::uint16_t*>(primitives + block.count));
    s.foundCount = 0;
    for (; hits != 0; hits &= hits - 1) s.found[s.foundCount++] = primitives[std::countr_zero(hits)];
    return s.foundCount != 0;
}

}  // namespace
}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
