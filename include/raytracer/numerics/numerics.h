// Bounds on rounding errors, and arithmetic that keeps to them. A tolerance that a picture depends on is
// defined here, or counts its roundings with gamma where they happen. Trees only discard: their margins are
// their own.
//
// Every bound is relative: a multiple of Real's unit roundoff u and of the magnitudes that went into a
// result. None is a length, so none prefers a unit of length.
//
// Sums and products. One operation gives fl(x op y) = (x op y)(1 + d), |d| <= u. After n operations in a row
// the error is at most gamma_n times the result (Higham, Accuracy and Stability of Numerical Algorithms,
// lemma 3.1); that of a sum is at most gamma_n times the sum of its terms' magnitudes. So a bound counts
// roundings. For M p + t, with M and t rounded themselves and p right to three roundings: 1 + 3 for the
// factors, 1 for the product, 2 for the sum of three products, 1 for the sum with t, so gamma_8 |M||p| +
// gamma_2 |t| (Transform::pointError; after pbrt, "Managing Rounding Error"). The same is done in
// Transform::objectError, Mesh::touches, closeChord, directLight and Mesh::toObject.
//
// Quadrics far from the ray's origin o. In b^2 - a c, with c = |o|^2 - 1, nearly all digits cancel: its error
// is of the order of |o|^2 u, its value of the order of 1. At the line's point closest to the centre, b = 0,
// and c is of the order of 1 wherever there is a hit. What is left is the error of that point, |o| u (Haines,
// Gunther and Akenine-Moller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, ch. 7).
// Sphere and cylinder start from that point from farSquared on, the cone always, and every solid from
// distantSquared on (chord.h).
//
// Boxes, in float. The distance of a plane, (plane - origin) / direction, takes four roundings: of the
// direction, its inverse, the difference and the product. Entry and exit are compared, each with an error of
// gamma_4, so one must be enlarged by (1 + gamma_4) / (1 - gamma_4) < 1 + 2^-20 (Ize, Robust BVH Ray
// Traversal, JCGT 2(2), 2013, with three roundings and hence two units in the last place). As there, it costs
// nothing: the inverse includes it (BvhTraversal::growth). The rounding error of the origin is relative to
// its distance from zero, not to the plane's distance from it: it widens the origin (BvhRay::slack,
// bvh_prepare.h).
//
// Triangles. On which side of an edge the line passes is found exactly, so two triangles never disagree about
// the edge that they share: differenceOfProducts (Woop, Benthin and Wald, Watertight Ray/Triangle
// Intersection, JCGT 2(1), 2013).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "raytracer/numerics/elementary.h"
#include "raytracer/numerics/packet_size.h"
#include "raytracer/numerics/types.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// u: the largest relative error of one correctly rounded operation.
inline constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;
// The same for a number that the scene's author wrote as a decimal, which has become a double.
inline constexpr Real writtenRoundoff = std::max(unitRoundoff, static_cast<Real>(0x1p-53));
inline constexpr Real infinity = std::numeric_limits<Real>::infinity();

constexpr Real powerOfTwo(int exponent) {
    Real power = 1;
    for (; exponent > 0; --exponent) power *= 2;
    return power;
}

// gamma_n = n u / (1 - n u): the bound on the relative error of a product of n factors (1 + d), |d| <= u.
constexpr Real gamma(int n) {
    return static_cast<Real>(n) * unitRoundoff / (1 - static_cast<Real>(n) * unitRoundoff);
}

// Two hits whose t differ by less than this factor may be one point where two surfaces coincide, so they are
// examined more closely (HitQuery). Half of the digits: far above the rounding error of any useful t, far
// below what a picture shows. It decides only what to examine.
inline constexpr Real coincidenceWindow = 1 / powerOfTwo(std::numeric_limits<Real>::digits / 2);

// From this squared distance on (in units of the shape), an origin is far from a quadric. Nearer ones lose at
// most a fifth of the digits in the discriminant of the quadratic formula.
inline constexpr Real farSquared = powerOfTwo(std::numeric_limits<Real>::digits / 5);
// From this squared distance on, an origin is moved to the line's point that is closest to the solid. The
// slack of closeChord, 16 roundings of the distance, is still far below a pixel there.
inline constexpr Real distantSquared = powerOfTwo(std::numeric_limits<Real>::digits * 3 / 4);

// The largest error of a hit, relative to the picture's width at the hit: a pixel of 4096. On a sphere, a
// cone or a cylinder's side also relative to the shape's size.
inline constexpr Real mostPositionError = 1 / powerOfTwo(12);
// A camera may be this many sizes of the shapes away from them, and still sees them to within
// mostPositionError of their size. Its rays may be sums of numbers this many widths of its picture large, and
// are still right to within mostPositionError of that width.
inline constexpr Real farthestEye = powerOfTwo(std::numeric_limits<Real>::digits) * mostPositionError;
// Limits for a scene's numbers to fit Real (buildScene). widestRange: from the finest unit of a shape to the
// farthest point, so that the rounding error of a coordinate in either unit is a normal number. Lengths that
// are squared are checked at that place (isSafeSquare). brightestFactor: the brightest colour. It has an
// eighth of the exponents, so a product of eight factors does not overflow.
inline constexpr Real widestRange =
    powerOfTwo(std::numeric_limits<Real>::max_exponent - std::numeric_limits<Real>::digits);
