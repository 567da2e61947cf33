#include "depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "picture_points.h"

namespace raytracer {

namespace {

constexpr double mostRays = 100;  // of a tree; where it has more, twice the recursion could square them
constexpr double growth = 1.2;    // samples of a pixel: about 1 + (0.013 / error)^1.2
constexpr double oneMore = 0.013;
constexpr double nearly = 1.02;  // in rays

std::vector<double> cutoffsFor(double target) {
    std::vector<double> cutoffs{rounded(target / 4)};
    while (cutoffs.back() < 0.25) cutoffs.push_back(rounded(4 * cutoffs.back()));
    return cutoffs;
}

// As deep as ray trees can be.
Setting deepest(const Renderer& renderer, const RenderOptions& options, double target,
                std::span<const glm::dvec2> few, RenderCounts& spent) {
    Setting setting{.max_recursion = 4, .cutoff = cutoffsFor(target).front(), .bilinear = options.bilinear};
    for (; setting.max_recursion < 64; setting.max_recursion *= 2) {
        Depths depths(setting, {});
        try {
            depths.add(renderer, options, few);
        } catch (const TooManyRays&) {
            setting.max_recursion /= 2;
            break;
        }
        spent += depths.counts();
        if (rayCount(depths.counts()) > mostRays * depths.points()) break;
    }
    return setting;
}

// What a depth leaves of the target decides how many samples the picture takes. Of the depths that cost
// nearly the same, the most accurate.
DepthChoice cheapest(std::span<const DepthChoice> depths, double target) {
    const auto cost = [&](const DepthChoice& depth) {
        const double left = target * target - depth.atMost();
        if (left <= 0) return std::numeric_limits<double>::infinity();
        return depth.rays * (1 + std::pow(oneMore / std::sqrt(left), growth));
    };
    const double enough = nearly * cost(*std::ranges::min_element(depths, {}, cost));
    return *std::ranges::min_element(depths, {}, [&](const DepthChoice& depth) {
        return cost(depth) <= enough ? depth.atMost() : std::numeric_limits<double>::infinity();
    });
}

}  // namespace

Depths::Depths(const Setting& deepest, std::vector<double> cutoffs)
    : deepest_(deepest),
      cutoffs_(std::move(cutoffs)),
      sums_(cutoffs_.size(), std::vector<Sums>(static_cast<std::size_t>(deepest.max_recursion) + 1)) {}

void Depths::add(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points) {
    constexpr std::size_t together = 512;  // trees: some MB of memory
    for (std::size_t begin = 0; begin < points.size(); begin += together) {
        const auto some = points.subspan(begin, std::min(together, points.size() - begin));
        RayTrees trees;
        counts_ += renderer.rayTrees(withSetting(options, deepest_), some, trees);
        for (std::size_t point = 0; point < some.size(); ++point)
            for (std::size_t i = 0; i < cutoffs_.size(); ++i) measure(trees, point, cutoffs_[i], sums_[i]);
    }
    points_ += static_cast<double>(points.size());
}

// One pass over a tree measures every max_recursion.
void Depths::measure(const RayTrees& trees, std::size_t point, double cutoff, std::span<Sums> sums) {
    if (const auto rays = trees.of(point); rays.size() == 1) {  // the same at every depth
        sums[0].rays += 1 + rays[0].shadows;
        return;
    }
    std::vector<glm::dvec3> light(sums.size(), glm::dvec3(0));  // that comes from this max_recursion on
    glm::dvec3 deepest(0);
    std::size_t last = 0;
    for (const RayTreeNode& ray : trees.of(point)) {
        deepest += ray.light;
        const int least = leastRecursion(trees, ray, cutoff);
        if (least > deepest_.max_recursion) continue;
        const auto depth = static_cast<std::size_t>(least);
        light[depth] += ray.light;
        sums[depth].rays += 1 + ray.shadows;
        last = std::max(last, depth);
    }
    glm::dvec3 color(0);
    for (std::size_t depth = 0; depth <= last; ++depth) {
        color += light[depth];
        const double error = squaredError(color, deepest);
        (depth < last ? sums[depth].squares : sums[depth].lastSquares) += error;
        (depth < last ? sums[depth].fourths : sums[depth].lastFourths) += error * error;
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
    return {max_recursion, cutoff, rays / points_, mean,
            std::sqrt(std::max(0.0, fourths / points_ - mean * mean) / points_)};
}

std::vector<DepthChoice> Depths::all() const {
    std::vector<DepthChoice> choices;
    for (const double cutoff : cutoffs_)
        for (int depth = 0; depth <= deepest_.max_recursion; ++depth)
            choices.push_back(measured(depth, cutoff));
    return choices;
}

DepthChoice chooseDepth(const Renderer& renderer, const RenderOptions& options, double target,
                        std::size_t count, RenderCounts& spent) {
    const std::vector<glm::dvec2> points = picturePoints(options.size, count, 3);
    Depths depths(
        deepest(renderer, options, target, std::span(points).first(std::min<std::size_t>(count, 250)), spent),
        cutoffsFor(target));
    depths.add(renderer, options, points);
    spent += depths.counts();
    return cheapest(depths.all(), target);
}

}  // namespace raytracer
