// The number type of the core, chosen at compile time.
//
// The core's sources are compiled three times, for float, double and long double, each into an inline
// namespace of its own. So one binary holds all three without a template parameter in the code. `renderer.h`
// is the interface that chooses one at run time. A file that does not choose (a test) gets double.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#if defined(RAYTRACER_PRECISION_float)
#define RAYTRACER_PRECISION_NAMESPACE float_precision
#define RAYTRACER_REAL float
#elif defined(RAYTRACER_PRECISION_extended)
#define RAYTRACER_PRECISION_NAMESPACE extended_precision
#define RAYTRACER_REAL long double
#else
#define RAYTRACER_PRECISION_NAMESPACE double_precision
#define RAYTRACER_REAL double
#endif

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

using Real = RAYTRACER_REAL;

// T is Real, or Lanes (ray_lanes.h): one number for each of several rays, side by side.
template <class T>
using Vec2T = glm::vec<2, T, glm::defaultp>;
template <class T>
using Vec3T = glm::vec<3, T, glm::defaultp>;

using Vec2 = Vec2T<Real>;
using Vec3 = Vec3T<Real>;
using Mat3 = glm::mat<3, 3, Real, glm::defaultp>;  // columns
using Color = Vec3;                                // linear RGB, not clamped

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
