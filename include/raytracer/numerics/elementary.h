// Elementary functions made only of +, -, *, /, square root and fma, which IEEE 754 rounds correctly: they
// give the same bits with every C library and processor. libm's own differ between libraries, and glibc's
// between processors with and without fma.
#pragma once

#include <cmath>

namespace raytracer {

// The angle of the point (x, y) from the x axis, in [-pi, pi], as std::atan2 gives it, signs of zero
// included. NaN gives NaN. The error is below 1.2 units in the last place.
double arcTangent(double y, double x);

// The angle in [0, pi] whose cosine is z, for z in [-1, 1]. The error is below 2.5 units in the last place.
double arcCosine(double z);

inline float arcTangent(float y, float x) { return static_cast<float>(arcTangent(double{y}, double{x})); }
inline float arcCosine(float z) { return static_cast<float>(arcCosine(double{z})); }

// These are libm's: the type long double itself differs between processors.
inline long double arcTangent(long double y, long double x) { return std::atan2(y, x); }
inline long double arcCosine(long double z) { return std::acos(z); }

}  // namespace raytracer
