// Several Reals side by side, one for each ray of a packet, in the processor's vector registers.
//
// Every operation is IEEE's on each lane by itself, so a lane's number has the very bits that Real would
// have. This file is compiled once for each instruction set, into a namespace of its own; only
// packet_tracer.cpp includes it.
#pragma once

#include <cstring>

#include "raytracer/numerics/lane_registers.h"
#include "raytracer/numerics/numerics.h"
#include "raytracer/numerics/primitive.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {

// The bits of several truths: lane i's is 1 << i.
using LaneBits = unsigned;
inline constexpr LaneBits allLanes = (LaneBits{1} << laneCount) - 1;

struct Mask {
    RegisterMask part[registerCount];
};

struct Lanes {
    Register part[registerCount];

    Lanes() = default;
    Lanes(Real x) {
        for (Register& p : part) p = x - Register{};
    }
};

namespace detail {

template <class Result, class Operation, class... Arguments>
inline Result partwise(Operation operation, const Arguments&... arguments) {
    Result result;
    for (int i = 0; i < registerCount; ++i) result.part[i] = operation(arguments.part[i]...);
    return result;
}

}  // namespace detail

inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return detail::partwise<Lanes>([](Register x, Register y) { return x + y; }, a, b);
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return detail::partwise<Lanes>([](Register x, Register y) { return x - y; }, a, b);
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return detail::partwise<Lanes>([](Register x, Register y) { return x * y; }, a, b);
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
    return detail::partwise<Lanes>([](Register x, Register y) { return x / y; }, a, b);
}
inline Lanes operator-(const Lanes& a) {
    return detail::partwise<Lanes>([](Register x) { return -x; }, a);
}
inline Lanes& operator+=(Lanes& a, const Lanes& b) { return a = a + b; }
inline Lanes& operator-=(Lanes& a, const Lanes& b) { return a = a - b; }
inline Lanes& operator*=(Lanes& a, const Lanes& b) { return a = a * b; }
inline Lanes& operator/=(Lanes& a, const Lanes& b) { return a = a / b; }

inline Mask operator<(const Lanes& a, const Lanes& b) {
    return detail::partwise<Mask>([](Register x, Register y) { return x < y; }, a, b);
}
inline Mask operator<=(const Lanes& a, const Lanes& b) {
    return detail::partwise<Mask>([](Register x, Register y) { return x <= y; }, a, b);
}
inline Mask operator>(const Lanes& a, const Lanes& b) { return b < a; }
inline Mask operator>=(const Lanes& a, const Lanes& b) { return b <= a; }
inline Mask operator==(const Lanes& a, const Lanes& b) {
    return detail::partwise<Mask>([](Register x, Register y) { return x == y; }, a, b);
}
inline Mask operator&(const Mask& a, const Mask& b) {
    return detail::partwise<Mask>([](RegisterMask x, RegisterMask y) { return x & y; }, a, b);
}
inline Mask operator|(const Mask& a, const Mask& b) {
    return detail::partwise<Mask>([](RegisterMask x, RegisterMask y) { return x | y; }, a, b);
}
inline Mask operator!(const Mask& a) {
    return detail::partwise<Mask>([](RegisterMask x) { return ~x; }, a);
}

inline LaneBits bits(const Mask& mask) {
    LaneBits result = 0;
    for (int i = 0; i < registerCount; ++i) result |= detail::bitsOf(mask.part[i]) << (i * registerLanes);
    return result;
}
inline Mask maskOf(LaneBits bits) {
    Mask mask;
    for (int part = 0; part < registerCount; ++part) {
        RegisterMask place;
        for (int i = 0; i < registerLanes; ++i) place[i] = 1 << (part * registerLanes + i);
        mask.part[part] = (((RegisterMask{} + static_cast<int>(bits)) & place) == place);
    }
    return mask;
}
inline bool any(const Mask& mask) { return bits(mask) != 0; }
inline bool all(const Mask& mask) { return bits(mask) == allLanes; }

