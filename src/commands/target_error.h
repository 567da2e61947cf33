// What --target-error says on stderr.
#pragma once

#include "raytracer/accuracy/target_error.h"

namespace raytracer::commands {

// Chooses the setting, says which, and puts it into the options.
TargetChoice chooseAndTell(const Renderer& renderer, RenderOptions& options, double target);

}  // namespace raytracer::commands
