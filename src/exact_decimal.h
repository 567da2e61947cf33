// Decimal numbers of few digits, quickly.
#pragma once

#include <cstddef>
#include <cstdint>

namespace raytracer {

// A quotient of two whole numbers that double holds exactly is rounded once, so right (Clinger, How to Read Floating Point
// Numbers Accurately, 1990): 15 digits over 10^15 are.
inline constexpr std::ptrdiff_t mostExactDigits = 15;

// digits / 10^decimals, neither of more digits than that.
inline double exactDecimal(std::uint64_t digits, std::ptrdiff_t decimals) {
    constexpr double powersOfTen[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    return static_cast<double>(digits) / powersOfTen[decimals];
}

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace raytracer
