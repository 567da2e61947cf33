// Eight numbers side by side in the processor's vector registers: floats for the boxes of a tree, Reals for
// the rays of a packet (ray_lanes.h).
//
// Every operation is IEEE's in each lane, so a lane has the very bits that a single Number would have. The
// exceptions are multiplyAdd and multiplySubtract: they are rounded once where the processor can, else twice.
// This file is compiled once for each instruction set, into a namespace of its own (lane_registers.h).
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "raytracer/numerics/lane_registers.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {

inline constexpr LaneBits allLanes = (LaneBits{1} << laneCount) - 1;

namespace detail {

template <class Result, class Operation, class... Arguments>
inline Result partwise(Operation operation, const Arguments&... arguments) {
    Result result;
    for (int i = 0; i < Result::parts; ++i) result.part[i] = operation(arguments.part[i]...);
    return result;
}

}  // namespace detail

template <class Number>
struct LanesOf;

template <class Number>
struct MaskOf {
    using Register = typename RegistersOf<Number>::Mask;
    static constexpr int parts = RegistersOf<Number>::count, partLanes = RegistersOf<Number>::lanes;

    Register part[parts];

    static MaskOf ofBits(LaneBits bits) {
        MaskOf mask;
        for (int p = 0; p < parts; ++p) detail::setBits(mask.part[p], bits >> (p * partLanes));
        return mask;
    }
    friend LaneBits bits(const MaskOf& mask) {
        LaneBits result = 0;
        for (int i = 0; i < parts; ++i) result |= detail::bitsOf(mask.part[i]) << (i * partLanes);
        return result;
    }
    friend MaskOf operator&(const MaskOf& a, const MaskOf& b) {
        return detail::partwise<MaskOf>([](Register x, Register y) { return static_cast<Register>(x & y); },
                                        a, b);
    }
    friend MaskOf operator|(const MaskOf& a, const MaskOf& b) {
        return detail::partwise<MaskOf>([](Register x, Register y) { return static_cast<Register>(x | y); },
                                        a, b);
    }
    friend MaskOf operator!(const MaskOf& a) {
        return detail::partwise<MaskOf>([](Register x) { return static_cast<Register>(~x); }, a);
    }
    friend bool any(const MaskOf& mask) { return bits(mask) != 0; }
    friend bool all(const MaskOf& mask) { return bits(mask) == allLanes; }
    friend void setLane(MaskOf& mask, int lane, bool value) {
        detail::setLane(mask.part[lane / partLanes], lane % partLanes, value);
    }
    friend LanesOf<Number> select(const MaskOf& mask, const LanesOf<Number>& yes, const LanesOf<Number>& no) {
        return detail::partwise<LanesOf<Number>>(
            [](auto m, auto x, auto y) { return detail::choose(m, x, y); }, mask, yes, no);
    }
};

template <class Number>
struct LanesOf {
    using Mask = MaskOf<Number>;
    using Register = typename RegistersOf<Number>::Register;
    using Bits = typename RegistersOf<Number>::Bits;
    static constexpr int parts = Mask::parts, partLanes = Mask::partLanes;

    Register part[parts];

    LanesOf() = default;
    LanesOf(Number x) {
        for (Register& p : part) p = x - Register{};
    }
    // Lane i is numbers[i].
    static LanesOf load(const Number* numbers) {
        LanesOf result;
        std::memcpy(&result, numbers, sizeof result);
        return result;
    }
    friend void store(const LanesOf& x, Number (&numbers)[laneCount]) { std::memcpy(numbers, &x, sizeof x); }
    // Each lane as an integer, rounded towards zero.
    friend std::array<std::int32_t, laneCount> truncated(const LanesOf& x) {
        using Integers [[gnu::vector_size(partLanes * sizeof(std::int32_t))]] = std::int32_t;
        std::array<std::int32_t, laneCount> result;
        for (int i = 0; i < parts; ++i) {
            const Integers whole = __builtin_convertvector(x.part[i], Integers);
            std::memcpy(&result[i * partLanes], &whole, sizeof whole);
        }
        return result;
    }
    friend Number laneOf(const LanesOf& x, int lane) { return x.part[lane / partLanes][lane % partLanes]; }
    friend void setLane(LanesOf& x, int lane, Number value) {
        x.part[lane / partLanes][lane % partLanes] = value;
    }

