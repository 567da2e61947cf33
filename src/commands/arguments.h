// What the commands' command lines have in common.
#pragma once

#include <span>
#include <string>

#include "command_line.h"
#include "raytracer/grading/compare.h"
#include "raytracer/util/error.h"

namespace raytracer::commands {

// About the command line.
inline Error usageError(const std::string& message) { return {{"raytracer"}, message}; }

constexpr Range longEdgeRange{1, 65536};

// Throws Error, about the file, where the memory is too small for a band of the picture.
void requirePictureFits(const std::string& file, const PixelRectangle& crop, bool isPfm);

// --threads.
void addThreads(CommandLine& line, int& threads);

// --max-pixels, --tolerance, --min-score: the options that decide what counts as the same picture.
void addThresholds(CommandLine& line, Thresholds& thresholds);

}  // namespace raytracer::commands
