// The number of a face or triangle, for one ray or for several.
#pragma once

#include <cstdint>

#include "raytracer/numerics/numerics.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Of each ray's face or triangle.
template <class T>
struct PrimitiveOf {
    using type = std::uint32_t;
};
template <class T>
using Primitive = typename PrimitiveOf<T>::type;
inline std::uint32_t laneOf(std::uint32_t primitive, int) { return primitive; }
inline std::uint32_t filled(std::uint32_t primitive, LaneBits) { return primitive; }
inline bool equals(std::uint32_t a, std::uint32_t b) { return a == b; }
template <class Function>
void forEachLane(std::uint32_t primitive, Function function) {
    function(0, primitive);
}
inline std::uint32_t faceOf(std::uint32_t primitive) {
    return primitive;
}  // for rays that all hit the same face

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
