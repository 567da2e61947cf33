// Lanes of Real, one for each ray of a packet, with the functions of numerics.h and primitive.h for them.
// Included only by files that are compiled once for each instruction set.
#pragma once

#include "raytracer/numerics/lanes.h"
#include "raytracer/numerics/numerics.h"
#include "raytracer/numerics/primitive.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {

using Lanes = LanesOf<Real>;
using Mask = MaskOf<Real>;

// Stores the least lane of each component; to[3] has no meaning.
template <class Number>
inline void storeLeast(const Vec3T<LanesOf<Number>>& v, double (&to)[4]) {
    if constexpr (sizeof(LanesOf<Number>) == 2 * sizeof to && widestRegister >= static_cast<int>(sizeof to)) {
        using Register = typename detail::FourDoubles;
        const auto halves = [](const LanesOf<Number>& x) {
            Register half[2];
            std::memcpy(half, &x, sizeof half);
            return detail::smaller(half[0], half[1]);
        };
        const Register x = halves(v.x), y = halves(v.y), z = halves(v.z);
        const Register xy = detail::smaller(__builtin_shufflevector(x, y, 0, 4, 2, 6),
                                            __builtin_shufflevector(x, y, 1, 5, 3, 7));
        const Register zz = detail::smaller(z, __builtin_shufflevector(z, z, 1, 0, 3, 2));
        const Register all = detail::smaller(__builtin_shufflevector(xy, zz, 0, 1, 4, 5),
                                             __builtin_shufflevector(xy, zz, 2, 3, 6, 7));
        std::memcpy(to, &all, sizeof to);
    } else {
        for (int axis = 0; axis < 3; ++axis) to[axis] = static_cast<double>(least(v[axis]));
    }
}

inline Lanes filled(const Lanes& x, LaneBits used) {
    return select(Mask::ofBits(used), x, laneOf(x, firstLane(used)));
}
template <int n>
glm::vec<n, Real, glm::defaultp> laneOf(const glm::vec<n, Lanes, glm::defaultp>& v, int lane) {
    glm::vec<n, Real, glm::defaultp> result;
    for (int i = 0; i < n; ++i) result[i] = laneOf(v[i], lane);
    return result;
}
template <int n>
void setLane(glm::vec<n, Lanes, glm::defaultp>& v, int lane, const glm::vec<n, Real, glm::defaultp>& value) {
    for (int i = 0; i < n; ++i) setLane(v[i], lane, value[i]);
}

// The number of the face or triangle in each lane.
struct LanePrimitives {
    std::uint32_t of[laneCount];
};
inline std::uint32_t laneOf(const LanePrimitives& primitives, int lane) { return primitives.of[lane]; }
inline LanePrimitives filled(LanePrimitives primitives, LaneBits used) {
    for (int i = 0; i < laneCount; ++i)
        if (!(used >> i & 1)) primitives.of[i] = primitives.of[firstLane(used)];
    return primitives;
}
inline void setLane(LanePrimitives& primitives, int lane, std::uint32_t primitive) {
    primitives.of[lane] = primitive;
}
inline Mask equals(const LanePrimitives& a, std::uint32_t b) {
    LaneBits bits = 0;
    for (int i = 0; i < laneCount; ++i) bits |= static_cast<LaneBits>(a.of[i] == b) << i;
    return Mask::ofBits(bits);
}
template <class Function>
void forEachLane(const LanePrimitives& primitives, Function function) {
    for (int i = 0; i < laneCount; ++i) function(i, primitives.of[i]);
}
inline std::uint32_t faceOf(const LanePrimitives& primitives) { return primitives.of[0]; }

}  // namespace RAYTRACER_LANES_NAMESPACE

template <>
struct PrimitiveOf<Lanes> {
    using type = LanePrimitives;
};
template <>
inline constexpr int laneCountOf<Lanes> = laneCount;

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer

// GLM takes a Lanes for a number.
template <>
class std::numeric_limits<raytracer::Lanes> : public std::numeric_limits<raytracer::Real> {};
