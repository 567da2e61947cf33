// Which settings are tried: not all combinations of the options, most of which are far from the front.
#include <algorithm>

#include "raytracer/accuracy/tradeoff.h"

namespace raytracer {

namespace {

// The depths on the front of rays and truncation error, each with at most half the error of the one before,
// and the depths that people commonly choose.
std::vector<DepthChoice> depthsToTry(Pilot& pilot, const Reference& reference) {
    std::vector<double> cutoffs{0};
    cutoffs.insert(cutoffs.end(), std::begin(gridCutoffs), std::end(gridCutoffs));
    Setting deepest = reference.setting;
    deepest.samples = 1;
    const auto measure = [&](int depth, double cutoff) -> DepthChoice {
        const Setting setting{.max_recursion = depth, .cutoff = cutoff};
        return {depth, cutoff, pilot.rays(setting), pilot.error(setting, deepest).rmse};
    };
    std::vector<DepthChoice> chosen;
    for (const DepthChoice& choice : depthFront(measure, deepest.max_recursion, cutoffs, 1e-4))
        if (chosen.empty() || choice.error < 0.5 * chosen.back().error) chosen.push_back(choice);
    for (const int depth : {1, 2, 3, 6}) chosen.push_back(measure(depth, 0));
    std::ranges::stable_sort(chosen, {}, &DepthChoice::rays);
    // The default stays: everything is compared with it.
    const auto same = [](const DepthChoice& a, const DepthChoice& b) {
        return a.rays == b.rays && !(b.max_recursion == Setting{}.max_recursion && b.cutoff == 0);
    };
    chosen.erase(std::unique(chosen.begin(), chosen.end(), same), chosen.end());
    return chosen;
}

}  // namespace

std::vector<Setting> settingsToTry(const Renderer& renderer, const RenderOptions& options,
                                   const Reference& reference, bool hasTextures, int samples) {
    Pilot pilot(renderer, options, scatteredPixels(options.crop, 2500, 5));
    const std::vector<DepthChoice> depths = depthsToTry(pilot, reference);
    const DepthChoice& deep = *std::ranges::min_element(depths, {}, &DepthChoice::error);
    std::vector<Setting> settings;
    for (const int n : gridSamples) {
        if (n > samples) break;
        const Setting half{.samples = n, .max_recursion = deep.max_recursion, .cutoff = deep.cutoff};
        Setting twice = half;
        twice.samples = 2 * n;
        const double between = pilot.error(half, twice).rmse;
        for (const DepthChoice& depth : depths) {
            if (n > 1 && depth.error > 3 * between) continue;  // more samples would hardly reduce the error
            for (const double adaptive : gridAdaptive)
                if (adaptive == 0 || n > 2)
                    settings.push_back({n, adaptive, depth.max_recursion, depth.cutoff});
            if (hasTextures) settings.push_back({n, 0, depth.max_recursion, depth.cutoff, true});
        }
    }
    return settings;
}

}  // namespace raytracer