inline Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
    return detail::partwise<Lanes>(detail::choose, mask, yes, no);
}
inline Mask select(const Mask& mask, const Mask& yes, const Mask& no) {
    return (mask & yes) | ((!mask) & no);
}
inline Lanes sqrt(const Lanes& x) { return detail::partwise<Lanes>(detail::sqrtOf, x); }
inline Lanes abs(const Lanes& a) {
    const auto one = [](Register x) {
        return reinterpret_cast<Register>(reinterpret_cast<RegisterMask>(x) & ~detail::signBit());
    };
    return detail::partwise<Lanes>(one, a);
}
inline Lanes copysign(const Lanes& magnitude, const Lanes& sign) {
    const auto one = [](Register x, Register y) {
        return reinterpret_cast<Register>((reinterpret_cast<RegisterMask>(x) & ~detail::signBit()) |
                                          (reinterpret_cast<RegisterMask>(y) & detail::signBit()));
    };
    return detail::partwise<Lanes>(one, magnitude, sign);
}
// As std::max and std::min have it: the first where they are equal or one is NaN.
inline Lanes max(const Lanes& a, const Lanes& b) { return detail::partwise<Lanes>(detail::larger, b, a); }
inline Lanes min(const Lanes& a, const Lanes& b) { return detail::partwise<Lanes>(detail::smaller, b, a); }

// The least lane, and the greatest.
inline Real least(const Lanes& x) {
    Register result = x.part[0];
    for (int i = 1; i < registerCount; ++i) result = detail::smaller(result, x.part[i]);
    return detail::least(result);
}
inline Real greatest(const Lanes& x) { return -least(-x); }

// The least lanes of three, one after the other; the fourth number means nothing.
inline void storeLeast(const Vec3T<Lanes>& v, double (&to)[4]) {
#if defined(RAYTRACER_LANES_avx2) && defined(RAYTRACER_PRECISION_double)
    static_assert(registerCount == 2);
    const Register x = detail::smaller(v.x.part[0], v.x.part[1]),
                   y = detail::smaller(v.y.part[0], v.y.part[1]),
                   z = detail::smaller(v.z.part[0], v.z.part[1]);
    const Register xy =
        detail::smaller(__builtin_shufflevector(x, y, 0, 4, 2, 6), __builtin_shufflevector(x, y, 1, 5, 3, 7));
    const Register zz = detail::smaller(z, __builtin_shufflevector(z, z, 1, 0, 3, 2));
    const Register all = detail::smaller(__builtin_shufflevector(xy, zz, 0, 1, 4, 5),
                                         __builtin_shufflevector(xy, zz, 2, 3, 6, 7));
    std::memcpy(to, &all, sizeof to);
#else
    for (int axis = 0; axis < 3; ++axis) to[axis] = static_cast<double>(least(v[axis]));
#endif
}

// Lane i is numbers[i].
inline Lanes lanesOf(const Real (&numbers)[laneCount]) {
    Lanes result;
    std::memcpy(&result, numbers, sizeof result);
    return result;
}
inline void store(const Lanes& x, Real (&numbers)[laneCount]) { std::memcpy(numbers, &x, sizeof x); }

inline void setLane(Mask& mask, int lane, bool value) {
    mask.part[lane / registerLanes][lane % registerLanes] = value ? -1 : 0;
}
inline Real laneOf(const Lanes& x, int lane) { return x.part[lane / registerLanes][lane % registerLanes]; }
inline void setLane(Lanes& x, int lane, Real value) {
    x.part[lane / registerLanes][lane % registerLanes] = value;
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

// The number of each ray's face or triangle.
struct LanePrimitives {
    std::uint32_t of[laneCount];
};
inline Mask equals(const LanePrimitives& a, std::uint32_t b) {
    LaneBits bits = 0;
    for (int i = 0; i < laneCount; ++i) bits |= static_cast<LaneBits>(a.of[i] == b) << i;
    return maskOf(bits);
}
template <class Function>
void forEachLane(const LanePrimitives& primitives, Function function) {
    for (int i = 0; i < laneCount; ++i) function(i, primitives.of[i]);
}
inline std::uint32_t faceOf(const LanePrimitives& primitives) { return primitives.of[0]; }

template <class Result>
struct OneLaneAfterTheOther {
    template <class Function, class... Arguments>
    static Result call(Function function, const Arguments&... arguments) {
        Result result;
        for (int i = 0; i < laneCount; ++i) setLane(result, i, function(laneOf(arguments, i)...));
        return result;
    }
};

}  // namespace RAYTRACER_LANES_NAMESPACE

template <>
struct PrimitiveOf<Lanes> {
    using type = LanePrimitives;
};
template <>
struct LaneByLane<Lanes> : OneLaneAfterTheOther<Lanes> {};
template <int n>
struct LaneByLane<glm::vec<n, Lanes, glm::defaultp>>
    : OneLaneAfterTheOther<glm::vec<n, Lanes, glm::defaultp>> {};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer

// A Lanes is a number to GLM.
template <>
class std::numeric_limits<raytracer::Lanes> : public std::numeric_limits<raytracer::Real> {};
