// One setting of the knobs that trade speed for accuracy, and which of many are worth having.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "raytracer/render_options.h"

namespace raytracer {

// The defaults are the command line's.
struct Setting {
    int samples = 1;
    double adaptive = 0;
    int max_recursion = 3;
    double cutoff = 0;
    bool bilinear = false;
    Precision precision = Precision::Double;

    bool operator==(const Setting&) const = default;
};

// `options` with the setting's knobs.
RenderOptions withSetting(RenderOptions options, const Setting& setting);

// The setting as options of the command line: "--samples 4 --cutoff 0.1"; "the defaults" where all have theirs.
std::string commandLine(const Setting& setting);

// A number as short as three digits tell it: "0.1", "3e-05".
std::string shortNumber(double value);

const char* precisionName(Precision precision);

// Rays of every kind: what a setting costs, as a number that does not depend on the machine or its load.
double rayCount(const RenderCounts& counts);

// What a setting costs (in any unit) and how far off its picture is.
struct CostAndError {
    double cost = 0, error = 0;
};

// The points that no other one beats in both, from the cheapest to the most accurate: indices into `points`. Of equal
// points the first.
std::vector<std::size_t> paretoFront(std::span<const CostAndError> points);

}  // namespace raytracer
