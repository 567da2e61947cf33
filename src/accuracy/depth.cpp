#include "depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "picture_points.h"

namespace raytracer {

namespace {

// How much a reflection changes a sample, roughly.
constexpr double reflection = 0.25;

// The fewest points that tell; in a tiny picture one to each pixel.
std::size_t fewestPoints(const ImageSize& size) {
    return std::min(fewestPilots,
                    static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
}

// So many that they show a reflection in as few places as make the target's error; in a small picture, some
// to each pixel.
std::size_t pointsFor(double target, double pixels, std::size_t fewest) {
    const auto least = static_cast<double>(fewest);
    return static_cast<std::size_t>(
        std::clamp(std::pow(reflection / target, 2), least, std::max(least, errorMargin * pixels)));
}

// From one that takes nothing from the target to one that takes most reflections away.
std::vector<double> cutoffsFor(double target) {
    std::vector<double> cutoffs{rounded(target / errorMargin)};
    while (cutoffs.back() < reflection) cutoffs.push_back(rounded(cutoffs.back() * errorMargin));
    return cutoffs;
}

// Empty where they are too many.
std::vector<glm::dvec3> colorsAt(const Renderer& renderer, const RenderOptions& options,
                                 std::span<const glm::dvec2> points, RenderCounts& spent) {
    std::vector<glm::dvec3> colors(points.size());
    try {
        spent += renderer.renderPoints(options, points, colors);
        return colors;
    } catch (const TooManyRays&) {
        return {};
    }
}

// How deep ray trees are followed, and whether they go on where the rays would be too many.
struct Deepest {
    Setting setting;
    bool isLimited = false;
};

// As deep as makes a difference, or as ray trees can be.
Deepest deepest(const Renderer& renderer, const RenderOptions& options, double target, int limit,
                std::span<const glm::dvec2> points, RenderCounts& spent) {
    // Through clear glass nothing is seen before the ray leaves the last layer, and that is no end of the
    // depth.
    constexpr int layers = 8;
    Setting setting{.max_recursion = std::min(layers, limit),
                    .cutoff = cutoffsFor(target).front(),
                    .bilinear = options.bilinear};
    auto colors = colorsAt(renderer, withSetting(options, setting), points, spent);
    while (setting.max_recursion > 0 && 2 * setting.max_recursion <= limit) {
        Setting deeper = setting;
        deeper.max_recursion *= 2;
        auto next = colorsAt(renderer, withSetting(options, deeper), points, spent);
        if (next.empty()) return {setting, true};
        setting = deeper;
        if (pictureError(colors, next).rmse * errorMargin <= target) return {setting};
        colors = std::move(next);
    }
    return {setting, limit < mostRecursion};
}

// A picture's error falls about as its rays grow, and what a depth leaves of the target is the samples'.
DepthChoice cheapest(const std::vector<DepthChoice>& depths, double target) {
    return *std::ranges::min_element(depths, {}, [&](const DepthChoice& depth) {
        const double left = target * target - depth.squaredError - standardErrors * depth.standardError;
        return left > 0 ? depth.rays / std::sqrt(left) : std::numeric_limits<double>::infinity();
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
    std::vector<glm::dvec3> light;  // that comes from this max_recursion on
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
                Setting deepest, const std::vector<double>& cutoffs) {
    for (;; deepest.max_recursion /= 2) {
        Depths depths(deepest, cutoffs);
        try {
            depths.add(renderer, options, points);
            return depths;
        } catch (const TooManyRays&) {
        }
    }
}

DepthChoice chooseDepth(const Renderer& renderer, const RenderOptions& options, double target, double pixels,
                        RenderCounts& spent, int limit) {
    if (options.pass != Pass::Color)
        return {.max_recursion = Setting{}.max_recursion};  // these have no depth
    const std::size_t fewest = fewestPoints(options.size);
    const std::vector<glm::dvec2> points = picturePoints(options.size, pointsFor(target, pixels, fewest), 3);
    const auto few = std::span(points).first(fewest);
    const Deepest deep = deepest(renderer, options, target, limit, few, spent);
    const Depths depths = depthsAt(renderer, options, points, deep.setting, cutoffsFor(target));
    spent += depths.counts();
    DepthChoice choice = cheapest(depths.all(), target);
    choice.isLimited = deep.isLimited || depths.deepest() < deep.setting.max_recursion;
    return choice;
}

}  // namespace raytracer
