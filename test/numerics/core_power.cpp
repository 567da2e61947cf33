// x^n, the highlight.
#include <catch2/catch.hpp>

#include "../support/core_random.h"

using namespace raytracer;

TEST_CASE("a power is right to the digits that the base's own rounding leaves") {
    test::Random random(5);
    for (int i = 0; i < 20'000; ++i) {
        const Real x = static_cast<Real>(1 - std::pow(random.uniform(), 3)),
                   n = static_cast<Real>(random.magnitude(4));
        const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(n));
        const long double bound = (n + 60) * static_cast<long double>(unitRoundoff) * 2 * exact;
        if (exact < std::numeric_limits<Real>::min()) continue;
        INFO(x << "^" << n);
        REQUIRE(std::abs(power(x, n) - exact) <= bound);
    }
}

TEST_CASE("powers of 0 and 1, roots, and exponents that are zero, huge or infinite") {
    for (const Real n : {Real(0), Real(0.5), Real(3), Real(1e20), std::numeric_limits<Real>::max(), infinity})
        CHECK(power(Real(1), n) == 1);
    for (const Real n : {std::numeric_limits<Real>::denorm_min(), Real(0.3), Real(7), infinity})
        CHECK(power(Real(0), n) == 0);
    CHECK(power(Real(0), Real(0)) == 1);
    CHECK(power(Real(0.3), Real(0)) == 1);
    CHECK(power(Real(0.3), Real(0.5)) == std::sqrt(Real(0.3)));
    CHECK(power(Real(0.3), Real(2.25)) == Real(0.3) * Real(0.3) * std::sqrt(std::sqrt(Real(0.3))));
    CHECK(power(1 - unitRoundoff, infinity) == 0);
    CHECK(power(Real(0.999), Real(1e9)) == 0);
}

TEST_CASE("powers that are known") {
    CHECK(power(Real(0), 0) == 1);
    CHECK(power(Real(0), 1) == 0);
    CHECK(power(Real(0.5L), 3) == Real(0.125L));
    CHECK(power(Real(0.5L), 10) == Real(1) / 1024);
    CHECK(power(Real(0.25L), Real(0.5L)) == Real(0.5L));
    CHECK(power(Real(0.75L), 1) == Real(0.75L));
    CHECK(power(Real(1), 1000000) == 1);
    CHECK(power(Real(0.5L), 1000000) == 0);
    CHECK(power(Real(1), static_cast<Real>(1e30)) == 1);
    CHECK(power(1 - unitRoundoff, static_cast<Real>(1e30)) == 0);
    CHECK(power(Real(0.5L), static_cast<Real>(1e300)) == 0);  // infinite in float
    CHECK(power(Real(1), static_cast<Real>(1e300)) == 1);
}
