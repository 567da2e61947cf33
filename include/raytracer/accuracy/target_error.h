// The cheapest setting whose picture is as accurate as asked for, found by a pilot render of the very scene.
#pragma once

#include <functional>
#include <optional>

#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

struct TargetChoice {
    Setting setting;
    bool reached = false;      // not estimated to be above what was asked for by more than a standard error
    double error = 0;          // estimated RMSE of the whole picture, of 1, in linear light
    double standardError = 0;  // of that estimate
    double sampleError = 0,
           depthError = 0;  // its two parts: between the samples, and of rays that are not followed
    double rays = 0;        // for each pixel of the picture

    std::optional<Setting>
        cheaper;  // the cheapest that may reach it too, within two standard errors; its error and cost
    double cheaperError = 0, cheaperRays = 0;

    std::size_t pilotPixels = 0;
    double pilotRays = 0;  // what the search cost, in all; but not the picture's

    std::optional<RenderCounts>
        rendered;  // of the very picture, where finding out took all of it: it is in the sink
};

// `target` is an RMSE, of 1, in linear light after clamping; the truth is the picture with many more samples
// and deeper recursion. Chooses by counted rays, so that the same command makes the same picture on every
// machine. What is in the sink afterwards means nothing unless the choice says so. Tells what it would choose
// so far, whenever it has looked at more.
using ChoiceSoFar = std::function<void(const TargetChoice&)>;
TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target,
                           PixelSink& sink, const ChoiceSoFar& tell = {});

}  // namespace raytracer
