// What the commands' command lines have in common.
#pragma once

#include <functional>
#include <optional>

#include <CLI/CLI.hpp>

#include "raytracer/grading/compare.h"

namespace raytracer::commands {

// Parses the command line. Where the process is to end with that, its exit status: 0 for --help, 2 for wrong
// usage (CLI11 has numbers of its own above 100), which has been said on stderr.
std::optional<int> parseArguments(CLI::App& app, int argc, char** argv);

// Runs the command; bad input and usage end it with one line on stderr and 2.
int reportErrors(const std::function<int()>& command);

// --max-pixels, --tolerance, --min-score: the options that decide what counts as the same picture.
void addThresholds(CLI::App& app, Thresholds& thresholds);

}  // namespace raytracer::commands
