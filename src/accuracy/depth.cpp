#include "depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "picture_points.h"

namespace raytracer {

namespace {

// Roughly how much a reflection changes a sample.
constexpr double reflection = 0.25;

// How many points to trace. A reflection that covers (target / reflection)^2 of the picture makes an RMSE of
// `target`: there are enough points that one is expected to fall on it, but at most errorMargin per pixel.
std::size_t pointsFor(double target, double pixels, double fewest) {
    return static_cast<std::size_t>(
        std::clamp(std::pow(reflection / target, 2), fewest, std::max(fewest, errorMargin * pixels)));
}

// From a cutoff with a negligible error to one that removes most reflections.
std::vector<double> cutoffsFor(double target) {
    std::vector<double> cutoffs{rounded(target / errorMargin)};
    while (cutoffs.back() < reflection) cutoffs.push_back(rounded(cutoffs.back() * errorMargin));
    return cutoffs;
}

// Doubles max_recursion until that changes these points by a negligible error, or until the limit or the
// number of rays forbids it. `isLimited` tells whether something deeper may be missing.
Depths depthsFor(const Renderer& renderer, const RenderOptions& options, double target, int limit,
                 std::span<const glm::dvec2> points, RenderCounts& spent, bool& isLimited) {
    // The search starts at this depth. Layers of clear glass show nothing until the ray has left the last
    // one, so that an unchanged picture at a smaller depth does not mean that it has converged.
    constexpr int layers = 16;
    const std::vector<double> cutoffs = cutoffsFor(target);
    Setting deepest{
        .max_recursion = std::min(layers, limit), .cutoff = cutoffs.front(), .bilinear = options.bilinear};
    for (;; deepest.max_recursion *= 2) {
        Depths depths = depthsAt(renderer, options, points, deepest, cutoffs, spent);
        isLimited = depths.deepest().max_recursion < std::max(deepest.max_recursion, layers);
        if (isLimited) return depths;
        const double change = depths.measured(deepest.max_recursion / 2, deepest.cutoff).squaredError;
        if (std::sqrt(change) * errorMargin <= target) return depths;
        isLimited = limit < mostRecursion;
        if (2 * deepest.max_recursion > limit) return depths;
    }
}

// The choice that makes the picture cheapest. The samples may have the error that the depth leaves of the
// target, and a picture's sampling error falls about as 1 / its rays. If no depth leaves any: the best depth.
DepthChoice cheapest(const std::vector<DepthChoice>& depths, double target) {
    return *std::ranges::min_element(depths, {}, [&](const DepthChoice& depth) {
        const double left = depth.leftOf(target);
        const double cost = left > 0 ? depth.rays / std::sqrt(left) : std::numeric_limits<double>::infinity();
        return std::pair(cost, depth.squaredError);
    });
}

}  // namespace

Depths::Depths(const Setting& deepest, std::vector<double> cutoffs)
    : deepest_(deepest),
      cutoffs_(std::move(cutoffs)),
      sums_(cutoffs_.size(), std::vector<Sums>(static_cast<std::size_t>(deepest.max_recursion) + 1)) {}

void Depths::add(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
                 RenderCounts& spent) {
    constexpr std::size_t together = 512;  // trees at a time: a few MB of memory
    for (std::size_t begin = 0; begin < points.size(); begin += together) {
        const auto some = points.subspan(begin, std::min(together, points.size() - begin));
        RayTrees trees;
        spent += renderer.rayTrees(withSetting(options, deepest_), some, trees);
        for (std::size_t point = 0; point < some.size(); ++point)
            for (std::size_t i = 0; i < cutoffs_.size(); ++i) measure(trees, point, cutoffs_[i], sums_[i]);
    }
    points_ += static_cast<double>(points.size());
}

// One pass over a tree measures every max_recursion.
void Depths::measure(const RayTrees& trees, std::size_t point, double cutoff, std::span<Sums> sums) {
    if (const auto rays = trees.of(point); rays.size() == 1) {  // no bounce: every depth is exact
        sums[0].rays += 1 + rays[0].shadows;
        return;
    }
    std::vector<glm::dvec3> light;  // by max_recursion: the light that it adds to the next smaller one's
    glm::dvec3 deepest(0);
    for (const RayTreeNode& ray : trees.of(point)) {
        deepest += ray.light;
        const int least = leastRecursion(trees, ray, cutoff);
        if (least > deepest_.max_recursion) continue;
        const auto depth = static_cast<std::size_t>(least);
        if (depth >= light.size()) light.resize(depth + 1);
        light[depth] += ray.light;
        sums[depth].rays += 1 + ray.shadows;
    }
    glm::dvec3 color(0);
    for (std::size_t depth = 0; depth < light.size(); ++depth) {
        const bool isLast = depth + 1 == light.size();
        color += light[depth];
        const double error = squaredError(color, deepest);
        (isLast ? sums[depth].lastSquares : sums[depth].squares) += error;
        (isLast ? sums[depth].lastFourths : sums[depth].fourths) += error * error;
    }
}

DepthChoice Depths::measured(int max_recursion, double cutoff) const {
    const auto& sums =
        sums_[static_cast<std::size_t>(std::ranges::find(cutoffs_, cutoff) - cutoffs_.begin())];
    const Sums& depth = sums[static_cast<std::size_t>(max_recursion)];
    double rays = 0, squares = depth.squares, fourths = depth.fourths;
    for (int i = 0; i <= max_recursion; ++i) {
        const Sums& until = sums[static_cast<std::size_t>(i)];
        rays += until.rays;
        squares += until.lastSquares;
        fourths += until.lastFourths;
    }
    const double mean = squares / points_;
    return {max_recursion, max_recursion == 0 ? 0 : cutoff, rays / points_, mean,
            std::sqrt(std::max(0.0, fourths / points_ - mean * mean) / points_)};
}

std::vector<DepthChoice> Depths::all() const {
    std::vector<DepthChoice> choices;
    for (const double cutoff : cutoffs_)
        for (int depth = 0; depth <= deepest_.max_recursion; ++depth)
            choices.push_back(measured(depth, cutoff));
    return choices;
}

Depths depthsAt(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
                Setting deepest, const std::vector<double>& cutoffs, RenderCounts& spent) {
    for (;; deepest.max_recursion /= 2) {
        Depths depths(deepest, cutoffs);
        try {
            depths.add(renderer, options, points, spent);
            return depths;
        } catch (const TooManyRays& tooMany) {
            spent += tooMany.cast();
        }
    }
}

DepthChoice chooseDepth(const Renderer& renderer, const RenderOptions& options, double target, double pixels,
                        RenderCounts& spent, int limit) {
    if (options.pass != Pass::Color)
        return {.max_recursion = Setting{}.max_recursion};  // other passes do not recurse
    target = std::min(target, 1.0);                         // no error is larger
    // A tiny picture gets one point per pixel.
    const double fewest = std::min(fewestPilots, double(options.size.width) * options.size.height);
    const std::vector<glm::dvec2> points = picturePoints(options.size, pointsFor(target, pixels, fewest), 3);
    bool isLimited = false;
    const auto few = std::span(points).first(static_cast<std::size_t>(fewest));
    Depths depths = depthsFor(renderer, options, target, limit, few, spent, isLimited);
    if (points.size() > few.size()) {
        const Setting deepest = depths.deepest();
        depths = depthsAt(renderer, options, points, deepest, cutoffsFor(target), spent);
        isLimited = isLimited || depths.deepest().max_recursion < deepest.max_recursion;
    }
    DepthChoice choice = cheapest(depths.all(), target);
    choice.isLimited = isLimited;
    return choice;
}

}  // namespace raytracer
