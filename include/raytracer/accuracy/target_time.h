// Chooses the most accurate setting whose picture takes about a given time, from pilot samples of
// the scene itself.
#pragma once

#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

struct TimeChoice {
    Setting setting;
    double seconds = 0;                      // of wall time that the picture is estimated to take
    double sampleError = 0, depthError = 0;  // estimates of its error's parts, RMSE; their squares add up
    RenderCounts counts;                     // of the pilot samples
};

// `seconds` are of wall time with options.threads, the pilot samples included. The choice depends on the
// machine and what else it does; the coarsest setting is chosen where nothing is as fast.
TimeChoice chooseForTime(const Renderer& renderer, const RenderOptions& options, double seconds);

}  // namespace raytracer
