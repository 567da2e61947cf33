// The converged picture that errors are measured against.
#include <algorithm>
#include <cmath>

#include "raytracer/accuracy/tradeoff.h"

namespace raytracer {

namespace {

// The reference has a cutoff only if it would otherwise take this many times the rays: in glass both the
// reflected and the refracted ray go on, so that rays double with each bounce long after they contribute. The
// report has the bound on the resulting error.
constexpr double glassCutoff = 1e-5, tooManyRays = 4;

// The depth is converged if twice the depth changes the picture by less than this RMSE: a tenth of the
// smallest error that the grid reaches, which is 0.5 % of that error, since squares add up.
constexpr double deepEnough = 1e-4;

// One sample a pixel, converged in depth.
Setting deepSetting(const Renderer& renderer, const RenderOptions& options) {
    Pilot pilot(renderer, options, scatteredPixels(options.crop, 2000, 3));
    const auto at = [](int depth, double cutoff) {
        return Setting{.max_recursion = depth, .cutoff = cutoff};
    };
    int deep = 4;
    while (deep < 64 && pilot.error(at(deep, glassCutoff), at(2 * deep, glassCutoff)).rmse > deepEnough)
        deep *= 2;
    // The cheapest depth first: twice the depth at most squares the number of rays.
    for (int depth = 4; depth <= deep; depth *= 2)
        if (pilot.rays(at(depth, 0)) > tooManyRays * pilot.rays(at(depth, glassCutoff)))
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
