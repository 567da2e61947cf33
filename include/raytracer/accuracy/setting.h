// One setting of the knobs that trade speed for accuracy, and which of many are worth having.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "raytracer/tracer/render_options.h"

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

// The setting as options of the command line: "--samples 4 --cutoff 0.1"; "the defaults" where all have
// theirs.
std::string commandLine(const Setting& setting);

// A number as short as three digits tell it: "0.1", "3e-05".
std::string shortNumber(double value);

const char* precisionName(Precision precision);

// Rays of every kind: what a setting costs, as a number that does not depend on the machine or its load.
double rayCount(const RenderCounts& counts);

// The values of each knob that `tradeoff` measures; `--target-error` chooses from these and from some between
// them. Samples: steps of the number of rays by no more than 4, later about 2. Depth: to where 0.9 per bounce
// leaves 1/12. Adaptive and cutoff: by a half of a power of ten, from what is lost in the error of few
// samples to what only many samples can see.
inline constexpr int gridSamples[] = {1, 2, 3, 4, 6, 8, 12, 16};
inline constexpr double gridAdaptive[] = {0, 0.03, 0.1, 0.3};
inline constexpr int gridDepths[] = {0, 1, 2, 3, 4, 6, 8, 12, 16, 24};
inline constexpr double gridCutoffs[] = {0.01, 0.03, 0.1, 0.3, 1};

// What a setting costs (in any unit) and how far off its picture is.
struct CostAndError {
    double cost = 0, error = 0;
};

// The points that no other one beats in both, from the cheapest to the most accurate: indices into `points`.
// Of equal points the first.
std::vector<std::size_t> paretoFront(std::span<const CostAndError> points);

}  // namespace raytracer