inline constexpr Real brightestFactor = powerOfTwo(std::numeric_limits<Real>::max_exponent / 8);
// Rays' colours and weights are clamped to this. A thousand reflections with factors above 1 would end in
// infinity, and infinity times black is NaN.
inline constexpr Real brightestColor = powerOfTwo(std::numeric_limits<Real>::max_exponent / 2 - 1);

// The functions with which a formula is written once for one ray and for several: a Real is a packet of one
// lane (ray_lanes.h has the same for Lanes). A comparison of two T gives a Truth<T>, `select` chooses by one,
// and a branch is taken where any of the lanes needs it.
template <class T>
using Truth = decltype(std::declval<T>() < std::declval<T>());
inline bool any(bool truth) { return truth; }
inline bool all(bool truth) { return truth; }
inline Real select(bool truth, Real yes, Real no) { return truth ? yes : no; }
inline Real sqrt(Real x) { return std::sqrt(x); }
inline Real abs(Real x) { return std::abs(x); }
inline Real copysign(Real magnitude, Real sign) { return std::copysign(magnitude, sign); }
inline Real max(Real a, Real b) { return std::max(a, b); }
inline Real min(Real a, Real b) { return std::min(a, b); }
inline Real greatest(Real x) { return x; }  // of all lanes
inline std::array<std::int32_t, 1> truncated(Real x) { return {static_cast<std::int32_t>(x)}; }

template <class T>
inline constexpr int laneCountOf = 1;
template <int n, class T>
inline constexpr int laneCountOf<glm::vec<n, T, glm::defaultp>> = laneCountOf<T>;
template <class T>
inline constexpr LaneBits allLanesOf = (LaneBits{1} << laneCountOf<T>)-1;

inline LaneBits bits(bool truth) { return truth; }
template <class T>
Truth<T> maskOf(LaneBits lanes) {
    if constexpr (laneCountOf<T> == 1) return lanes != 0;
    else return Truth<T>::ofBits(lanes);
}
template <class T>
unsigned countLanes(LaneBits lanes) {
    if constexpr (laneCountOf<T> == 1) return lanes;
    else return static_cast<unsigned>(std::popcount(lanes));
}
inline int firstLane(LaneBits lanes) { return std::countr_zero(lanes); }
template <class T, class Function>
void forEach(LaneBits lanes, Function function) {
    if constexpr (laneCountOf<T> == 1) {
        if (lanes != 0) function(0);
    } else {
        for (; lanes != 0; lanes &= lanes - 1) function(firstLane(lanes));
    }
}

inline Real laneOf(Real x, int) { return x; }
template <int n>
const glm::vec<n, Real, glm::defaultp>& laneOf(const glm::vec<n, Real, glm::defaultp>& v, int) {
    return v;
}
template <class V>
void setLane(V& to, int, const V& value) {
    to = value;
}

// Calls function(arguments) for each lane on its own: for what is rare, or has no form for several lanes.
template <class Result, class Function, class... Arguments>
Result laneByLane(Function function, const Arguments&... arguments) {
    if constexpr (laneCountOf<Result> == 1) {
        return function(arguments...);
    } else {
        Result result;
        for (int i = 0; i < laneCountOf<Result>; ++i) setLane(result, i, function(laneOf(arguments, i)...));
        return result;
    }
}

template <class T>
Vec3T<T> select(const Truth<T>& truth, const Vec3T<T>& yes, const Vec3T<T>& no) {
    return {select(truth, yes.x, no.x), select(truth, yes.y, no.y), select(truth, yes.z, no.z)};
}
// Lanes that are not in use get the number of the first one that is, so that nothing unusual happens in them.
inline Real filled(Real x, LaneBits) { return x; }
template <class T>
Vec3T<T> filled(const Vec3T<T>& v, LaneBits used) {
    return {filled(v.x, used), filled(v.y, used), filled(v.z, used)};
}

