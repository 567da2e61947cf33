// What `raytracer SCENE ...` tells of its work.
#pragma once

#include <string>

#include "raytracer/tracer/render_options.h"
#include "raytracer/util/stopwatch.h"

namespace raytracer::commands {

struct Timings {
    Seconds load, build, choose, render, write;
};

// --stats: JSON on standard output.
void printStats(const RenderCounts& counts, const Timings& timings, const RenderOptions& options);

// Where the limit on samples decided more than a few of so many pixels.
void tellLimited(const RenderCounts& counts, const RenderOptions& options, double pixels);

// "out.png: 600 × 600, 0.06 s", for who waits at a terminal.
void tellDone(const std::string& out, const PixelRectangle& crop, const Timings& timings);

}  // namespace raytracer::commands
