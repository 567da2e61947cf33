// What --target-error and --target-time say on stderr.
#pragma once

#include "raytracer/accuracy/target_error.h"
#include "raytracer/accuracy/target_time.h"

namespace raytracer::commands {

// Chooses the setting, says which, and puts it into the options.
TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target);
// `command`: the command line without --target-time.
TimeChoice chooseForTimeAndTell(const Renderer& renderer, RenderOptions& options, double seconds,
                                const std::string& command);

}  // namespace raytracer::commands
