// The measured trade of speed for accuracy as text, as a chart and as a page.
#pragma once

#include <span>
#include <string>

#include "raytracer/accuracy/tradeoff.h"

namespace raytracer {

// What the defaults take; they are always among the settings.
double plainSeconds(const SceneTradeoff& scene);

// Every trial of both questions, a line each.
std::string tradeoffCsv(std::span<const SceneTradeoff> scenes);

// For the terminal: each scene's reference, front and arithmetic.
std::string tradeoffTable(const SceneTradeoff& scene);

// How the reference was made and how far it may be trusted, in two or three sentences.
std::string describeReference(const SceneTradeoff& scene);

// One scene's chart, log-log: RMSE over processor seconds; every setting a point that tells itself, the front
// a line. An <svg> element that takes its colours from the style of the page around it.
std::string tradeoffChart(const SceneTradeoff& scene);

// All scenes' charts in a grid, as an SVG file that brings its style, light and dark.
std::string tradeoffSvg(std::span<const SceneTradeoff> scenes);

// Self-contained: charts, tables, pictures.
std::string tradeoffPage(std::span<const SceneTradeoff> scenes);

}  // namespace raytracer
