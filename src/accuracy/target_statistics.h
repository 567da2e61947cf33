// Numbers of --target-error.
#pragma once

#include <cmath>

#include "raytracer/accuracy/picture_error.h"

namespace raytracer {

// What an error may be, some standard errors up. It comes from few pixels, as if from k equally wrong ones
// where the mean square has a relative error of k^-1/2. Gehrels's upper limit of a count of k ("Confidence
// limits for small numbers of events in astrophysical data", 1986, eq. 10 with its first term of 1/k): k + s
// sqrt(k + 3/4) + (s^2 + 3) / 4.
inline double upperLimit(double error, double standardError, double s) {
    if (!(standardError > 0)) return error;
    if (!(error > 0)) return s * standardError;
    const double k = std::pow(error / (2 * standardError), 2);
    return error * std::sqrt(1 + (s * std::sqrt(k + 0.75) + (s * s + 3) / 4) / k);
}

// Standard errors. With some odds to spare, since only a picture in ten may be above, and the cheapest that
// seems to do is likely to seem better than it is (Notes.txt).
inline constexpr double margin = 1.6, sureMargin = 2;

inline bool isWithin(const ErrorEstimate& error, double errors, double target) {
    return upperLimit(error.rmse, error.standardError, errors) <= target;
}

// Of two errors that hardly know of each other: their squares add up.
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
