// Finds the cheapest setting that reaches a target error, by pilot renders of the scene itself.
#pragma once

#include <functional>
#include <optional>

#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

struct TargetChoice {
    Setting setting;
    bool reached = false;                    // the error less one standard error is within the target
    double error = 0;                        // estimated RMSE of the whole picture, of 1, in linear light
    double standardError = 0;                // of that estimate
    double sampleError = 0, depthError = 0;  // its parts: sampling error and truncation error
    double rays = 0;                         // per pixel of the picture

    // The cheapest setting that may reach the target too, within two standard errors.
    std::optional<Setting> cheaper;
    double cheaperError = 0, cheaperRays = 0;

    std::size_t pilotPixels = 0;
    double pilotRays = 0;  // of the whole search, without the picture's

    // Set if the search rendered the whole picture: then the sink has it.
    std::optional<RenderCounts> rendered;
};

// `target` is an RMSE, of 1, in linear light after clamping, against the picture with many more samples and
// deeper recursion. The cost is counted in rays, so that the same command makes the same picture on every
// machine. The sink holds the picture only if the choice's `rendered` is set. `report` gets the best choice
// so far after each round of pilot renders.
using ChoiceListener = std::function<void(const TargetChoice&)>;
TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target,
                           PixelSink& sink, const ChoiceListener& report = {});

}  // namespace raytracer
