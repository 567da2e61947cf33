// What --target-error and --target-time say on stderr.
#pragma once

#include "raytracer/accuracy/target_error.h"
#include "raytracer/accuracy/target_time.h"

namespace raytracer::commands {

// Chooses the setting, says which unless `quiet`, and puts it into the options.
TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target, bool quiet);
// `command`: the command line without --target-time; empty: says nothing.
TimeChoice chooseForTimeAndTell(const Renderer& renderer, RenderOptions& options, double seconds,
                                const std::string& command);

}  // namespace raytracer::commands
