#include "raytracer/accuracy/target_error.h"

#include <algorithm>

#include "depth.h"
#include "picture_points.h"

namespace raytracer {

// A pixel's own estimate is mostly two to nine times its error (bench/README.md): `adaptive` is a promise.
TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target) {
    const double area = static_cast<double>(options.size.width) * options.size.height;
    const auto count = static_cast<std::size_t>(std::clamp(area / 20, 1000.0, 20000.0));
    const Setting deepest{.max_recursion = 24, .cutoff = std::min(0.1, target), .bilinear = options.bilinear};
    Depths depths(renderer, options, picturePoints(options.size, count, 1), deepest);
    const double cutoffs[] = {deepest.cutoff, 3 * deepest.cutoff, 10 * deepest.cutoff};
    const std::vector<DepthChoice> front = depths.front(cutoffs, target / 3);
    const DepthChoice& depth = front.back();
    TargetChoice choice;
    choice.setting = {usualSamples(target), target, depth.max_recursion, depth.cutoff, options.bilinear};
    choice.depthError = depth.error;
    choice.reached = depth.error <= target;
    choice.rays = depths.raysSpent();
    return choice;
}

}  // namespace raytracer
