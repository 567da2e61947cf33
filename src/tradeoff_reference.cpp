// The converged picture that errors are measured against.
#include <algorithm>
#include <cmath>

#include "raytracer/tradeoff.h"

namespace raytracer {

namespace {

// Without one, glass in which both the reflected and the refracted ray go on doubles its rays with each bounce, long after
// they stopped to matter. The bound on what this leaves out is part of the report.
constexpr double referenceCutoff = 1e-5;

// A recursion twice as deep changes less than this: a tenth of the least error that the grid reaches, of which it is half a
// percent, since the squares add up.
constexpr double deepEnough = 1e-4;

int convergedDepth(const Renderer& renderer, const RenderOptions& options) {
    Pilot pilot(renderer, options, scatteredPixels(options.crop, 2000, 3));
    int depth = 4;
    const auto at = [](int d) { return Setting{.max_recursion = d, .cutoff = referenceCutoff}; };
    while (depth < 64 && pilot.error(at(depth), at(2 * depth)).rmse > deepEnough) depth *= 2;
    return depth;
}

std::vector<glm::dvec3> colorsOf(const Renderer& renderer, const RenderOptions& options, RenderCounts* counts = nullptr) {
    ColorSink sink(options.crop);
    const RenderCounts counted = renderer.render(options, sink);
    if (counts) *counts = counted;
    return sink.colors();
}

}  // namespace

Reference makeReference(const Renderer& renderer, const RenderOptions& options, int samples) {
    Reference reference;
    reference.setting = {.samples = 2 * samples, .max_recursion = convergedDepth(renderer, options), .cutoff = referenceCutoff};
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
