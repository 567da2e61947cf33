#include "bvh_instruction_sets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace raytracer {

namespace {

// GCC's and Clang's vectors, on any processor.
using Float4 [[gnu::vector_size(16)]] = float;
using Double4 [[gnu::vector_size(32)]] = double;
using Long4 [[gnu::vector_size(32)]] = std::int64_t;

constexpr double roundoff = 0x1p-24;  // of float

// A ray from further out than this, in the tree's frame, would overflow.
constexpr double largestOrigin = 0x1p60;

// The least component of a normalised direction, so that its inverse is finite and 0 * infinity = NaN cannot
// occur. What it turns the ray by is allowed for in the origin's box.
constexpr double leastDirection = 0x1p-40;

// A beam that may meet more primitives than this is followed sooner ray by ray (Notes.txt).
constexpr double manyPrimitives = 128;

}  // namespace

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
inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return lanewise(a, b, [](float x, float y) { return x + y; });
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return lanewise(a, b, [](float x, float y) { return x - y; });
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return lanewise(a, b, [](float x, float y) { return x * y; });
}
inline Lanes max(const Lanes& a, const Lanes& b) {
    return lanewise(a, b, [](float x, float y) { return x > y ? x : y; });
}
inline Lanes min(const Lanes& a, const Lanes& b) {
    return lanewise(a, b, [](float x, float y) { return x < y ? x : y; });
}
inline unsigned notAfter(const Lanes& a, const Lanes& b) {
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
inline Lanes multiplyAdd(const Lanes& a, const Lanes& b, const Lanes& c) { return a * b + c; }
inline unsigned ballFlags(const std::uint32_t* child) {
    unsigned mask = 0;
    for (int i = 0; i < 8; ++i) mask |= (child[i] >> 30 & 1) << i;
    return mask;
}
inline unsigned leafFlags(const std::uint32_t* child) {
    unsigned mask = 0;
    for (int i = 0; i < 8; ++i) mask |= (child[i] >> 31) << i;
    return mask;
}
inline Float4 offsetOf(Float4 origin, Float4) { return origin; }
inline Lanes planeDistance(const Lanes& plane, const Lanes& inverse, const Lanes& offset) {
    return (plane - offset) * inverse;
}
inline Lanes latest(const Lanes& a, const Lanes& b, const Lanes& c) {
    return max(max(a, b), max(c, broadcast(0)));
}
inline Lanes earliest(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    return min(min(a, b), min(c, d));
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
inline Lanes operator+(const Lanes& x, const Lanes& y) {
    return {_mm_add_ps(x.a, y.a), _mm_add_ps(x.b, y.b)};
}
inline Lanes operator-(const Lanes& x, const Lanes& y) {
    return {_mm_sub_ps(x.a, y.a), _mm_sub_ps(x.b, y.b)};
}
inline Lanes operator*(const Lanes& x, const Lanes& y) {
    return {_mm_mul_ps(x.a, y.a), _mm_mul_ps(x.b, y.b)};
}
inline Lanes max(const Lanes& x, const Lanes& y) { return {_mm_max_ps(x.a, y.a), _mm_max_ps(x.b, y.b)}; }
inline Lanes min(const Lanes& x, const Lanes& y) { return {_mm_min_ps(x.a, y.a), _mm_min_ps(x.b, y.b)}; }
inline unsigned notAfter(const Lanes& x, const Lanes& y) {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(x.a, y.a)) |
                                 _mm_movemask_ps(_mm_cmple_ps(x.b, y.b)) << 4);
}
inline unsigned notLess(const Lanes& x, const Lanes& y) {  // true for NaN
    return static_cast<unsigned>(_mm_movemask_ps(_mm_cmpnlt_ps(x.a, y.a)) |
                                 _mm_movemask_ps(_mm_cmpnlt_ps(x.b, y.b)) << 4);
}
inline Lanes multiplySubtract(const Lanes& x, const Lanes& y, const Lanes& z) { return x * y - z; }
inline Lanes multiplyAdd(const Lanes& x, const Lanes& y, const Lanes& z) { return x * y + z; }
inline unsigned ballFlags(const std::uint32_t* child) {
    const auto flags = [child](int i) {
        const __m128i four = _mm_loadu_si128(reinterpret_cast<const __m128i*>(child + i));
        return _mm_movemask_ps(_mm_castsi128_ps(_mm_slli_epi32(four, 1)));
    };
    return static_cast<unsigned>(flags(0) | flags(4) << 4);
}
inline unsigned leafFlags(const std::uint32_t* child) {
    const auto flags = [child](int i) {
        return _mm_movemask_ps(_mm_loadu_ps(reinterpret_cast<const float*>(child + i)));
    };
    return static_cast<unsigned>(flags(0) | flags(4) << 4);
}
inline Float4 offsetOf(Float4 origin, Float4) { return origin; }
inline Lanes planeDistance(const Lanes& plane, const Lanes& inverse, const Lanes& offset) {
    return (plane - offset) * inverse;
}
inline Lanes latest(const Lanes& a, const Lanes& b, const Lanes& c) {
    return max(max(a, b), max(c, broadcast(0)));
}
inline Lanes earliest(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    return min(min(a, b), min(c, d));
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
RAYTRACER_TARGET inline unsigned leafFlags(const std::uint32_t* child) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_loadu_ps(reinterpret_cast<const float*>(child))));
}
RAYTRACER_TARGET inline Lanes multiplyAdd(const Lanes& x, const Lanes& y, const Lanes& z) {
    return {_mm256_fmadd_ps(x.v, y.v, z.v)};
}
RAYTRACER_TARGET inline Float4 offsetOf(Float4 origin, Float4 inverse) { return origin * inverse; }
RAYTRACER_TARGET inline Lanes planeDistance(const Lanes& plane, const Lanes& inverse, const Lanes& offset) {
    return multiplySubtract(plane, inverse, offset);
}

// As integers, which is faster: floats that are not negative are in the same order, and a negative one is
// below these.
RAYTRACER_TARGET inline __m256i bits(const Lanes& x) { return _mm256_castps_si256(x.v); }
RAYTRACER_TARGET inline Lanes latest(const Lanes& a, const Lanes& b, const Lanes& c) {
    const __m256i positive = _mm256_max_epi32(bits(c), _mm256_setzero_si256());
    return {_mm256_castsi256_ps(_mm256_max_epi32(_mm256_max_epi32(bits(a), bits(b)), positive))};
}
RAYTRACER_TARGET inline Lanes earliest(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
    return {_mm256_castsi256_ps(
        _mm256_min_epi32(_mm256_min_epi32(bits(a), bits(b)), _mm256_min_epi32(bits(c), bits(d))))};
}
RAYTRACER_TARGET inline unsigned notAfter(const Lanes& near, const Lanes& far) {
    const __m256i after = _mm256_cmpgt_epi32(bits(near), bits(far));
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(after))) ^ 0xff;
}

#include "bvh_kernel.inc"
#undef RAYTRACER_TARGET

}  // namespace avx2

#endif

}  // namespace raytracer
