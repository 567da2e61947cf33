// The converged picture that errors are measured against.
#include <algorithm>
#include <cmath>

#include "raytracer/accuracy/tradeoff.h"

namespace raytracer {

namespace {

// Only for glass in which both the reflected and the refracted ray go on, and double with each bounce long
// after they stopped to matter: where that would take so many times the rays. The bound on what this leaves
// out is part of the report.
constexpr double glassCutoff = 1e-5, tooDear = 4;

// A recursion twice as deep changes less than this: a tenth of the least error that the grid reaches, of
// which it is half a percent, since the squares add up.
constexpr double deepEnough = 1e-4;

// One sample, converged in depth.
Setting deepSetting(const Renderer& renderer, const RenderOptions& options) {
    Pilot pilot(renderer, options, scatteredPixels(options.crop, 2000, 3));
    const auto at = [](int depth, double cutoff) {
        return Setting{.max_recursion = depth, .cutoff = cutoff};
    };
    int deep = 4;
    while (deep < 64 && pilot.error(at(deep, glassCutoff), at(2 * deep, glassCutoff)).rmse > deepEnough)
        deep *= 2;
    for (int depth = 4; depth <= deep;
         depth *= 2)  // from the cheapest on, which the next one at most squares
        if (pilot.rays(at(depth, 0)) > tooDear * pilot.rays(at(depth, glassCutoff)))
            return at(deep, glassCutoff);
    return at(deep, 0);
}

std::vector<glm::dvec3> colorsOf(const Renderer& renderer, const RenderOptions& options,
                                 RenderCounts* counts = nullptr) {
    ColorSink sink(options.crop);
    const RenderCounts counted = renderer.render(options, sink);
    if (counts) *counts = counted;
    return sink.colors();
}

}  // namespace

Reference makeReference(const Renderer& renderer, const RenderOptions& options, int samples) {
    Reference reference;
    reference.setting = deepSetting(renderer, options);
    reference.setting.samples = 2 * samples;
    reference.half = reference.setting;
    reference.half.samples = static_cast<int>(std::lround(2 * samples / std::sqrt(2.0)));
    RenderCounts counts;
    reference.colors = colorsOf(renderer, withSetting(options, reference.setting), &counts);
    reference.cutoffBound = counts.cutoffBound;
    reference.doublingError =
        pictureError(colorsOf(renderer, withSetting(options, reference.half)), reference.colors).rmse;
    return reference;
}

}  // namespace raytracer
