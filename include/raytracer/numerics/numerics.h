// Rounding errors and the arithmetic that is built to survive them. A tolerance that a picture depends on is
// here, or counts its roundings by gamma where they happen; trees, which only discard, have margins too.
//
// Every bound here is relative: a multiple of the unit roundoff of Real and of the magnitudes that went into
// a result. None is a length, so none prefers a unit of length.
//
// Sums and products. One operation gives fl(x op y) = (x op y)(1 + d), |d| <= u; n of them one after the
// other are wrong by gamma_n of the result (Higham, Accuracy and Stability of Numerical Algorithms,
// lemma 3.1), a sum by gamma_n of what its terms are without their signs. So a bound counts roundings. For M
// p + t with M and t rounded themselves and p right to three roundings: 1 + 3 for the factors, 1 for the
// product, 2 for the sum of the three, 1 for the sum with t, so gamma_8 |M||p| + gamma_2 |t|
// (Transform::pointError; after pbrt, "Managing Rounding Error"). In the same way: Transform::objectError,
// Shape::touches, closeChord, directLight, Mesh::toObject.
//
// Quadrics far from the ray's origin o. In b^2 - a c, with c = |o|^2 - 1, nearly all cancels: the errors are
// of |o|^2 u, the rest is of the order of 1. From the point of the line that is closest to the centre, b = 0
// and c is of the order of 1 wherever there is a hit, and what is left is the error of that point, |o| u
// (Haines, Gunther and Akenine-Moller, Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems,
// ch. 7). For sphere and cylinder from farSquared on, for the cone always, for each solid from distantSquared
// on (chord.h).
//
// Boxes, in float. The distance of a plane, (plane - origin) / direction, takes four roundings: of the
// direction, of its inverse, of the difference, of the product. Entry and exit are compared, each wrong by
// gamma_4, so one is to be made larger by (1 + gamma_4) / (1 - gamma_4) < 1 + 2^-20 (Ize, Robust BVH Ray
// Traversal, JCGT 2(2), 2013, who has three roundings and hence two units in the last place; as there, it
// costs nothing, being in the inverse: BvhTraversal::growth). The origin's rounding goes with its distance
// from zero, not with the plane's from it: it widens the origin (BvhRay::slack, bvh_prepare.h).
//
// Triangles. Which side of an edge the line passes by is found exactly, so that two triangles never disagree
// about the edge that they share: differenceOfProducts (Woop, Benthin and Wald, Watertight Ray/Triangle
// Intersection, JCGT 2(1), 2013).
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "raytracer/numerics/elementary.h"
#include "raytracer/numerics/packet_size.h"
#include "raytracer/numerics/types.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// u: the largest relative error of one correctly rounded operation.
inline constexpr Real unitRoundoff = std::numeric_limits<Real>::epsilon() / 2;
// Of a number that the scene's author wrote as a decimal: it has become a double.
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

// Two hits whose t differ by less than this factor might be one place where two surfaces coincide, so they
// are checked more closely (HitQuery). Half of the digits: far above the rounding error of any t that is
// worth its name, far below what a picture shows. It decides nothing but whether to check.
inline constexpr Real coincidenceWindow = 1 / powerOfTwo(std::numeric_limits<Real>::digits / 2);

// From this squared distance (in units of the shape) on, an origin is far from a quadric: nearer ones lose at
// most a fifth of the digits in the textbook's discriminant.
inline constexpr Real farSquared = powerOfTwo(std::numeric_limits<Real>::digits / 5);
// From this squared distance on, an origin is moved to the point of its line that is closest to the solid: the
// slack of closeChord, 16 units in the last place of the distance, is then still far below a pixel.
inline constexpr Real distantSquared = powerOfTwo(std::numeric_limits<Real>::digits * 3 / 4);
// A line passes a solid by where its closest point is more than this squared part of a move away from it.
inline constexpr Real passingSquared = powerOfTwo(std::numeric_limits<Real>::digits);

