// Which settings are tried. Not all combinations of the options: most are far from the Pareto front.
#include <algorithm>

#include "raytracer/accuracy/tradeoff.h"

#include "depth.h"
#include "picture_points.h"

namespace raytracer {

namespace {

// The depths on the Pareto front of rays and truncation error, each with less than half the error of the one
// before. Also the depths that people commonly choose.
std::vector<DepthChoice> depthsToTry(const Renderer& renderer, const RenderOptions& options,
                                     const Reference& reference) {
    std::vector<double> cutoffs{reference.setting.cutoff};
    cutoffs.insert(cutoffs.end(), std::begin(gridCutoffs), std::end(gridCutoffs));
    RenderCounts spent;
    const Depths depths(renderer, options, picturePoints(options.size, 2500, PointsFor::depthsOfGrid),
                        reference.setting, cutoffs, spent);
    const std::vector<DepthChoice> all = depths.all();
    std::vector<CostAndError> points;
    points.reserve(all.size());
    for (const DepthChoice& choice : all) points.push_back({choice.rays, choice.squaredError});
    std::vector<DepthChoice> chosen;
    for (const std::size_t i : paretoFront(points))
        if (chosen.empty() || all[i].squaredError < 0.25 * chosen.back().squaredError)
            chosen.push_back(all[i]);
    for (const int depth : {1, 2, 3, 6}) {
        if (depth > depths.deepest().max_recursion) break;
        chosen.push_back(depths.measured(depth, cutoffs.front()));
        chosen.back().cutoff = 0;
    }
    std::ranges::stable_sort(chosen, {}, &DepthChoice::rays);
    // Drops depths that cast the same rays as the one before. The default stays: all are compared with it.
    const auto same = [](const DepthChoice& a, const DepthChoice& b) {
        return a.rays == b.rays && !(b.max_recursion == Setting{}.max_recursion && b.cutoff == 0);
    };
    chosen.erase(std::unique(chosen.begin(), chosen.end(), same), chosen.end());
    return chosen;
}

}  // namespace

std::vector<Setting> settingsToTry(const Renderer& renderer, const RenderOptions& options,
                                   const Reference& reference, bool hasTextures, int samples) {
    const std::vector<DepthChoice> depths = depthsToTry(renderer, options, reference);
    std::vector<Setting> settings;
    const auto add = [&](int n, double adaptive) {
        for (const DepthChoice& depth : depths) {
            settings.push_back({n, adaptive, depth.max_recursion, depth.cutoff});
            if (hasTextures && adaptive == 0)
                settings.push_back({n, 0, depth.max_recursion, depth.cutoff, true});
        }
    };
    for (const int n : gridSamples)
        if (n <= samples) add(n, 0);
    for (const double adaptive : gridAdaptive) add(samples, adaptive);
    return settings;
}

}  // namespace raytracer
