// Systematic sampling (Cochran, Sampling Techniques, chapter 8): draws at equal steps of the summed weight.
#pragma once

#include <cmath>
#include <cstddef>

namespace raytracer {

// Walks through the items 0, 1, ... and calls take(i, weight, draws) once for each one that is drawn.
// `first`: the summed weight at which the first draw is, less than `step`.
template <class WeightOf, class Take>
void drawSystematically(std::size_t items, double step, double first, WeightOf weightOf, Take take) {
    double sum = 0, next = first;
    for (std::size_t i = 0; i < items; ++i) {
        const double weight = weightOf(i);
        sum += weight;
        if (sum <= next) continue;
        const double draws = std::ceil((sum - next) / step);
        next += draws * step;
        take(i, weight, draws);
    }
}

}  // namespace raytracer
