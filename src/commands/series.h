// One picture in several runs (--part), or several pictures in one run (--frames).
#pragma once

#include <string>
#include <vector>

#include "raytracer/pictures/part_file.h"
#include "render_arguments.h"

namespace raytracer::commands {

// Adds the options --part and --frames.
void addPartsAndFramesTo(CommandLine& line, std::string& part, std::string& frames);

// Reads "K/N". Throws Error.
PicturePart parsePart(const std::string& text);

// The file of a part of the picture `out`: "out.png.part-3-of-7".
std::string partName(const std::string& out, const PicturePart& part);

// All options that change the picture, written as on a command line.
std::string pictureOptions(const RenderArguments& arguments, const RenderOptions& options);

// The head of a part's file: which part of which picture it is.
// Throws Error if a file of the scene cannot be read again.
PartHead partHead(const RenderArguments& arguments, const RenderOptions& options, const PicturePart& part,
                  const std::vector<std::string>& sceneFiles);

struct Frames {
    int first = 0, last = 0;
};

// Reads "A..B". Throws Error.
Frames parseFrames(const std::string& text);

// The name of a frame's picture: "film-%04d.png" becomes "film-0007.png". Throws Error unless the name has
// one such placeholder.
std::string frameName(const std::string& name, int frame);

// A value of --set at a frame: each {a..b} is a number that runs from a at the first frame to b at the one
// after the last.
std::string atFrame(const std::string& set, const Frames& frames, int frame);

// Throws Error if a value of --set has something that is meant as a range but
// is none: "{0-1}", "{0..", "0..1". "{0,1}" counts as such only with --frames.
void refuseNearRanges(const std::vector<std::string>& sets, bool hasFrames);

// For a render without --frames: throws Error if the picture's name or a value of --set needs --frames.
void refuseFrames(const std::string& out, const std::vector<std::string>& sets);

}  // namespace raytracer::commands
