#include "raytracer/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string_view>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace raytracer {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr double roundoff = 0x1p-24;  // of float

// Boxes further out than this are not put into a tree: products of three of its lengths and a count stay finite.
constexpr float largestCoordinate = 0x1p40f;

// A ray from further out than this, in the tree's frame, would overflow.
constexpr double largestOrigin = 0x1p60;

// The least component of a normalised direction, so that its inverse is finite and 0 * infinity = NaN cannot occur. What it
// turns the ray by is allowed for in the origin's box.
constexpr double leastDirection = 0x1p-40;

InstructionSet chooseInstructionSet() {
    const char* name = std::getenv("RAYTRACER_SIMD");
    const std::string_view asked = name ? name : "";
    if (asked == "scalar") return InstructionSet::Scalar;
    if (isSupported(InstructionSet::Avx2) && asked != "sse2") return InstructionSet::Avx2;
    return isSupported(InstructionSet::Sse2) ? InstructionSet::Sse2 : InstructionSet::Scalar;
}

using Advance = bool (*)(BvhTraversal&, float limit);

}  // namespace

// The inner loop, once for each instruction set: bvh_kernel.inc, at the end of this file.
namespace scalar {
bool advance(BvhTraversal& state, float limit);
}
#if defined(__x86_64__)
namespace sse2 {
bool advance(BvhTraversal& state, float limit);
}
namespace avx2 {
bool advance(BvhTraversal& state, float limit);
}
#endif

namespace {

Advance advanceOf(InstructionSet set) {
#if defined(__x86_64__)
    if (set == InstructionSet::Avx2) return avx2::advance;
    if (set == InstructionSet::Sse2) return sse2::advance;
#endif
    return set == InstructionSet::Scalar ? scalar::advance : nullptr;
}

struct Chosen {
    InstructionSet set = chooseInstructionSet();
    Advance advance = advanceOf(set);
};
Chosen chosen;

}  // namespace

