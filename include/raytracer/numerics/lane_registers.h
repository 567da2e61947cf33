// The processor's vector registers, for lanes.h: what the instruction set calls its operations.
#pragma once

#include <cmath>

#include "raytracer/numerics/packet_size.h"
#include "raytracer/numerics/types.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#if defined(RAYTRACER_LANES_avx2)
#define RAYTRACER_LANES_NAMESPACE lanes_avx2
#else
#define RAYTRACER_LANES_NAMESPACE lanes_plain
#endif

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {

inline constexpr int laneCount = packetWidth * packetHeight;
#if defined(RAYTRACER_LANES_avx2)
inline constexpr int registerBytes = 32;
#else
inline constexpr int registerBytes = 16;
#endif
inline constexpr int registerLanes = registerBytes / static_cast<int>(sizeof(Real));
inline constexpr int registerCount = laneCount / registerLanes;

using Register [[gnu::vector_size(registerBytes)]] = Real;
using RegisterMask = decltype(Register{} < Register{});  // of each lane all bits or none

namespace detail {

inline Register sqrtOf(Register x) {
#if defined(RAYTRACER_LANES_avx2)
    if constexpr (sizeof(Real) == 8)
        return reinterpret_cast<Register>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(x)));
    else return reinterpret_cast<Register>(_mm256_sqrt_ps(reinterpret_cast<__m256>(x)));
#elif defined(__x86_64__)
    if constexpr (sizeof(Real) == 8)
        return reinterpret_cast<Register>(_mm_sqrt_pd(reinterpret_cast<__m128d>(x)));
    else return reinterpret_cast<Register>(_mm_sqrt_ps(reinterpret_cast<__m128>(x)));
#else
    for (int i = 0; i < registerLanes; ++i) x[i] = std::sqrt(x[i]);
    return x;
#endif
}

inline unsigned bitsOf(RegisterMask m) {
#if defined(RAYTRACER_LANES_avx2)
    if constexpr (sizeof(Real) == 8)
        return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(m)));
    else return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(m)));
#elif defined(__x86_64__)
    if constexpr (sizeof(Real) == 8)
        return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(m)));
    else return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(m)));
#else
    unsigned bits = 0;
    for (int i = 0; i < registerLanes; ++i) bits |= static_cast<unsigned>(m[i] != 0) << i;
    return bits;
#endif
}

inline Register choose(RegisterMask m, Register yes, Register no) {
#if defined(RAYTRACER_LANES_avx2)
    if constexpr (sizeof(Real) == 8)
        return reinterpret_cast<Register>(_mm256_blendv_pd(
            reinterpret_cast<__m256d>(no), reinterpret_cast<__m256d>(yes), reinterpret_cast<__m256d>(m)));
    else
        return reinterpret_cast<Register>(_mm256_blendv_ps(
            reinterpret_cast<__m256>(no), reinterpret_cast<__m256>(yes), reinterpret_cast<__m256>(m)));
#else
    return reinterpret_cast<Register>((reinterpret_cast<RegisterMask>(yes) & m) |
                                      (reinterpret_cast<RegisterMask>(no) & ~m));
#endif
}

// The smaller of two, the second where they are equal or one is NaN; and the larger.
inline Register smaller(Register x, Register y) {
#if defined(RAYTRACER_LANES_avx2)
    if constexpr (sizeof(Real) == 8)
        return reinterpret_cast<Register>(
            _mm256_min_pd(reinterpret_cast<__m256d>(x), reinterpret_cast<__m256d>(y)));
    else
        return reinterpret_cast<Register>(
            _mm256_min_ps(reinterpret_cast<__m256>(x), reinterpret_cast<__m256>(y)));
#elif defined(__x86_64__)
    if constexpr (sizeof(Real) == 8)
        return reinterpret_cast<Register>(
            _mm_min_pd(reinterpret_cast<__m128d>(x), reinterpret_cast<__m128d>(y)));
    else
        return reinterpret_cast<Register>(
            _mm_min_ps(reinterpret_cast<__m128>(x), reinterpret_cast<__m128>(y)));
#else
    return choose(x < y, x, y);
#endif
}
inline Register larger(Register x, Register y) {
#if defined(RAYTRACER_LANES_avx2)
    if constexpr (sizeof(Real) == 8)
        return reinterpret_cast<Register>(
            _mm256_max_pd(reinterpret_cast<__m256d>(x), reinterpret_cast<__m256d>(y)));
    else
        return reinterpret_cast<Register>(
            _mm256_max_ps(reinterpret_cast<__m256>(x), reinterpret_cast<__m256>(y)));
#elif defined(__x86_64__)
    if constexpr (sizeof(Real) == 8)
        return reinterpret_cast<Register>(
            _mm_max_pd(reinterpret_cast<__m128d>(x), reinterpret_cast<__m128d>(y)));
    else
        return reinterpret_cast<Register>(
            _mm_max_ps(reinterpret_cast<__m128>(x), reinterpret_cast<__m128>(y)));
#else
    return choose(x > y, x, y);
#endif
}

inline RegisterMask signBit() { return reinterpret_cast<RegisterMask>(-Register{}); }

// The least of a register's lanes.
inline Real least(Register x) {
    Real result = x[0];
    for (int i = 1; i < registerLanes; ++i) result = x[i] < result ? x[i] : result;
    return result;
}

}  // namespace detail
}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
