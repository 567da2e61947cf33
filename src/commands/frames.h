// --frames: pictures of an animation.
#pragma once

#include <string>
#include <vector>

namespace raytracer::commands {

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

// Throws Error where the picture's name, or a value of --set, is for frames.
void refuseFrames(const std::string& out, const std::vector<std::string>& sets);

}  // namespace raytracer::commands