// The most that a hit may be wrong by, of the picture's width there (a pixel of 4096), and on a sphere,
// a cone or a cylinder's side of that one's size.
inline constexpr Real mostPositionError = 1 / powerOfTwo(12);
// A camera that is this many sizes of the shapes away sees them to within that part of their size; one whose
// rays are sums of numbers this many widths of its picture large, to that part of its width.
inline constexpr Real farthestEye = powerOfTwo(std::numeric_limits<Real>::digits) * mostPositionError;
// What a scene's numbers may be for Real to see it (buildScene). From the finest unit of a shape to the
// farthest point, so that the rounding error of a coordinate in either is a normal number; lengths that are
// squared are checked where they are (isSafeSquare). The brightest colour, so that an eighth of the
// exponents lets eight factors meet.
inline constexpr Real widestRange =
    powerOfTwo(std::numeric_limits<Real>::max_exponent - std::numeric_limits<Real>::digits);
inline constexpr Real brightestFactor = powerOfTwo(std::numeric_limits<Real>::max_exponent / 8);
// No ray's colour or weight is more: a thousand reflections that brighten would end in infinity, and black
// times that is no number.
inline constexpr Real brightestColor = powerOfTwo(std::numeric_limits<Real>::max_exponent / 2 - 1);

// The words in which a formula is written once for one ray and for several: a Real is a packet of one lane
// (ray_lanes.h has the same for Lanes). Comparisons of T give a Truth<T>, a choice is a select, and a branch
// is taken where any of the rays asks for it.
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
inline Real greatest(Real x) { return x; }  // of the lanes

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

// function(arguments), each ray's by itself: for what is rare, or has no form for several.
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
// Lanes that are not in use hold what the first one in use has, so that nothing out of the ordinary happens
// in them.
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
// What leaves the core. Extended's colours may be beyond double: no more than the products of two may be.
template <class T>
Vec3T<T> withinDouble(const Vec3T<T>& c) {
    return within(T(powerOfTwo(std::min(500, std::numeric_limits<Real>::max_exponent / 2 - 1))), c);
}
inline glm::dvec3 asDouble(const Color& c) { return glm::dvec3(withinDouble(c)); }
inline bool isBlack(const Color& c) { return c.x == 0 && c.y == 0 && c.z == 0; }

inline Mat3 abs(const Mat3& m) { return Mat3(abs(m[0]), abs(m[1]), abs(m[2])); }

// m v; and v m, the transposed matrix's product.
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
template <class T>
Vec3T<T> product(const Vec3T<T>& v, const Mat3& m) {
    return {m[0].x * v.x + m[0].y * v.y + m[0].z * v.z, m[1].x * v.x + m[1].y * v.y + m[1].z * v.z,
            m[2].x * v.x + m[2].y * v.y + m[2].z * v.z};
}

// Whether a sum of squares has lost no digits by under- or overflow, nor will products of it.
template <class T>
Truth<T> isSafeSquare(const T& squared) {
    constexpr Real small = std::numeric_limits<Real>::min() / (unitRoundoff * unitRoundoff);
    return (squared > T(small)) & (squared < T(1 / small));
}

// v / |v|, at any magnitude: where the squared length is not safe, v is first brought to the order of 1 by a
// power of two. The zero vector stays zero.
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

// x^n for x in [0, 1] and n >= 0, by squares for the digits of n before the binary point and square roots for
// those behind it: the same bits on every machine (libm's pow is not). The relative error is of the order of
// n units in the last place, as much as half a unit in x makes.
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

// a * b - c * d with the exact sign, unless a product underflows: rounding is monotone, so unequal rounded
// products are in the order of the exact ones; where they are equal, their rounding errors, exact by fma, are
// all of the difference. The exact fallback is Woop, Benthin and Wald's (section 3.3), who have the next
// larger type for it: there is none for every Real.
inline Real differenceOfProducts(Real a, Real b, Real c, Real d) {
    const Real ab = a * b, cd = c * d;
    if (ab != cd) return ab - cd;
    return std::fma(a, b, -ab) - std::fma(c, d, -cd);
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
