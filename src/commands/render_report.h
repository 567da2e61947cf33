// What `raytracer SCENE ...` tells of its work.
#pragma once

#include <string>

#include "raytracer/accuracy/target_error.h"
#include "raytracer/accuracy/target_time.h"
#include "raytracer/tracer/render_options.h"
#include "raytracer/util/stopwatch.h"

namespace raytracer::commands {

struct Timings {
    Seconds load, build, choose, render, write;
    double wall() const { return load.wall + build.wall + choose.wall + render.wall + write.wall; }
};

// --stats: JSON on standard output.
void printStats(const RenderCounts& counts, const Timings& timings, const RenderOptions& options);

// Where the limit on samples decided more than a few of so many pixels.
void tellLimited(const RenderCounts& counts, const RenderOptions& options, double pixels);

// "out.png: 600 × 600, 0.06 s", for who waits at a terminal.
void tellDone(const std::string& out, const PixelRectangle& crop, double seconds, bool quiet);

// --target-error and --target-time, on stderr.
//
// Chooses the setting, says which unless `quiet`, and puts it into the options.
TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target, bool quiet);
// `command`: the command line without --target-time; empty: says nothing.
TimeChoice chooseForTimeAndTell(const Renderer& renderer, RenderOptions& options, double seconds,
                                const std::string& command);

}  // namespace raytracer::commands
