// Chooses a setting that reaches a target error, from pilot samples of the scene itself.
#pragma once

#include <cstdint>
#include <functional>

#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

struct TargetChoice {
    Setting setting;
    bool reached = false;    // whether its error is within the target, as far as the pilot samples tell
    bool isLimited = false;  // reached is not known: deeper rays are too many to follow
    // Estimates of its parts, RMSE, whose squares add up. That of the samples includes a standard error,
    // since the search ends where it is small by chance.
    double sampleError = 0, depthError = 0;
    RenderCounts counts;  // of the pilot samples
    FirstSamples first;   // of the picture, if the pilot samples include them: for Renderer::render
};

// Is told, now and then, how many samples the search has taken.
using SearchListener = std::function<void(std::uint64_t samples)>;

// `target` is an RMSE, of 1, in linear light after clamping, before rounding to bytes, against samples and
// depth without end. The choice is for the whole picture, whatever the crop; it does not depend on threads or
// machine.
TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target,
                           const SearchListener& listener = {});

}  // namespace raytracer
