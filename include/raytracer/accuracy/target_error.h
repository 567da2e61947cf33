// Chooses a setting that reaches a target error, from a look at the scene itself.
#pragma once

#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

struct TargetChoice {
    Setting setting;
    bool reached = false;   // whether its error is estimated to be within the target
    double depthError = 0;  // the truncation error
    double rays = 0;        // that the look took
};

// `target` is an RMSE, of 1, in linear light after clamping, against the picture with many more samples and
// deeper recursion. Depends on the scene, the size and the target, not on the crop, threads or machine.
TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target);

}  // namespace raytracer
