// Options and checks that several commands share.
#pragma once

#include <span>
#include <string>

#include "command_line.h"
#include "raytracer/grading/compare.h"

namespace raytracer::commands {

constexpr Range longEdgeRange{1, 65536};

// Throws Error, about the file, if there is too little memory for a band of the picture.
void requirePictureFits(const std::string& file, const PixelRectangle& crop, bool isPfm);

// Throws Error if `out` is one of the inputs, or a folder with one of them. Empty names are no files.
void refuseInput(const std::string& out, std::span<const std::string> inputs);

// Throws Error if `out` lies in one of the folders, of which all is read.
void refuseInside(const std::string& out, std::span<const std::string> folders);

// Throws Error if two of these are one file. Empty names are no files.
void refuseSameOutput(std::span<const std::string> outputs);

// Whether the name has the ending of a picture.
bool isPictureName(const std::string& name);

// The message for arguments that are two pictures, which were meant for `compare`; else empty.
std::string comparisonMeant(std::span<const std::string> arguments);

// Adds --quiet, for a command whose exit status is the result.
void addSilence(CommandLine& line, bool& quiet);

// Adds --threads.
void addThreads(CommandLine& line, int& threads);

// Adds --max-pixels, --tolerance and --min-score, which decide what counts as the same picture.
void addThresholds(CommandLine& line, Thresholds& thresholds);

// The text of --version, in lines: version and commit, the instruction sets, the precisions.
std::string versionText();

// The version of the code: two programs with the same one make the same pictures.
std::string programVersion();

}  // namespace raytracer::commands
