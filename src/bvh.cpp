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
    double direction[3], farthest = 0, longest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        s.origin[axis] = (ray.origin[axis] - bvh.center_[axis]) * bvh.scale_;
        direction[axis] = ray.direction[axis] * bvh.scale_;
        farthest = std::max(farthest, std::abs(s.origin[axis]));
        longest = std::max(longest, std::abs(direction[axis]));
    }
    s.slack = ray.slack * bvh.scale_;
    tScale_ = longest;
    // NaN compares false. max() may have dropped one, the sum doesn't.
    const double all = s.origin[0] + s.origin[1] + s.origin[2] + direction[0] + direction[1] + direction[2];
    usable_ = farthest <= largestOrigin && longest > std::numeric_limits<double>::min() && all - all == 0 &&
              s.slack <= largestOrigin;
    if (!usable_ || bvh.empty()) return;

    // The slack, and four times what leastDirection may do.
    const double spread = s.slack + 0x1p-38 * (farthest + bvh.extent_ * bvh.scale_);
    for (int axis = 0; axis < 3; ++axis) {
        double d = direction[axis] /= longest;
        if (std::abs(d) == 1) s.z = static_cast<std::uint32_t>(axis);
        if (std::abs(d) < leastDirection) d = std::copysign(leastDirection, d);
        // Four roundings: the origin's own, that of the scaled origin, and one to spare. The other errors are relative to
        // the distance from the plane: two of the inverse and one of the product, on either side, less than 2^-20 in all.
        const double margin = spread + 4 * roundoff * std::abs(s.origin[axis]);
        const auto low = static_cast<float>(s.origin[axis] - margin), high = static_cast<float>(s.origin[axis] + margin);
        const bool forward = d > 0;
        s.nearOrigin[axis] = forward ? high : low;
        s.farOrigin[axis] = forward ? low : high;
        s.inverseNear[axis] = static_cast<float>(1 / d);
        s.inverseFar[axis] = s.inverseNear[axis] * (1 + 0x1p-20f);
        s.nearScaled[axis] = s.nearOrigin[axis] * s.inverseNear[axis];
        s.farScaled[axis] = s.farOrigin[axis] * s.inverseFar[axis];
        s.nearPlane[axis] = static_cast<std::uint32_t>(2 * axis + !forward);
        s.farPlane[axis] = static_cast<std::uint32_t>(2 * axis + forward);
    }
    s.x = (s.z + 1) % 3;
    s.y = (s.z + 2) % 3;
    s.shearX = direction[s.x] / direction[s.z];
    s.shearY = direction[s.y] / direction[s.z];
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
inline Lanes planeDistance(const Lanes& plane, float origin, float inverse, float) {
    return (plane - broadcast(origin)) * broadcast(inverse);
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
inline Lanes planeDistance(const Lanes& plane, float origin, float inverse, float) {
    return (plane - broadcast(origin)) * broadcast(inverse);
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
RAYTRACER_TARGET inline Lanes planeDistance(const Lanes& plane, float, float inverse, float scaledOrigin) {
    return multiplySubtract(plane, broadcast(inverse), broadcast(scaledOrigin));
}

#include "bvh_kernel.inc"
#undef RAYTRACER_TARGET

}  // namespace avx2

#endif

}  // namespace raytracer
