// The messages of `raytracer SCENE ...`: results, and warnings
// if a picture takes longer than its author may expect.
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

// Reports that --samples stopped more than 0.1 % of `pixels` pixels before --adaptive was reached.
void tellLimited(const RenderCounts& counts, const RenderOptions& options, double pixels, bool quiet);

// Prints "out.png: 600 × 600, 0.06 s", if standard error is a terminal.
void tellDone(const std::string& out, const PixelRectangle& crop, double seconds, bool quiet);

// Warns if a deep recursion casts very many rays, and says how many.
void remarkOnRays(const RenderArguments& arguments, const SceneDescription& scene, const Renderer& renderer,
                  const RenderOptions& options);

// Warns if the picture, or this part of it, takes long, and says how long.
void remarkOnTime(const RenderArguments& arguments, const Renderer& renderer, const RenderOptions& options);

// Warns if the `more` frames after the first one take long, and says how long.
void remarkOnFrames(const RenderArguments& arguments, int more, double secondsOfFirst);

// "under 0.01 s", "4.50 s", "12 min", "3.5 h", "2.1 days".
std::string durationInWords(double seconds);

// Says that --watch waits for a change, if standard error is a terminal.
void tellWaiting(bool quiet);

// For --target-error: chooses the setting, puts it into the options, and reports it on stderr.
TargetChoice chooseAndTell(const RenderArguments& arguments, const Renderer& renderer, RenderOptions& options,
                           double target);
// The same for --target-time. `command` is the command line without --target-time.
TimeChoice chooseForTimeAndTell(const RenderArguments& arguments, const Renderer& renderer,
                                RenderOptions& options, double seconds, const std::string& command);

}  // namespace raytracer::commands
