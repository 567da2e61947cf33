// Where a pixel's samples lie: at the first points of one sequence, which is the same in every pixel.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace raytracer {

// Sobol's (0, 2)-sequence with Owen scrambling: of its points i 2^k to (i + 1) 2^k - 1, one lies in each cell
// of every grid of 2^j x 2^(k - j) cells. All arithmetic is on whole numbers, so the points are the same
// everywhere. Scrambling by a hash: Burley, Practical Hash-based Owen Scrambling, JCGT 9 (4), 2020.
class SampleSequence {
  public:
    // Sequence 0 is the one of pictures. Its first point is the pixel's centre; that of any other is
    // anywhere.
    explicit SampleSequence(std::uint32_t number = 0)
        : seeds_{hash(2 * (best + number) + 1), hash(2 * (best + number) + 2)} {
        if (number != 0) return;
        for (int axis = 0; axis < 2; ++axis) shifts_[axis] = scrambled(0, axis) ^ half;
    }

    // How far point i lies into its pixel, to the right and down, in pixels: a multiple of 2^-24, below 1.
    glm::dvec2 operator[](std::uint32_t i) const {
        return {offset(scrambled(i, 0) ^ shifts_[0]), offset(scrambled(pascal(i), 1) ^ shifts_[1])};
    }

  private:
    static constexpr std::uint32_t half = 1U << 31;
    static constexpr std::uint32_t best =
        51;  // the best of 400 by the error at random edges; the second of 60 on scenes

    static double offset(std::uint32_t x) { return (x >> 8) * 0x1p-24; }  // exact in float too

    // Sobol's second dimension, with its bits reversed: the polynomial over GF(2) with i's bits, at 1 + z.
    static std::uint32_t pascal(std::uint32_t i) {
        i ^= i >> 16 & 0x0000ffffU;
        i ^= i >> 8 & 0x00ff00ffU;
        i ^= i >> 4 & 0x0f0f0f0fU;
        i ^= i >> 2 & 0x33333333U;
        return i ^ (i >> 1 & 0x55555555U);
    }

    // x: a number of Sobol's with its bits reversed. Reverses them again, and flips each one or not, by a
    // hash of the bits above it (Laine and Karras 2011, with Burley's constants). The hash comes before the
    // reversal, since a product's bits depend on those below them.
    std::uint32_t scrambled(std::uint32_t x, int axis) const {
        x += seeds_[axis];
        x ^= x * 0x6c50b47cU;
        x ^= x * 0xb82f1e52U;
        x ^= x * 0xc7afe638U;
        x ^= x * 0x8d22f6e6U;
        return reversed(x);
    }

    static std::uint32_t reversed(std::uint32_t x) {
        x = x << 16 | x >> 16;
        x = (x & 0x00ff00ffU) << 8 | (x >> 8 & 0x00ff00ffU);
        x = (x & 0x0f0f0f0fU) << 4 | (x >> 4 & 0x0f0f0f0fU);
        x = (x & 0x33333333U) << 2 | (x >> 2 & 0x33333333U);
        return (x & 0x55555555U) << 1 | (x >> 1 & 0x55555555U);
    }

    // Murmur3's finalizer.
    static std::uint32_t hash(std::uint32_t x) {
        x = (x ^ x >> 16) * 0x85ebca6bU;
        x = (x ^ x >> 13) * 0xc2b2ae35U;
        return x ^ x >> 16;
    }

    std::uint32_t seeds_[2], shifts_[2] = {0, 0};
};

}  // namespace raytracer
