// The rule of `cutoff`: a ray whose throughput bound is smaller is not traced.
#pragma once

#include "raytracer/numerics/numerics.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// An upper bound on how much a ray changes any channel of its pixel: its weight in the pixel times an upper
// bound on its colour.
inline double throughputBound(const Color& weight, const Color& brightest) {
    return static_cast<double>(maxComponent(abs(weight) * brightest));
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
