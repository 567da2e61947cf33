#include "depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "picture_points.h"
#include "systematic_sampling.h"

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
        Depths depths(renderer, options, points, deepest, cutoffs, spent);
        isLimited = depths.deepest().max_recursion < std::max(deepest.max_recursion, layers);
        if (isLimited) return depths;
        const double change = depths.measured(deepest.max_recursion / 2, deepest.cutoff).squaredError;
        if (std::sqrt(change) * errorMargin <= target) return depths;
        isLimited = limit < mostRecursion;
        if (2 * deepest.max_recursion > limit) return depths;
    }
}

// The choice that makes the picture cheapest. The samples may have the error that the depth leaves of the
// target, and a picture's sampling error falls about as 1 / its rays. The deepest leaves all of it.
DepthChoice cheapest(const std::vector<DepthChoice>& depths, double target) {
    return *std::ranges::min_element(depths, {}, [&](const DepthChoice& depth) {
        const double left = depth.leftOf(target);
        return left > 0 ? depth.rays / std::sqrt(left) : std::numeric_limits<double>::infinity();
    });
}

}  // namespace

Depths::Depths(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
               const Setting& deepest, std::vector<double> cutoffs, RenderCounts& spent,
               std::span<const double> weights)
    : deepest_(deepest), cutoffs_(std::move(cutoffs)), points_(static_cast<double>(points.size())) {
    for (;; deepest_.max_recursion /= 2) {
        sums_.assign(cutoffs_.size(),
                     std::vector<Sums>(static_cast<std::size_t>(deepest_.max_recursion) + 1));
        try {
            trace(renderer, options, points, spent, weights);
            return;
        } catch (const TooManyRays& tooMany) {
            spent += tooMany.cast();
        }
    }
}

void Depths::trace(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
                   RenderCounts& spent, std::span<const double> weights) {
    constexpr std::size_t together = 512;  // trees at a time: a few MB of memory
    for (std::size_t begin = 0; begin < points.size(); begin += together) {
        const auto some = points.subspan(begin, std::min(together, points.size() - begin));
        RayTrees trees;
        spent += renderer.rayTrees(withSetting(options, deepest_), some, trees);
        for (std::size_t point = 0; point < some.size(); ++point)
            for (std::size_t i = 0; i < cutoffs_.size(); ++i)
                measure(trees, point, weights.empty() ? 1 : weights[begin + point], cutoffs_[i], sums_[i]);
    }
}

// One pass over a tree measures every max_recursion.
void Depths::measure(const RayTrees& trees, std::size_t point, double weight, double cutoff,
                     std::span<Sums> sums) {
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
        const double error = weight * squaredError(color, deepest);
        (isLast ? sums[depth].lastSquares : sums[depth].squares) += error;
        (isLast ? sums[depth].lastFourths : sums[depth].fourths) += error * error;
    }
}

DepthChoice Depths::measured(int max_recursion, double cutoff) const {
    const std::size_t i =
        max_recursion == 0 ? 0
                           : static_cast<std::size_t>(std::ranges::find(cutoffs_, cutoff) - cutoffs_.begin());
    const auto& sums = sums_[i];
    const Sums& depth = sums[static_cast<std::size_t>(max_recursion)];
    double rays = 0, squares = depth.squares, fourths = depth.fourths;
    for (int d = 0; d <= max_recursion; ++d) {
        const Sums& until = sums[static_cast<std::size_t>(d)];
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

DepthSearch::DepthSearch(const Renderer& renderer, const RenderOptions& options, double target, double pixels,
                         RenderCounts& spent, int limit)
    : renderer_(renderer),
      options_(options),
      target_(std::min(target, 1.0)),  // no error is larger
      spent_(spent) {
    if (options.pass == Pass::Color) measure(pixels, limit);
    else choice_.max_recursion = Setting{}.max_recursion;  // other passes do not recurse
}

void DepthSearch::measure(double pixels, int limit) {
    // A tiny picture gets one point per pixel.
    const double fewest = std::min(fewestPilots, double(options_.size.width) * options_.size.height);
    const std::vector<glm::dvec2> points =
        picturePoints(options_.size, pointsFor(target_, pixels, fewest), PointsFor::depth);
    bool isLimited = false;
    const auto few = std::span(points).first(static_cast<std::size_t>(fewest));
    depths_ = depthsFor(renderer_, options_, target_, limit, few, spent_, isLimited);
    if (points.size() > few.size()) {
        const Setting deepest = depths_->deepest();
        depths_.emplace(renderer_, options_, points, deepest, cutoffsFor(target_), spent_);
        isLimited = isLimited || depths_->deepest().max_recursion < deepest.max_recursion;
    }
    choice_ = cheapest(depths_->all(), target_);
    choice_.isLimited = isLimited;
}

DepthChoice DepthSearch::confirmed(std::span<const float> leftOut) {
    const auto most = [&](std::size_t i) {
        return std::pow(std::min(1.0, static_cast<double>(leftOut[i])), 2);
    };
    double total = 0;  // of the pixels' squared errors, at most
    for (std::size_t i = 0; i < leftOut.size(); ++i) total += most(i);
    const auto pixels = static_cast<double>(leftOut.size());
    if (std::sqrt(total / pixels) * errorMargin <= target_) return choice_;

    // A pixel has one tree, however often it is drawn.
    const double step = total / std::max(fewestPilots, total / pixels / (target_ * target_));
    const auto width = static_cast<std::size_t>(options_.size.width);
    std::vector<glm::dvec2> points;
    std::vector<double> weights;
    drawSystematically(leftOut.size(), step, step / 2, most, [&](std::size_t i, double weight, double draws) {
        points.push_back(glm::dvec2(i % width, i / width) + SampleSequence(options_.sequence)[0]);
        weights.push_back(draws * step / (pixels * weight));
    });
    for (double& weight : weights) weight *= static_cast<double>(weights.size());  // Depths takes the mean
    const Depths here(renderer_, options_, points, depths_->deepest(), cutoffsFor(target_), spent_, weights);
    // Another depth takes another first sample of each pixel.
    const double enough = std::min(choice_.leftOf(target_), target_ * target_ / 2);
    std::vector<DepthChoice> choices;
    for (DepthChoice choice : here.all()) {
        if (choice.max_recursion < choice_.max_recursion) continue;
        if (choice_.cutoff > 0 && choice.cutoff > choice_.cutoff) continue;
        choice.rays = depths_->measured(choice.max_recursion, choice.cutoff).rays;
        choice.isLimited =
            choice_.isLimited || here.deepest().max_recursion < depths_->deepest().max_recursion;
        if (choice.isSameAs(choice_) && choice.leftOf(target_) >= enough) return choice;
        choices.push_back(choice);
    }
    if (!choices.empty()) return cheapest(choices, target_);
    choice_.isLimited = true;  // here fewer bounces can be followed than it has
    return choice_;
}

}  // namespace raytracer
