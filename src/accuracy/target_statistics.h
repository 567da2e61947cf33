// The statistics of --target-error.
#pragma once

#include <cmath>

#include "raytracer/accuracy/picture_error.h"

namespace raytracer {

// An upper confidence limit of an error, s standard errors up. The error comes from few pixels: its mean
// square has a relative standard error of k^-1/2, as if k pixels had equal errors and the others none.
// Gehrels's upper limit of a count of k ("Confidence limits for small numbers of events in astrophysical
// data", 1986, eq. 10 with its first term of 1/k) is k + s sqrt(k + 3/4) + (s^2 + 3) / 4.
inline double upperLimit(double error, double standardError, double s) {
    if (!(standardError > 0)) return error;
    if (!(error > 0)) return s * standardError;
    const double k = std::pow(error / (2 * standardError), 2);
    return error * std::sqrt(1 + (s * std::sqrt(k + 0.75) + (s * s + 3) / 4) / k);
}

// In standard errors. More than one picture in ten above the target asks for, since the cheapest setting that
// seems to reach it is chosen for seeming better than it is.
inline constexpr double margin = 1.6, sureMargin = 2;

inline bool isWithin(const ErrorEstimate& error, double errors, double target) {
    return upperLimit(error.rmse, error.standardError, errors) <= target;
}

// Of two nearly independent errors: their squares add up.
inline ErrorEstimate together(const ErrorEstimate& a, const ErrorEstimate& b) {
    const double rmse = std::hypot(a.rmse, b.rmse);
    return {rmse, rmse > 0 ? std::hypot(a.rmse * a.standardError, b.rmse * b.standardError) / rmse : 0};
}

// The geometric mean of two numbers below 1, to one digit.
inline double roundedMean(double a, double b) {
    if (a == b) return a;
    const double mean = std::sqrt(a * b), digit = std::pow(10, -std::floor(std::log10(mean)));
    return std::round(mean * digit) / digit;
}

}  // namespace raytracer