bool isSupported(InstructionSet set) {
#if defined(__x86_64__)
    return set != InstructionSet::Avx2 || (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"));
#else
    return set == InstructionSet::Scalar;
#endif
}

InstructionSet instructionSet() { return chosen.set; }

void setInstructionSet(InstructionSet set) { chosen = {set, advanceOf(set)}; }

float floatBelow(double x) {
    const float nearest = static_cast<float>(x);
    return static_cast<double>(nearest) > x ? std::nextafter(nearest, -infinite) : nearest;
}

float floatAbove(double x) { return -floatBelow(-x); }

bool Bvh::usable(const FloatBox& box) {
    bool result = true;
    for (int axis = 0; axis < 3; ++axis)  // false for NaN too
        result = result && box.low[axis] >= -largestCoordinate && box.high[axis] <= largestCoordinate;
    return result;
}

std::size_t Bvh::memory() const { return nodes_.capacity() * sizeof(BvhNode) + words_.capacity() * sizeof(words_[0]); }

BvhCursor::BvhCursor(const Bvh& bvh, const BvhRay& ray) {
    BvhTraversal& s = state_;
    double direction[3];
    for (int axis = 0; axis < 3; ++axis) {
        s.origin[axis] = (ray.origin[axis] - bvh.center_[axis]) * bvh.scale_;
        direction[axis] = ray.direction[axis] * bvh.scale_;
    }
    s.slack = ray.slack * bvh.scale_;
    const double sizeX = std::abs(direction[0]), sizeY = std::abs(direction[1]), sizeZ = std::abs(direction[2]);
    s.z = sizeX > sizeY ? (sizeX > sizeZ ? 0 : 2) : (sizeY > sizeZ ? 1 : 2);
    const double farthest = std::max(std::abs(s.origin[0]), std::max(std::abs(s.origin[1]), std::abs(s.origin[2])));

    // NaN compares false, or spreads through the sum where a comparison has passed it over.
    const double longest = std::abs(direction[s.z]), all = s.origin[0] + s.origin[1] + s.origin[2] + sizeX + sizeY + sizeZ;
    usable_ = farthest <= largestOrigin && longest >= 0x1p-1000 && longest <= 0x1p1000 && all - all == 0 &&
              s.slack <= largestOrigin;
    if (!usable_ || bvh.empty()) return;

    // The direction is brought to a length of 1 to 2 along its longest axis by a power of two.
    tScale_ = std::bit_cast<double>(std::bit_cast<std::uint64_t>(longest) >> 52 << 52);
    const double normalise = 1 / tScale_;

    // The slack, and four times what leastDirection may do.
    const double spread = s.slack + 0x1p-38 * (farthest + bvh.extent_ * bvh.scale_);
    for (int axis = 0; axis < 3; ++axis) {
        const double d = direction[axis] * normalise;
        const double turned = std::copysign(std::max(std::abs(d), leastDirection), d);
        // Four roundings: the origin's own, that of the origin times the inverse, and more to spare.
        const double margin = std::copysign(spread + 4 * roundoff * std::abs(s.origin[axis]), turned);
        s.nearOrigin[axis] = static_cast<float>(s.origin[axis] + margin);
        s.farOrigin[axis] = static_cast<float>(s.origin[axis] - margin);
        s.inverse[axis] = 1 / static_cast<float>(turned);
        s.nearPlane[axis] = static_cast<std::uint32_t>(2 * axis + (turned < 0));
        s.ballOrigin[axis] = static_cast<float>(s.origin[axis]);
        s.ballDirection[axis] = static_cast<float>(d);
    }
    s.balls = bvh.balls_;
    s.ballMargin = static_cast<float>(spread + 0x1p-19 * farthest);
    s.x = s.z == 2 ? 0 : s.z + 1;
    s.y = s.z == 0 ? 2 : s.z - 1;
    const double perZ = 1 / direction[s.z];
    s.shearX = direction[s.x] * perZ;
    s.shearY = direction[s.y] * perZ;
    s.nodes = bvh.nodes_.data();
    s.words = bvh.triangles_ ? bvh.words_.data() : nullptr;
    s.stack[0] = bvh.root_;
    s.depth = 1;
}

bool BvhCursor::next(double limit) {
    // Rounded up; the factor is far more than the roundings of product and conversion.
    const double scaled = std::clamp(limit * tScale_ * (1 + 0x1p-20), 0.0, double{std::numeric_limits<float>::max()});
    return chosen.advance(state_, static_cast<float>(scaled));
}

// Plain C++

namespace scalar {

#define RAYTRACER_TARGET

struct Lanes {
    float v[8];
};

template <class Operation>
inline Lanes lanewise(const Lanes& a, const Lanes& b, Operation operation) {
    Lanes result;
    for (int i = 0; i < 8; ++i) result.v[i] = operation(a.v[i], b.v[i]);
    return result;
}

inline Lanes load(const float* p) {
    Lanes result;
    std::memcpy(result.v, p, sizeof result.v);
    return result;
}
inline Lanes broadcast(float x) { return {{x, x, x, x, x, x, x, x}}; }
inline Lanes loadGrid(const std::uint16_t* p) {
    Lanes result;
    for (int i = 0; i < 8; ++i) result.v[i] = p[i];
    return result;
}
inline void store(float* p, const Lanes& a) { std::memcpy(p, a.v, sizeof a.v); }
inline Lanes operator+(const Lanes& a, const Lanes& b) { return lanewise(a, b, [](float x, float y) { return x + y; }); }
inline Lanes operator-(const Lanes& a, const Lanes& b) { return lanewise(a, b, [](float x, float y) { return x - y; }); }
inline Lanes operator*(const Lanes& a, const Lanes& b) { return lanewise(a, b, [](float x, float y) { return x * y; }); }
inline Lanes max(const Lanes& a, const Lanes& b) { return lanewise(a, b, [](float x, float y) { return x > y ? x : y; }); }
inline Lanes min(const Lanes& a, const Lanes& b) { return lanewise(a, b, [](float x, float y) { return x < y ? x : y; }); }
inline unsigned lessEqual(const Lanes& a, const Lanes& b) {
    unsigned mask = 0;
    for (int i = 0; i < 8; ++i) mask |= unsigned{a.v[i] <= b.v[i]} << i;
    return mask;
}
inline unsigned notLess(const Lanes& a, const Lanes& b) {  // true for NaN
    unsigned mask = 0;
    for (int i = 0; i < 8; ++i) mask |= unsigned{!(a.v[i] < b.v[i])} << i;
    return mask;
}
inline Lanes multiplySubtract(const Lanes& a, const Lanes& b, const Lanes& c) { return a * b - c; }
inline unsigned ballFlags(const std::uint32_t* child) {
    unsigned mask = 0;
    for (int i = 0; i < 8; ++i) mask |= (child[i] >> 30 & 1) << i;
    return mask;
}
inline float offset(float origin, float) { return origin; }
inline Lanes planeDistance(const Lanes& plane, const Lanes& inverse, const Lanes& offset) {
    return (plane - offset) * inverse;
}

#include "bvh_kernel.inc"
#undef RAYTRACER_TARGET

}  // namespace scalar

#if defined(__x86_64__)

namespace sse2 {

#define RAYTRACER_TARGET

struct Lanes {
    __m128 a, b;
};

inline Lanes load(const float* p) { return {_mm_loadu_ps(p), _mm_loadu_ps(p + 4)}; }
inline Lanes broadcast(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
inline Lanes loadGrid(const std::uint16_t* p) {
    const __m128i all = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p)), zero = _mm_setzero_si128();
    return {_mm_cvtepi32_ps(_mm_unpacklo_epi16(all, zero)), _mm_cvtepi32_ps(_mm_unpackhi_epi16(all, zero))};
}
inline void store(float* p, const Lanes& x) { _mm_storeu_ps(p, x.a), _mm_storeu_ps(p + 4, x.b); }
inline Lanes operator+(const Lanes& x, const Lanes& y) { return {_mm_add_ps(x.a, y.a), _mm_add_ps(x.b, y.b)}; }
inline Lanes operator-(const Lanes& x, const Lanes& y) { return {_mm_sub_ps(x.a, y.a), _mm_sub_ps(x.b, y.b)}; }
inline Lanes operator*(const Lanes& x, const Lanes& y) { return {_mm_mul_ps(x.a, y.a), _mm_mul_ps(x.b, y.b)}; }
inline Lanes max(const Lanes& x, const Lanes& y) { return {_mm_max_ps(x.a, y.a), _mm_max_ps(x.b, y.b)}; }
inline Lanes min(const Lanes& x, const Lanes& y) { return {_mm_min_ps(x.a, y.a), _mm_min_ps(x.b, y.b)}; }
inline unsigned lessEqual(const Lanes& x, const Lanes& y) {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(x.a, y.a)) |
                                 _mm_movemask_ps(_mm_cmple_ps(x.b, y.b)) << 4);
}
inline unsigned notLess(const Lanes& x, const Lanes& y) {  // true for NaN
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmpnlt_ps(x.a, y.a)) |
                                 _mm_movemask_ps(_mm_cmpnlt_ps(x.b, y.b)) << 4);
}
inline Lanes multiplySubtract(const Lanes& x, const Lanes& y, const Lanes& z) { return x * y - z; }
inline unsigned ballFlags(const std::uint32_t* child) {
    const auto flags = [child](int i) {
        const __m128i four = _mm_loadu_si128(reinterpret_cast<const __m128i*>(child + i));
        return _mm_movemask_ps(_mm_castsi128_ps(_mm_slli_epi32(four, 1)));
    };
    return static_cast<unsigned>(flags(0) | flags(4) << 4);
}
inline float offset(float origin, float) { return origin; }
inline Lanes planeDistance(const Lanes& plane, const Lanes& inverse, const Lanes& offset) {
    return (plane - offset) * inverse;
}

