// What --target-error says on stderr.
#pragma once

#include "raytracer/accuracy/target_error.h"

namespace raytracer::commands {

// Picks the setting, says which and why, and puts it into the options. Shows how far it is on a terminal,
// unless `quiet`.
TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target, PixelSink& sink,
                           bool quiet);

// After the render: the error that it is estimated to have, and whether that is what was asked for.
bool tellOutcome(const TargetChoice& choice, double target);

}  // namespace raytracer::commands
