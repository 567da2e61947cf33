// Settings of the options that trade speed for accuracy, and the Pareto front of several of them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "raytracer/tracer/renderer.h"

namespace raytracer {

// The default of `samples`, which depends on `adaptive`.
constexpr int usualSamples(double adaptive) { return adaptive > 0 ? 256 : 1; }

// A copy of `options` with the setting's values.
RenderOptions withSetting(RenderOptions options, const Setting& setting);

// The setting as options of the command line: "--samples 16 --cutoff 0.1"; "the defaults" for Setting{}.
std::string commandLine(const Setting& setting, Precision precision = Precision::Double);

// A picture's colours, row by row, and what they cost.
struct RenderedColors {
    std::vector<glm::dvec3> colors;
    RenderCounts counts;
};
RenderedColors rendered(const Renderer& renderer, const RenderOptions& options);

// A number to three significant digits, as text ("0.1", "3e-05") and as a number.
std::string shortNumber(double value);
double rounded(double value);

// The values of each option that `tradeoff` measures. `adaptive` and `cutoff` go in steps of half a power of
// ten: from an error typical of few samples to one that only many samples reach.
inline constexpr int gridSamples[] = {1, 4, 16, 64, 256};
inline constexpr double gridAdaptive[] = {0.1, 0.03, 0.01, 0.003, 0.001};
inline constexpr double gridCutoffs[] = {0.01, 0.03, 0.1, 0.3, 1};

// The cost of a setting, in any unit, and the error of its picture.
struct CostAndError {
    double cost = 0, error = 0;
};

// The points that no other point beats in both cost and error, from the cheapest to the most accurate, as
// indices into `points`. Of equal points the first.
std::vector<std::size_t> paretoFront(std::span<const CostAndError> points);

}  // namespace raytracer
