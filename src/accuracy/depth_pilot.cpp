#include "depth_pilot.h"

#include <cmath>

namespace raytracer {

DepthPilot::DepthPilot(const Renderer& renderer, const RenderOptions& options,
                       std::span<const PixelPlace> pixels, const Setting& deepest)
    : deepest_(deepest.max_recursion) {
    spent_ = rayCount(renderer.rayTrees(withSetting(options, deepest), pixels, trees_));
    for (std::size_t pixel = 0; pixel < pixels.size(); ++pixel) {
        const std::span<const RayTreeNode> rays = trees_.of(pixel);
        if (rays.size() > 1) deep_.push_back(pixel);
        else ofOneRay_ += 1 + rays[0].shadows;
    }
}

const DepthChoice& DepthPilot::measured(int max_recursion, double cutoff) {
    std::vector<DepthChoice>& choices = measured_[cutoff];
    if (choices.empty()) choices = measure(cutoff);
    return choices[static_cast<std::size_t>(max_recursion)];
}

// One pass over the rays measures every max_recursion.
std::vector<DepthChoice> DepthPilot::measure(double cutoff) const {
    const auto depths = static_cast<std::size_t>(deepest_) + 1;
    std::vector<double> rays(depths, 0);  // that are traced from this max_recursion on
    rays[0] = ofOneRay_;
    // Sums of squared errors and of their squares: of pixels that change with a larger max_recursion, and of
    // pixels that do not.
    std::vector<glm::dvec2> changing(depths, glm::dvec2(0)), converged(depths, glm::dvec2(0));
    std::vector<glm::dvec3> color(depths);
    for (const std::size_t pixel : deep_) {
        glm::dvec3 terminated(0);
        std::size_t top = 0;
        color[0] = glm::dvec3(0);
        for (const RayTreeNode& ray : trees_.of(pixel)) {
            const int least = leastRecursion(trees_, ray, cutoff);
            if (least > deepest_) {
                terminated += ray.light;
                continue;
            }
            const auto depth = static_cast<std::size_t>(least);
            while (top < depth) color[++top] = glm::dvec3(0);
            color[depth] += ray.light;
            rays[depth] += 1 + ray.shadows;
        }
        for (std::size_t depth = 1; depth <= top; ++depth) color[depth] += color[depth - 1];
        const glm::dvec3 deepest = color[top] + terminated;
        for (std::size_t depth = 0; depth <= top; ++depth) {
            const double error = squaredError(color[depth], deepest);
            (depth < top ? changing : converged)[depth] += glm::dvec2(error, error * error);
        }
    }
    std::vector<DepthChoice> choices;
    glm::dvec2 whole(0);
    double traced = 0;
    for (std::size_t depth = 0; depth < depths; ++depth) {
        whole += converged[depth];
        traced += rays[depth];
        const glm::dvec2 sums = changing[depth] + whole;
        const ErrorEstimate error = rootOf(meanOf(sums.x, sums.y, pixelCount()));
        choices.push_back({static_cast<int>(depth), cutoff, traced / static_cast<double>(pixelCount()),
                           error.rmse, error.standardError});
    }
    return choices;
}

double DepthPilot::distance(const DepthChoice& a, const DepthChoice& b) {
    const auto [found, isNew] =
        distances_.try_emplace({{a.max_recursion, a.cutoff}, {b.max_recursion, b.cutoff}});
    if (!isNew) return found->second;
    double sum = 0;
    for (const std::size_t pixel : deep_)
        sum += squaredError(prunedPixel(trees_, pixel, a.max_recursion, a.cutoff).color,
                            prunedPixel(trees_, pixel, b.max_recursion, b.cutoff).color);
    return found->second = std::sqrt(sum / static_cast<double>(pixelCount()));
}

}  // namespace raytracer