template <class T>
Vec3T<T> abs(const Vec3T<T>& v) {
    return {abs(v.x), abs(v.y), abs(v.z)};
}
template <class T>
T maxComponent(const Vec3T<T>& v) {
    return max(v.x, max(v.y, v.z));
}
template <class T>
Vec3T<T> within(const T& most, const Vec3T<T>& c) {
    return {max(min(c.x, most), -most), max(min(c.y, most), -most), max(min(c.z, most), -most)};
}
template <class T>
Vec3T<T> withinBrightest(const Vec3T<T>& c) {
    return within(T(brightestColor), c);
}
// Colours that leave the core. Those of extended precision may exceed double. Clamped so that even a product
// of four fits double.
template <class T>
Vec3T<T> withinDouble(const Vec3T<T>& c) {
    return within(T(powerOfTwo(std::min(250, std::numeric_limits<Real>::max_exponent / 2 - 1))), c);
}
inline glm::dvec3 asDouble(const Color& c) { return glm::dvec3(withinDouble(c)); }
inline bool isBlack(const Color& c) { return c.x == 0 && c.y == 0 && c.z == 0; }

inline Mat3 abs(const Mat3& m) { return Mat3(abs(m[0]), abs(m[1]), abs(m[2])); }

// m v.
template <class T>
Vec3T<T> product(const Mat3& m, const Vec3T<T>& v) {
    return {m[0].x * v.x + m[1].x * v.y + m[2].x * v.z, m[0].y * v.x + m[1].y * v.y + m[2].y * v.z,
            m[0].z * v.x + m[1].z * v.y + m[2].z * v.z};
}
// |m| |v|.
template <class T>
Vec3T<T> absoluteProduct(const Mat3& m, const Vec3T<T>& v) {
    return {abs(m[0].x * v.x) + abs(m[1].x * v.y) + abs(m[2].x * v.z),
            abs(m[0].y * v.x) + abs(m[1].y * v.y) + abs(m[2].y * v.z),
            abs(m[0].z * v.x) + abs(m[1].z * v.y) + abs(m[2].z * v.z)};
}
// v m: the transposed matrix's product.
template <class T>
Vec3T<T> product(const Vec3T<T>& v, const Mat3& m) {
    return {m[0].x * v.x + m[0].y * v.y + m[0].z * v.z, m[1].x * v.x + m[1].y * v.y + m[1].z * v.z,
            m[2].x * v.x + m[2].y * v.y + m[2].z * v.z};
}

// Whether a sum of squares, and products of it, lose no digits by under- or overflow.
template <class T>
Truth<T> isSafeSquare(const T& squared) {
    constexpr Real small = std::numeric_limits<Real>::min() / (unitRoundoff * unitRoundoff);
    return (squared > T(small)) & (squared < T(1 / small));
}

// v / |v| at any magnitude. Where the squared length is not safe, v is first scaled to the order of 1 by a
// power of two. Zero and infinite vectors give zero.
Vec3 normalizedOfAnySize(const Vec3& v);
template <class T>
Vec3T<T> normalized(const Vec3T<T>& v) {
    const T squared = glm::dot(v, v);
    if (all(isSafeSquare(squared))) return v * (1 / sqrt(squared));
    return laneByLane<Vec3T<T>>([](const Vec3& one) { return normalizedOfAnySize(one); }, v);
}
inline Vec3 normalizedOfAnySize(const Vec3& v) {
    const Real squared = glm::dot(v, v);
    if (isSafeSquare(squared)) return v * (1 / std::sqrt(squared));
    const Real largest = maxComponent(abs(v));
    if (!(largest > 0) || !(largest < infinity)) return Vec3(0);
    const int exponent = std::ilogb(largest);
    const Vec3 scaled(std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent));
    return scaled * (1 / std::sqrt(glm::dot(scaled, scaled)));
}

// x^n for x in [0, 1] and n >= 0: by squares for the bits of n before the binary point, by square roots for
// those behind it. Gives the same bits on every machine (libm's pow does not). The relative error is of the
// order of n units in the last place, as much as an error of half a unit in x causes.
template <class T>
T power(T x, Real n) {
    constexpr Real mostWhole = 16777216;  // 2^24: every such whole number is exact in every Real
    for (n = std::min(n, std::numeric_limits<Real>::max()); n > mostWhole; n /= 2) x *= x;
    const Real whole = std::floor(n);
    T result(1), square = x;
    for (auto digits = static_cast<unsigned>(whole); digits != 0; digits >>= 1) {
        if (digits & 1u) result *= square;
        square *= square;
    }
    for (Real fraction = n - whole; fraction > 0; fraction -= std::floor(fraction)) {
        fraction *= 2;
        x = sqrt(x);
        if (fraction >= 1) result *= x;
    }
    return result;
}

// a * b - c * d with the exact sign, unless a product underflows. Rounding is monotone, so products that
// differ after rounding have the order of the exact ones. Where they are equal, the difference is that of
// their rounding errors, which fma gives exactly. The exact fallback is Woop, Benthin and Wald's (section
// 3.3). They use the next larger type, which not every Real has.
inline Real differenceOfProducts(Real a, Real b, Real c, Real d) {
    const Real ab = a * b, cd = c * d;
    if (ab != cd) return ab - cd;
    return std::fma(a, b, -ab) - std::fma(c, d, -cd);
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
