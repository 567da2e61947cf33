// The part of bvh_kernel.cpp that prepares a ray or a beam for a traversal. Only that file includes it.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "raytracer/bvh/bvh.h"
#include "raytracer/numerics/lane_registers.h"
#include "raytracer/numerics/vector4.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {
namespace {

constexpr double roundoff = 0x1p-24;  // of float

// The traversal of a ray from farther away than this, in the tree's frame, would overflow.
constexpr double largestOrigin = 0x1p60;

// The least component of a normalised direction: with it the inverse is finite, and 0 * infinity = NaN cannot
// occur. The ray turns a little by that, for which the origin's box is enlarged.
constexpr double leastDirection = 0x1p-40;

// A beam that may meet more primitives than this is slower than its rays one by one (Notes.txt).
constexpr double manyPrimitives = 128;

// Operations on three axes' numbers; the fourth is not used.
inline Double4 lesser(Double4 a, Double4 b) { return a < b ? a : b; }
inline Double4 greater(Double4 a, Double4 b) { return a > b ? a : b; }
inline Long4 signBits() { return Long4{} + std::numeric_limits<std::int64_t>::min(); }
inline Double4 magnitude(Double4 x) {
    return reinterpret_cast<Double4>(reinterpret_cast<Long4>(x) & ~signBits());
}
inline Double4 withSign(Double4 x, Long4 sign) {
    return reinterpret_cast<Double4>(reinterpret_cast<Long4>(x) | sign);
}
inline double greatest(Double4 x) { return std::max(x[0], std::max(x[1], x[2])); }

// A beam in the tree's frame: a box of the rays' origins, and for each axis the least and the greatest
// magnitude of their directions, and the sign, which is the same for all. A single ray has equal low and
// high, least and most.
struct FrameBeam {
    Double4 low, high, least, most;
    Long4 sign;
};

// Sets the numbers for the distances of a node's planes. At the planes that the rays enter by, the least t is
// that of the nearest origin and the fastest direction. At those that they leave by, the greatest t is that
// of the farthest origin and the slowest direction. (Where such a t is negative another one is greater, but
// then the box is behind.) `margin`: how much to enlarge the box of origins.
[[gnu::always_inline]] inline void setSlabs(BvhTraversal& s, const FrameBeam& beam, double tScale,
                                            Double4 margin) {
    const Double4 atLeast = Double4{} + leastDirection;
    const Double4 fastest = withSign(greater(beam.most * (1 / tScale), atLeast), beam.sign);
    const Double4 slowest = withSign(greater(beam.least * (1 / tScale), atLeast), beam.sign);
    const Double4 ahead = beam.sign != Long4{} ? beam.low : beam.high,
                  behind = beam.sign != Long4{} ? beam.high : beam.low;
    const Double4 signedMargin = withSign(margin, beam.sign);
    const Float4 inverse = 1 / __builtin_convertvector(fastest, Float4);
    const Float4 farInverse = 1 / __builtin_convertvector(slowest, Float4) * BvhTraversal::growth;
    const auto put = [](auto& to, const auto& from) { std::memcpy(to, &from, sizeof from); };
    put(s.nearInverse, inverse);
    put(s.farInverse, farInverse);
    put(s.nearOffset, __builtin_convertvector(ahead + signedMargin, Float4) * inverse);
    put(s.farOffset, __builtin_convertvector(behind - signedMargin, Float4) * farInverse);
    for (std::uint32_t axis = 0; axis < 3; ++axis) s.nearPlane[axis] = 2 * axis + (beam.sign[axis] != 0);
}

// Returns the factor from the beam's t to the traversal's, or 0 where the tree cannot be used.
[[gnu::always_inline]] inline double prepareInFrame(BvhTraversal& s, const BvhFrame& frame,
                                                    const FrameBeam& beam, double slack) {
    // A NaN makes the comparisons below false; where one would ignore it, the sum `all` is NaN.
    const Double4 distance = greater(magnitude(beam.low), magnitude(beam.high));
    const double longest = greatest(beam.most), farthest = greatest(distance);
    const Double4 every = magnitude(beam.low) + magnitude(beam.high) + beam.least + beam.most;
    const double all = every[0] + every[1] + every[2];
    s.slack = slack * frame.scale;
    if (!(all - all == 0 && farthest <= largestOrigin && longest >= 0x1p-1000 && longest <= 0x1p1000 &&
          s.slack <= largestOrigin))
        return 0;

    // A power of two scales the direction, so that its largest component is in [1, 2).
    const double tScale = std::bit_cast<double>(std::bit_cast<std::uint64_t>(longest) >> 52 << 52);
    // The slack; four times the effect of leastDirection; four roundings of the origin: its own, that of
    // origin times inverse, that of plane times inverse where multiplyAdd rounds twice, and one to spare.
    const double spread = s.slack + 0x1p-38 * (farthest + frame.extent * frame.scale);
    setSlabs(s, beam, tScale, spread + 4 * roundoff * distance);
    if (frame.balls) s.ballMargin = static_cast<float>(spread + 0x1p-19 * farthest);
    return tScale;
}

// For triangles: chooses the axes, and computes the line's origin and shears.
inline void shearLine(BvhTraversal& s, Double4 origin, Double4 way, Double4 size) {
    std::memcpy(s.origin, &origin, sizeof origin);
    s.z = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
    s.x = s.z == 2 ? 0 : s.z + 1;
    s.y = s.z == 0 ? 2 : s.z - 1;
    const double perZ = 1 / way[s.z];
    s.shearX = way[s.x] * perZ;
    s.shearY = way[s.y] * perZ;
}

// The same for a beam's middle line. The other lines have shears within shearHalf of its shears, and origins
// within originHalf of its origin.
inline void shearBeam(BvhTraversal& s, const FrameBeam& beam) {
    const Double4 middle = (beam.least + beam.most) * 0.5, half = (beam.most - beam.least) * 0.5;
    const Double4 apart = (beam.high - beam.low) * 0.5;
    shearLine(s, (beam.low + beam.high) * 0.5, withSign(middle, beam.sign), middle);
    // The error of a / b, with errors da and db: (da + |a / b| db) / (b - db).
    const double slowest = 1 / (beam.least[s.z] * (1 - 0x1p-40));
    const double shear = std::max(std::abs(s.shearX), std::abs(s.shearY));
    s.shearHalf = (std::max(half[s.x], half[s.y]) + shear * half[s.z]) * slowest;
    // A difference in depth moves the line by the shear times that.
    s.originHalf = std::max(apart[s.x], apart[s.y]) + (shear + s.shearHalf) * apart[s.z];
}

// BvhKernel::prepareRay and prepareBeam.

inline double prepareRay(BvhTraversal& s, const BvhFrame& frame, const BvhRay& ray) {
    const Double4 center{frame.center.x, frame.center.y, frame.center.z, 0};
    const Double4 origin = (Double4{ray.origin.x, ray.origin.y, ray.origin.z, 0} - center) * frame.scale;
    const Double4 way = Double4{ray.direction.x, ray.direction.y, ray.direction.z, 0} * frame.scale,
                  size = magnitude(way);
    const FrameBeam beam{origin, origin, size, size, reinterpret_cast<Long4>(way) & signBits()};
    const double tScale = prepareInFrame(s, frame, beam, ray.slack);
    s.isBeam = false;
    s.balls = frame.balls;
    if (frame.balls) {
        const Float4 ballOrigin = __builtin_convertvector(origin, Float4);
        const Float4 ballDirection = __builtin_convertvector(way * (1 / tScale), Float4);
        std::memcpy(s.ballOrigin, &ballOrigin, sizeof ballOrigin);
        std::memcpy(s.ballDirection, &ballDirection, sizeof ballDirection);
    }
    if (frame.triangles) shearLine(s, origin, way, size);
    return tScale;
}

inline double prepareBeam(BvhTraversal& s, const BvhFrame& frame, const BvhBeam& beam) {
    const Double4 center{frame.center.x, frame.center.y, frame.center.z, 0};
    const auto load = [](const double(&from)[4]) {
        Double4 result;
        std::memcpy(&result, from, sizeof result);
        return result;
    };
    const Double4 low = (load(beam.originLow) - center) * frame.scale,
                  high = (load(beam.originHigh) - center) * frame.scale;
    const Double4 wayLow = load(beam.directionLow) * frame.scale,
                  wayHigh = load(beam.directionHigh) * frame.scale;
    const Long4 sign = reinterpret_cast<Long4>(wayLow) & signBits();
    const Long4 parting = (reinterpret_cast<Long4>(wayHigh) & signBits()) ^ sign;
    if ((parting[0] | parting[1] | parting[2]) != 0) return 0;
    const Double4 a = magnitude(wayLow), b = magnitude(wayHigh);
    const FrameBeam inFrame{low, high, lesser(a, b), greater(a, b), sign};

    // An estimate: of primitives spread evenly over a surface across the tree's frame, the beam hits the
    // fraction that its cross section at the frame's far end is of the frame's cross section.
    const double extent = frame.extent * frame.scale, longest = greatest(inFrame.most);
    const double reach = greatest(magnitude(low)) + extent;
    const double width =
        greatest(high - low) * longest + greatest(wayHigh - wayLow) * reach;  // times longest
    if (!(width * width * static_cast<double>(frame.count) <=
          manyPrimitives * 4 * extent * extent * longest * longest))
        return 0;
    const double tScale = prepareInFrame(s, frame, inFrame, beam.slack);
    s.isBeam = true;
    s.balls = false;
    if (frame.triangles) shearBeam(s, inFrame);
    return tScale;
}

}  // namespace
}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