    friend LanesOf operator+(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<LanesOf>([](Register x, Register y) { return x + y; }, a, b);
    }
    friend LanesOf operator-(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<LanesOf>([](Register x, Register y) { return x - y; }, a, b);
    }
    friend LanesOf operator*(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<LanesOf>([](Register x, Register y) { return x * y; }, a, b);
    }
    friend LanesOf operator/(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<LanesOf>([](Register x, Register y) { return x / y; }, a, b);
    }
    friend LanesOf operator-(const LanesOf& a) {
        return detail::partwise<LanesOf>([](Register x) { return -x; }, a);
    }
    friend LanesOf& operator+=(LanesOf& a, const LanesOf& b) { return a = a + b; }
    friend LanesOf& operator-=(LanesOf& a, const LanesOf& b) { return a = a - b; }
    friend LanesOf& operator*=(LanesOf& a, const LanesOf& b) { return a = a * b; }
    friend LanesOf& operator/=(LanesOf& a, const LanesOf& b) { return a = a / b; }

    friend Mask operator<(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<Mask>([](Register x, Register y) { return detail::isLess(x, y); }, a, b);
    }
    friend Mask operator<=(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<Mask>([](Register x, Register y) { return detail::isAtMost(x, y); }, a, b);
    }
    friend Mask operator>(const LanesOf& a, const LanesOf& b) { return b < a; }
    friend Mask operator>=(const LanesOf& a, const LanesOf& b) { return b <= a; }
    friend Mask operator==(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<Mask>([](Register x, Register y) { return detail::isEqual(x, y); }, a, b);
    }

    friend LanesOf sqrt(const LanesOf& a) {
        return detail::partwise<LanesOf>([](Register x) { return detail::sqrtOf(x); }, a);
    }
    friend LanesOf abs(const LanesOf& a) {
        const auto one = [](Register x) {
            return reinterpret_cast<Register>(reinterpret_cast<Bits>(x) & ~signBit());
        };
        return detail::partwise<LanesOf>(one, a);
    }
    friend LanesOf copysign(const LanesOf& magnitude, const LanesOf& sign) {
        const auto one = [](Register x, Register y) {
            return reinterpret_cast<Register>((reinterpret_cast<Bits>(x) & ~signBit()) |
                                              (reinterpret_cast<Bits>(y) & signBit()));
        };
        return detail::partwise<LanesOf>(one, magnitude, sign);
    }
    // As std::max and std::min: the first where they are equal or one is NaN.
    friend LanesOf max(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<LanesOf>([](Register x, Register y) { return detail::larger(y, x); }, a, b);
    }
    friend LanesOf min(const LanesOf& a, const LanesOf& b) {
        return detail::partwise<LanesOf>([](Register x, Register y) { return detail::smaller(y, x); }, a, b);
    }
    // a b + c and a b - c.
    friend LanesOf multiplyAdd(const LanesOf& a, const LanesOf& b, const LanesOf& c) {
        return detail::partwise<LanesOf>(
            [](Register x, Register y, Register z) { return detail::multiplyAdd(x, y, z); }, a, b, c);
    }
    friend LanesOf multiplySubtract(const LanesOf& a, const LanesOf& b, const LanesOf& c) {
        return detail::partwise<LanesOf>(
            [](Register x, Register y, Register z) { return detail::multiplySubtract(x, y, z); }, a, b, c);
    }

    // The least lane, and the greatest.
    friend Number least(const LanesOf& x) {
        Register all = x.part[0];
        for (int i = 1; i < parts; ++i) all = detail::smaller(all, x.part[i]);
        Number result = all[0];
        for (int i = 1; i < partLanes; ++i) result = all[i] < result ? all[i] : result;
        return result;
    }
    friend Number greatest(const LanesOf& x) { return -least(-x); }

  private:
    static Bits signBit() { return reinterpret_cast<Bits>(-Register{}); }
};

// max, min and >, for pairs of lanes of which at least one is not negative.
inline LanesOf<float> later(const LanesOf<float>& a, const LanesOf<float>& b) {
    return detail::partwise<LanesOf<float>>([](auto x, auto y) { return detail::later(x, y); }, a, b);
}
inline LanesOf<float> earlier(const LanesOf<float>& a, const LanesOf<float>& b) {
    return detail::partwise<LanesOf<float>>([](auto x, auto y) { return detail::earlier(x, y); }, a, b);
}
inline MaskOf<float> isLater(const LanesOf<float>& a, const LanesOf<float>& b) {
    return detail::partwise<MaskOf<float>>([](auto x, auto y) { return detail::isLater(x, y); }, a, b);
}

inline LanesOf<float> integers(const std::uint16_t* numbers) {
    LanesOf<float> result;
    for (detail::Floats& part : result.part) {
        part = detail::integers(numbers);
        numbers += LanesOf<float>::partLanes;
    }
    return result;
}

// For each word, the highest bit after a shift to the left by `below`.
inline LaneBits topBits(const std::uint32_t (&words)[laneCount], int below) {
    MaskOf<float> mask;
    for (int i = 0; i < mask.parts; ++i) {
        detail::FloatsBits part;
        std::memcpy(&part, &words[i * mask.partLanes], sizeof part);
        mask.part[i] = detail::topBits(part, below);
    }
    return bits(mask);
}

}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
