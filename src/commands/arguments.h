// What the commands' command lines have in common.
#pragma once

#include <span>
#include <string>

#include "command_line.h"
#include "raytracer/grading/compare.h"

namespace raytracer::commands {

constexpr Range longEdgeRange{1, 65536};

// Throws Error, about the file, where the memory is too small for a band of the picture.
void requirePictureFits(const std::string& file, const PixelRectangle& crop, bool isPfm);

// Throws Error where writing `out` would replace a regular file that is among the inputs. Empty: no file.
void refuseInput(const std::string& out, std::span<const std::string> inputs);

// Throws Error where two of these would be written to one regular file. Empty: no file.
void refuseSameOutput(std::span<const std::string> outputs);

// Whether it is the name of a picture, by its ending.
bool isPictureName(const std::string& name);

// What is said of two pictures alone, which are to be compared; else empty.
std::string comparisonMeant(std::span<const std::string> arguments);

// --quiet of a command whose exit status tells what matters.
void addSilence(CommandLine& line, bool& quiet);

// --threads.
void addThreads(CommandLine& line, int& threads);

// --max-pixels, --tolerance, --min-score: the options that decide what counts as the same picture.
void addThresholds(CommandLine& line, Thresholds& thresholds);

// Which program this is.
//
// Lines: version and commit, the instruction sets that there is code for, the precisions.
std::string versionText();

// Of the code: two programs of one version make the same pictures.
std::string programVersion();

}  // namespace raytracer::commands
