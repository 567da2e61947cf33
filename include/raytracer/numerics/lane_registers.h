// The operations on vector registers that lanes.h is built on, by the intrinsics of each instruction set.
// Compiled once for each instruction set (CMakeLists.txt), into a namespace of its own. An operation without
// an intrinsic here is plain C++.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "raytracer/numerics/packet_size.h"
#include "raytracer/numerics/types.h"

#if !defined(RAYTRACER_LANES_scalar)
#include <immintrin.h>
#endif

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {

inline constexpr int laneCount = packetWidth * packetHeight;

#if defined(RAYTRACER_LANES_avx512)
inline constexpr int widestRegister = 64;
#elif defined(RAYTRACER_LANES_avx2)
inline constexpr int widestRegister = 32;
#else
inline constexpr int widestRegister = 16;
#endif

// How the lanes of one number type are laid out in registers.
template <class Number>
struct RegistersOf {
    static constexpr int lanes = std::min(widestRegister / static_cast<int>(sizeof(Number)), laneCount),
                         count = laneCount / lanes;
    using Register [[gnu::vector_size(lanes * sizeof(Number))]] = Number;
    using Bits = decltype(Register{} < Register{});  // for each lane all bits or none
#if defined(RAYTRACER_LANES_avx512)
    using Mask = __mmask8;  // lane i is the bit 1 << i
    static_assert(lanes == 8);
#else
    using Mask = Bits;
#endif
};

namespace detail {

using Floats = RegistersOf<float>::Register;
using Doubles = RegistersOf<double>::Register;
using FourDoubles [[gnu::vector_size(32)]] = double;
using FloatsBits = RegistersOf<float>::Bits;
using DoublesBits = RegistersOf<double>::Bits;

// Plain C++, on the vector types of GCC and Clang. Where an instruction set has an overload of its own below,
// that one is taken.

template <class Register>
inline Register sqrtOf(Register x) {
    for (std::size_t i = 0; i < sizeof x / sizeof x[0]; ++i) x[i] = std::sqrt(x[i]);
    return x;
}
template <class Register>
inline auto isLess(Register x, Register y) {
    return x < y;
}
template <class Register>
inline auto isAtMost(Register x, Register y) {
    return x <= y;
}
template <class Register>
inline auto isEqual(Register x, Register y) {
    return x == y;
}
// A mask as bits: lane i is the bit 1 << i. The lanes of a vector mask count by their sign.
template <class Mask>
inline unsigned bitsOf(Mask m) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < sizeof m / sizeof m[0]; ++i) bits |= static_cast<unsigned>(m[i] < 0) << i;
    return bits;
}
// The mask with these bits.
template <class Mask>
inline void setBits(Mask& m, unsigned bits) {
    Mask place;
    for (std::size_t i = 0; i < sizeof m / sizeof m[0]; ++i) place[i] = 1 << i;
    m = ((Mask{} + static_cast<int>(bits)) & place) == place;
}
template <class Mask>
inline void setLane(Mask& m, int lane, bool value) {
    m[lane] = value ? -1 : 0;
}
template <class Mask, class Register>
inline Register choose(Mask m, Register yes, Register no) {
    return reinterpret_cast<Register>((reinterpret_cast<Mask>(yes) & m) | (reinterpret_cast<Mask>(no) & ~m));
}
// The smaller, or the larger, of two; the second where they are equal or one is NaN.
template <class Register>
inline Register smaller(Register x, Register y) {
    return choose(isLess(x, y), x, y);
}
template <class Register>
inline Register larger(Register x, Register y) {
    return choose(isLess(y, x), x, y);
}
// x y + z and x y - z, rounded once where the processor has fma, else twice.
template <class Register>
inline Register multiplyAdd(Register x, Register y, Register z) {
    return x * y + z;
}
template <class Register>
inline Register multiplySubtract(Register x, Register y, Register z) {
    return x * y - z;
}

#if defined(RAYTRACER_LANES_sse2)

inline Floats sqrtOf(Floats x) { return _mm_sqrt_ps(x); }
inline Doubles sqrtOf(Doubles x) { return _mm_sqrt_pd(x); }
inline unsigned bitsOf(FloatsBits m) {
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<Floats>(m)));
}
inline unsigned bitsOf(DoublesBits m) {
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<Doubles>(m)));
}
inline Floats smaller(Floats x, Floats y) { return _mm_min_ps(x, y); }
inline Doubles smaller(Doubles x, Doubles y) { return _mm_min_pd(x, y); }
inline Floats larger(Floats x, Floats y) { return _mm_max_ps(x, y); }
inline Doubles larger(Doubles x, Doubles y) { return _mm_max_pd(x, y); }

#elif defined(RAYTRACER_LANES_avx2)

inline Doubles sqrtOf(Doubles x) { return _mm256_sqrt_pd(x); }
inline unsigned bitsOf(FloatsBits m) {
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<Floats>(m)));
}
inline unsigned bitsOf(DoublesBits m) {
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<Doubles>(m)));
}
inline Floats choose(FloatsBits m, Floats yes, Floats no) {
    return _mm256_blendv_ps(no, yes, reinterpret_cast<Floats>(m));
}
inline Doubles choose(DoublesBits m, Doubles yes, Doubles no) {
    return _mm256_blendv_pd(no, yes, reinterpret_cast<Doubles>(m));
}
inline Doubles smaller(Doubles x, Doubles y) { return _mm256_min_pd(x, y); }
inline Doubles larger(Doubles x, Doubles y) { return _mm256_max_pd(x, y); }

