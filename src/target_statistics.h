// What target_error.cpp knows of errors that are seen in a few pixels, against a reference that is none too good.
#pragma once

#include <cmath>

namespace raytracer {

// What an error may be, some standard errors up. It comes from few pixels, as if from k equally wrong ones where the mean
// square has a relative error of k^-1/2. Gehrels's upper limit of a count of k ("Confidence limits for small numbers of
// events in astrophysical data", 1986, eq. 10 with its first term of 1/k): k + s sqrt(k + 3/4) + (s^2 + 3) / 4.
inline double upperLimit(double error, double standardError, double s) {
    if (!(standardError > 0)) return error;
    const double k = std::pow(error / (2 * standardError), 2);
    return error * std::sqrt(1 + (s * std::sqrt(k + 0.75) + (s * s + 3) / 4) / k);
}

// How far from a setting a reference of k times its samples (along an axis) sees it, as a part of how far off it is. With an
// odd k the reference has the setting's samples among its own. Were samples independent, the squares would be 1 - 1/k^2;
// with another k, which shares none, 1 + 1/k^2; were the reference perfect, 1. Half way: it is wrong by 3 % at most (k = 3).
inline double seenPart(int samples, int reference) {
    const double k = static_cast<double>(reference) / samples;
    const bool isShared = reference % samples == 0 && reference / samples % 2 == 1;
    return std::sqrt(1 + (isShared ? -0.5 : 0.5) / (k * k));
}

}  // namespace raytracer
