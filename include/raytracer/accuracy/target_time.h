// Chooses the most accurate setting whose picture takes about a given time, from pilot samples of the scene
// itself.
#pragma once

#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

struct TimeChoice {
    Setting setting;
    double seconds = 0;                      // estimated wall time of the picture
    double sampleError = 0, depthError = 0;  // estimated parts of its error, RMSE; their squares add up
    RenderCounts counts{};                   // of the pilot samples
};

// `seconds` is wall time with options.threads, the pilot samples included. The choice depends on the machine
// and its load. If no setting is fast enough, the coarsest is chosen.
TimeChoice chooseForTime(const Renderer& renderer, const RenderOptions& options, double seconds);

}  // namespace raytracer
