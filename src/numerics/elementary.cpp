#include "raytracer/numerics/elementary.h"

#include <limits>
#include <utility>

namespace raytracer {
namespace {

// A number as an unevaluated sum of two (double-double). `low` is much smaller than `high`: in the table, at
// most half a unit in its last place.
struct Sum {
    double high, low;
};

// atan(k / 16), computed with Taylor's series in integers of 200 bits.
constexpr int arcSteps = 16;
constexpr Sum arcTangents[arcSteps + 1] = {
    {0, 0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};
constexpr Sum quarterTurn{2 * arcTangents[arcSteps].high, 2 * arcTangents[arcSteps].low};
constexpr Sum halfTurn{4 * arcTangents[arcSteps].high, 4 * arcTangents[arcSteps].low};

// a + b for |a.high| >= |b.high|, or a.high = 0 (Dekker 1971, Fast2Sum).
Sum add(const Sum& a, const Sum& b) {
    const double high = a.high + b.high;
    return {high, (a.high - high) + b.high + (a.low + b.low)};
}
Sum subtract(const Sum& a, const Sum& b) { return add(a, {-b.high, -b.low}); }

// atan(small / large) for 0 <= small <= large. With c = k / 16 close to the quotient, it is atan(c) +
// atan(r), r = (small - c large) / (large + c small), |r| <= 1/32. The series for atan(r) stops where its
// next term is below the rounding error.
Sum arcTangentOfQuotient(double small, double large) {
    const long k = std::lround(arcSteps * (small / large));
    const double c = static_cast<double>(k) / arcSteps;
    const double r = std::fma(-c, large, small) / std::fma(c, small, large);
    const double r2 = r * r;
    const double series =
        r * r2 * (-1.0 / 3 + r2 * (1.0 / 5 + r2 * (-1.0 / 7 + r2 * (1.0 / 9 + r2 * (-1.0 / 11 + r2 / 13)))));
    return add(arcTangents[k], {r, series});
}

// Scales both by one power of two, so that products of them neither over- nor underflow.
void bringIntoRange(double& small, double& large) {
    if (large == std::numeric_limits<double>::infinity()) {
        small = small == large ? 1 : 0;
        large = 1;
    }
    const double scale = large > 0x1p900 ? 0x1p-200 : large < 0x1p-800 ? 0x1p200 : 1;
    small *= scale;
    large *= scale;
}

}  // namespace

double arcTangent(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
    double small = std::abs(y), large = std::abs(x);
    const bool steep = small > large;
    if (steep) std::swap(small, large);
    bringIntoRange(small, large);
    Sum angle = large == 0 ? Sum{0, 0} : arcTangentOfQuotient(small, large);
    if (steep) angle = subtract(quarterTurn, angle);
    if (std::signbit(x)) angle = subtract(halfTurn, angle);
    return std::copysign(angle.high + angle.low, y);
}

// By the half angle, whose sine and cosine are sqrt((1 - z) / 2) and sqrt((1 + z) / 2).
double arcCosine(double z) { return 2 * arcTangent(std::sqrt(1 - z), std::sqrt(1 + z)); }

}  // namespace raytracer
