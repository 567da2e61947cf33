// What the commands' command lines have in common.
#pragma once

#include <functional>

#include "command_line.h"
#include "raytracer/grading/compare.h"

namespace raytracer::commands {

// Runs the command; bad input and usage end it with one line on stderr and 2.
int reportErrors(const std::function<int()>& command);

constexpr Range longEdgeRange{1, 65536};

// --threads.
void addThreads(CommandLine& line, int& threads);

// --max-pixels, --tolerance, --min-score: the options that decide what counts as the same picture.
void addThresholds(CommandLine& line, Thresholds& thresholds);

}  // namespace raytracer::commands
