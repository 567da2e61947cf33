// The measured trade-off of speed and accuracy as text, as charts and as a page.
#pragma once

#include <span>
#include <string>

#include "raytracer/accuracy/tradeoff.h"

namespace raytracer {

// Processor seconds of the default setting, which is always among the trials.
double defaultSeconds(const SceneTradeoff& scene);

// Every trial of both errors, one per line.
std::string tradeoffCsv(std::span<const SceneTradeoff> scenes);

// For the terminal: a scene's reference, its Pareto front and the error of the arithmetic.
std::string tradeoffTable(const SceneTradeoff& scene);

// How the reference was made and how accurate it is, in two or three sentences.
std::string describeReference(const SceneTradeoff& scene);

// One scene's chart: RMSE over processor seconds, log-log. Each setting is a point with a tooltip; the front
// is a line. The result is an <svg> element that takes its colours from the style of the page around it.
std::string tradeoffChart(const SceneTradeoff& scene);

// All scenes' charts in a grid, as an SVG file with its own style, light and dark.
std::string tradeoffSvg(std::span<const SceneTradeoff> scenes);

// One self-contained HTML page: charts, tables, pictures.
std::string tradeoffPage(std::span<const SceneTradeoff> scenes);

}  // namespace raytracer
