// What all benchmarks report: the middle one of several timings.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

// The upper one of the two in the middle of an even number; of one at least.
inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}
