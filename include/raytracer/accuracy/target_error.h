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
    bool isLimited = false;  // rays beyond some depth are too many to trace; `reached` is then false
    // The two parts of the estimated error, each an RMSE; their squares add up. sampleError includes one
    // standard error, since the search tends to stop where the estimate is too small by chance.
    double sampleError = 0, depthError = 0;
    RenderCounts counts;  // of the pilot samples
    FirstSamples first;   // for Renderer::render; empty if the pilot samples do not include them
};

// Called from time to time with the number of samples that the search has taken.
using SearchListener = std::function<void(std::uint64_t samples)>;

// `target` is the wanted RMSE, where 1 is the full range: in linear light, after clamping, before rounding to
// bytes, against infinitely many samples and unlimited depth. The choice is for the whole picture, whatever
// the crop. It depends neither on the threads nor on the machine.
TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target,
                           const SearchListener& listener = {});

}  // namespace raytracer
