#include "depth.h"

#include <cmath>

namespace raytracer {

Depths::Depths(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
               const Setting& deepest)
    : deepest_(deepest.max_recursion) {
    spent_ = rayCount(renderer.rayTrees(withSetting(options, deepest), points, trees_));
    for (std::size_t point = 0; point < points.size(); ++point) {
        const std::span<const RayTreeNode> rays = trees_.of(point);
        if (rays.size() > 1) deep_.push_back(point);
        else ofOneRay_ += 1 + rays[0].shadows;
    }
}

const DepthChoice& Depths::measured(int max_recursion, double cutoff) {
    std::vector<DepthChoice>& choices = measured_[cutoff];
    if (choices.empty()) choices = measure(cutoff);
    return choices[static_cast<std::size_t>(max_recursion)];
}

// One pass over the rays measures every max_recursion.
std::vector<DepthChoice> Depths::measure(double cutoff) const {
    const auto depths = static_cast<std::size_t>(deepest_) + 1;
    std::vector<double> rays(depths, 0);  // that are traced from this max_recursion on
    rays[0] = ofOneRay_;
    // Sums of squared errors: of points that change with a larger max_recursion, and of points that do not.
    std::vector<double> changing(depths, 0), converged(depths, 0);
    std::vector<glm::dvec3> color(depths);
    for (const std::size_t point : deep_) {
        glm::dvec3 terminated(0);
        std::size_t top = 0;
        color[0] = glm::dvec3(0);
        for (const RayTreeNode& ray : trees_.of(point)) {
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
            (depth < top ? changing : converged)[depth] += error;
        }
    }
    std::vector<DepthChoice> choices;
    const auto count = static_cast<double>(trees_.count());
    double whole = 0, traced = 0;
    for (std::size_t depth = 0; depth < depths; ++depth) {
        whole += converged[depth];
        traced += rays[depth];
        const double sum = changing[depth] + whole;
        choices.push_back({static_cast<int>(depth), cutoff, traced / count, std::sqrt(sum / count)});
    }
    return choices;
}

std::vector<DepthChoice> Depths::front(std::span<const double> cutoffs, double enough) {
    std::vector<DepthChoice> choices;
    // Per cutoff the error at the depth before; 0 if that was deep enough, or deeper than it helps. 2 is more
    // than any error.
    std::vector<double> before(cutoffs.size(), 2);
    for (const int depth : gridDepths) {
        if (depth > deepest_) break;
        for (std::size_t i = 0; i < cutoffs.size(); ++i) {
            if (before[i] == 0 || (depth == 0 && i > 0)) continue;
            choices.push_back(measured(depth, cutoffs[i]));
            const double error = choices.back().error;
            before[i] = error <= enough || (depth > 1 && error > 0.99 * before[i]) ? 0 : error;
        }
    }
    std::vector<CostAndError> points;
    for (const DepthChoice& choice : choices) points.push_back({choice.rays, choice.error});
    std::vector<DepthChoice> front;
    for (const std::size_t i : paretoFront(points)) front.push_back(choices[i]);
    return front;
}

}  // namespace raytracer
