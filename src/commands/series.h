// A picture in several runs, or several pictures in one: --part and --frames.
#pragma once

#include <string>
#include <vector>

#include "raytracer/pictures/part_file.h"
#include "render_arguments.h"

namespace raytracer::commands {

// The options --part and --frames.
void addPartsAndFramesTo(CommandLine& line, std::string& part, std::string& frames);

// "K/N". Throws Error.
PicturePart parsePart(const std::string& text);

// The file of a part of the picture `out`: "out.png.part-3-of-7".
std::string partName(const std::string& out, const PicturePart& part);

// All options that change the picture, as a command line has them.
std::string pictureOptions(const RenderArguments& arguments, const RenderOptions& options);

// Which part of which picture this is. Throws Error where a file of the scene cannot be read again.
PartHead partHead(const RenderArguments& arguments, const RenderOptions& options, const PicturePart& part,
                  const std::vector<std::string>& sceneFiles);

struct Frames {
    int first = 0, last = 0;
};

// "A..B". Throws Error.
Frames parseFrames(const std::string& text);

// The name of a frame's picture: "film-%04d.png" becomes "film-0007.png". Throws Error unless there is one
// such place.
std::string frameName(const std::string& name, int frame);

// A value of --set at a frame: each {a..b} is a number that runs from a at the first frame to b at the one
// after the last.
std::string atFrame(const std::string& set, const Frames& frames, int frame);

// Throws Error where a value of --set has what is no range but is meant as one: "{0-1}", "{0..", "0..1".
// A comma between two numbers is meant as a range only with --frames.
void refuseNearRanges(const std::vector<std::string>& sets, bool hasFrames);

// Throws Error where the picture's name, or a value of --set, is for frames.
void refuseFrames(const std::string& out, const std::vector<std::string>& sets);

}  // namespace raytracer::commands
