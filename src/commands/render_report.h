// What `raytracer SCENE ...` tells of its work, and of what it takes where that is more than its author may
// think.
#pragma once

#include <string>

#include "raytracer/accuracy/target_error.h"
#include "raytracer/accuracy/target_time.h"
#include "raytracer/tracer/render_options.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/util/stopwatch.h"
#include "render_arguments.h"

namespace raytracer::commands {

struct Timings {
    Seconds load, build, choose, render, write;
    double wall() const { return load.wall + build.wall + choose.wall + render.wall + write.wall; }
};

// --stats: JSON on standard output.
void printStats(const RenderCounts& counts, const Timings& timings, const RenderOptions& options);

// Where the limit on samples decided more than a few of so many pixels.
void tellLimited(const RenderCounts& counts, const RenderOptions& options, double pixels, bool quiet);

// "out.png: 600 × 600, 0.06 s", for who waits at a terminal.
void tellDone(const std::string& out, const PixelRectangle& crop, double seconds, bool quiet);

// Says how many rays a deep recursion casts, where they are many.
void remarkOnRays(const RenderArguments& arguments, const SceneDescription& scene, const Renderer& renderer,
                  const RenderOptions& options);

// Says how long the picture, or this part of it, takes, where that is long.
void remarkOnTime(const RenderArguments& arguments, const Renderer& renderer, const RenderOptions& options);

// Says how long so many frames take after the first one, where that is long.
void remarkOnFrames(const RenderArguments& arguments, int more, double secondsOfFirst);

// "under 0.01 s", "4.50 s", "12 min", "3.5 h", "2.1 days".
std::string durationInWords(double seconds);

// That --watch goes on, for who waits at a terminal.
void tellWaiting(bool quiet);

// --target-error and --target-time, on stderr.
//
// Chooses the setting, says which unless `quiet`, and puts it into the options.
TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target, bool quiet);
// `command`: the command line without --target-time; empty: says nothing.
TimeChoice chooseForTimeAndTell(const Renderer& renderer, RenderOptions& options, double seconds,
                                const std::string& command);

}  // namespace raytracer::commands