#elif defined(RAYTRACER_LANES_avx512)

inline Doubles sqrtOf(Doubles x) { return _mm512_sqrt_pd(x); }
inline __mmask8 isLess(Floats x, Floats y) { return _mm256_cmp_ps_mask(x, y, _CMP_LT_OQ); }
inline __mmask8 isLess(Doubles x, Doubles y) { return _mm512_cmp_pd_mask(x, y, _CMP_LT_OQ); }
inline __mmask8 isAtMost(Floats x, Floats y) { return _mm256_cmp_ps_mask(x, y, _CMP_LE_OQ); }
inline __mmask8 isAtMost(Doubles x, Doubles y) { return _mm512_cmp_pd_mask(x, y, _CMP_LE_OQ); }
inline __mmask8 isEqual(Floats x, Floats y) { return _mm256_cmp_ps_mask(x, y, _CMP_EQ_OQ); }
inline __mmask8 isEqual(Doubles x, Doubles y) { return _mm512_cmp_pd_mask(x, y, _CMP_EQ_OQ); }
inline unsigned bitsOf(__mmask8 m) { return m; }
inline void setBits(__mmask8& m, unsigned bits) { m = static_cast<__mmask8>(bits); }
inline void setLane(__mmask8& m, int lane, bool value) {
    m = static_cast<__mmask8>((m & ~(1u << lane)) | unsigned{value} << lane);
}
inline Floats choose(__mmask8 m, Floats yes, Floats no) { return _mm256_mask_blend_ps(m, no, yes); }
inline Doubles choose(__mmask8 m, Doubles yes, Doubles no) { return _mm512_mask_blend_pd(m, no, yes); }
inline Doubles smaller(Doubles x, Doubles y) { return _mm512_min_pd(x, y); }
inline Doubles larger(Doubles x, Doubles y) { return _mm512_max_pd(x, y); }
inline FourDoubles smaller(FourDoubles x, FourDoubles y) { return _mm256_min_pd(x, y); }

#endif

#if defined(RAYTRACER_LANES_avx2) || defined(RAYTRACER_LANES_avx512)  // both have eight floats

inline Floats sqrtOf(Floats x) { return _mm256_sqrt_ps(x); }
inline Floats smaller(Floats x, Floats y) { return _mm256_min_ps(x, y); }
inline Floats larger(Floats x, Floats y) { return _mm256_max_ps(x, y); }
inline Floats multiplyAdd(Floats x, Floats y, Floats z) { return _mm256_fmadd_ps(x, y, z); }
inline Floats multiplySubtract(Floats x, Floats y, Floats z) { return _mm256_fmsub_ps(x, y, z); }

// larger and smaller, for pairs of which at least one is not negative: these have the same order as their
// bits read as integers. (From AVX2 on, processors compare integers faster than floats.)
inline Floats later(Floats x, Floats y) {
    return reinterpret_cast<Floats>(
        _mm256_max_epi32(reinterpret_cast<__m256i>(x), reinterpret_cast<__m256i>(y)));
}
inline Floats earlier(Floats x, Floats y) {
    return reinterpret_cast<Floats>(
        _mm256_min_epi32(reinterpret_cast<__m256i>(x), reinterpret_cast<__m256i>(y)));
}

// The first of these numbers, one for each lane. (GCC 12 would convert eight in two halves.)
inline Floats integers(const std::uint16_t* numbers) {
    return _mm256_cvtepi32_ps(
        _mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers))));
}

#else

inline Floats later(Floats x, Floats y) { return larger(x, y); }
inline Floats earlier(Floats x, Floats y) { return smaller(x, y); }
inline Floats integers(const std::uint16_t* numbers) {
    using Shorts [[gnu::vector_size(RegistersOf<float>::lanes * sizeof *numbers)]] = std::uint16_t;
    Shorts shorts;
    std::memcpy(&shorts, numbers, sizeof shorts);
    return __builtin_convertvector(__builtin_convertvector(shorts, FloatsBits), Floats);
}

#endif

// isLater: x > y, for pairs of which at least one is not negative. topBits: for each lane the highest bit of
// x << below.
#if defined(RAYTRACER_LANES_avx512)
inline __mmask8 isLater(Floats x, Floats y) {
    return _mm256_cmpgt_epi32_mask(reinterpret_cast<__m256i>(x), reinterpret_cast<__m256i>(y));
}
inline __mmask8 topBits(FloatsBits x, int below) {
    return _mm256_movepi32_mask(reinterpret_cast<__m256i>(x << below));
}
#else
inline FloatsBits isLater(Floats x, Floats y) {
    return reinterpret_cast<FloatsBits>(x) > reinterpret_cast<FloatsBits>(y);
}
inline FloatsBits topBits(FloatsBits x, int below) { return x << below; }
#endif

}  // namespace detail
}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
