// Arc tangent and arc cosine against libm's in long double.
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <random>

#include "raytracer/numerics/elementary.h"

using namespace raytracer;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// In units of the last place of the result.
double errorOf(double result, long double exact) {
    const double unit = std::nextafter(std::abs(result), infinity) - std::abs(result);
    return static_cast<double>(std::abs(result - exact) / unit);
}

struct RandomNumber {
    std::mt19937_64 bits{29};
    double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(bits); }
};

}  // namespace

TEST_CASE("the arc tangent is wrong by less than 1.2 units in the last place, at any magnitude") {
    RandomNumber random;
    double worst = 0;
    for (int i = 0; i < 300'000; ++i) {
        const double exponent = random(-1020, 1020);
        const double x = std::exp2(exponent) * random(-1, 1);
        const double y = std::exp2(i % 2 == 0 ? exponent : exponent + random(-40, 3)) * random(-1, 1);
        worst = std::max(worst, errorOf(arcTangent(y, x), std::atan2(static_cast<long double>(y), x)));
    }
    CHECK(worst < 1.2);
}

TEST_CASE("the arc tangent of axes, diagonals, zeros, infinities and NaN is std::atan2's") {
    const double numbers[] = {0,     -0.0,   1,   -1,   3e-320,   -3e-320,  1e-300,
                              1e300, -1e300, 0.5, 1e15, infinity, -infinity};
    for (const double y : numbers)
        for (const double x : numbers) {
            INFO(y << ", " << x);
            CHECK(arcTangent(y, x) == std::atan2(y, x));
            CHECK(std::signbit(arcTangent(y, x)) == std::signbit(std::atan2(y, x)));
        }
    CHECK(std::isnan(arcTangent(std::nan(""), 1.0)));
    CHECK(std::isnan(arcTangent(1.0, std::nan(""))));
}

TEST_CASE("the arc cosine is wrong by less than 2.5 units in the last place, and exact at -1, 0 and 1") {
    RandomNumber random;
    double worst = 0;
    for (int i = 0; i < 300'000; ++i) {
        const double small = std::exp2(random(-50, 0)), z = i % 3 == 0   ? small
                                                            : i % 3 == 1 ? 1 - small
                                                                         : small - 1;
        worst = std::max(worst, errorOf(arcCosine(z), std::acos(static_cast<long double>(z))));
    }
    CHECK(worst < 2.5);
    for (const double z : {-1.0, 0.0, 1.0}) CHECK(arcCosine(z) == std::acos(z));
}