#include "bvh_kernel.inc"
#undef RAYTRACER_TARGET

}  // namespace sse2

namespace avx2 {

#define RAYTRACER_TARGET __attribute__((target("avx2,fma")))

struct Lanes {
    __m256 v;
};

RAYTRACER_TARGET inline Lanes load(const float* p) { return {_mm256_loadu_ps(p)}; }
RAYTRACER_TARGET inline Lanes broadcast(float x) { return {_mm256_set1_ps(x)}; }
RAYTRACER_TARGET inline Lanes loadGrid(const std::uint16_t* p) {
    return {_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p))))};
}
RAYTRACER_TARGET inline void store(float* p, const Lanes& x) { _mm256_storeu_ps(p, x.v); }
RAYTRACER_TARGET inline Lanes operator+(const Lanes& x, const Lanes& y) { return {_mm256_add_ps(x.v, y.v)}; }
RAYTRACER_TARGET inline Lanes operator-(const Lanes& x, const Lanes& y) { return {_mm256_sub_ps(x.v, y.v)}; }
RAYTRACER_TARGET inline Lanes operator*(const Lanes& x, const Lanes& y) { return {_mm256_mul_ps(x.v, y.v)}; }
RAYTRACER_TARGET inline Lanes max(const Lanes& x, const Lanes& y) { return {_mm256_max_ps(x.v, y.v)}; }
RAYTRACER_TARGET inline Lanes min(const Lanes& x, const Lanes& y) { return {_mm256_min_ps(x.v, y.v)}; }
RAYTRACER_TARGET inline unsigned lessEqual(const Lanes& x, const Lanes& y) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(x.v, y.v, _CMP_LE_OQ)));
}
RAYTRACER_TARGET inline unsigned notLess(const Lanes& x, const Lanes& y) {  // true for NaN
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(x.v, y.v, _CMP_NLT_UQ)));
}
RAYTRACER_TARGET inline Lanes multiplySubtract(const Lanes& x, const Lanes& y, const Lanes& z) {
    return {_mm256_fmsub_ps(x.v, y.v, z.v)};
}
RAYTRACER_TARGET inline unsigned ballFlags(const std::uint32_t* child) {
    const __m256i eight = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(child));
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_slli_epi32(eight, 1))));
}
RAYTRACER_TARGET inline float offset(float origin, float inverse) { return origin * inverse; }
RAYTRACER_TARGET inline Lanes planeDistance(const Lanes& plane, const Lanes& inverse, const Lanes& offset) {
    return multiplySubtract(plane, inverse, offset);
}

#include "bvh_kernel.inc"
#undef RAYTRACER_TARGET

}  // namespace avx2

#endif

}  // namespace raytracer
