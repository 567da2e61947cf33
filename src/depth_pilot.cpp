#include "depth_pilot.h"

namespace raytracer {

DepthPilot::DepthPilot(const Renderer& renderer, const RenderOptions& options, std::span<const PixelPlace> pixels,
                       const Setting& deepest)
    : deepest_{deepest.max_recursion, deepest.cutoff} {
    spent_ = rayCount(renderer.follow(withSetting(options, deepest), pixels, followed_));
    for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) {
        const std::span<const FollowedRay> rays = followed_.of(pixel);
        if (rays.size() > 1)
            deep_.push_back({pixel, shallower(followed_, pixel, deepest_.max_recursion, deepest_.cutoff).color});
        else
            ofOneRay_ += 1 + rays[0].shadows;
    }
}

DepthChoice DepthPilot::measured(int max_recursion, double cutoff) {
    const Compared& both = compared({max_recursion, cutoff}, deepest_);
    return {max_recursion, cutoff, both.rays, both.error.rmse, both.error.standardError};
}

double DepthPilot::distance(const DepthChoice& a, const DepthChoice& b) {
    return compared({a.max_recursion, a.cutoff}, {b.max_recursion, b.cutoff}).error.rmse;
}

const DepthPilot::Compared& DepthPilot::compared(const Depth& a, const Depth& b) {
    const auto [found, isNew] = compared_.try_emplace({a, b});
    Compared& both = found->second;
    if (!isNew) return both;
    double rays = ofOneRay_;
    std::vector<double> errors(pixelCount(), 0);
    for (const auto& [pixel, deepest] : deep_) {
        const PixelAndRays one = shallower(followed_, pixel, a.max_recursion, a.cutoff);
        rays += one.rays;
        if (one.isWhole && b == deepest_) continue;
        errors[pixel] = squaredError(
            one.color, b == deepest_ ? deepest : shallower(followed_, pixel, b.max_recursion, b.cutoff).color);
    }
    both = {rays / static_cast<double>(pixelCount()), rootOf(meanOf(errors))};
    return both;
}

}  // namespace raytracer
