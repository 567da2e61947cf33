// Does `--target-error` keep its word? For every scene and several errors: the setting that it picks, the error which that
// has, and the cheapest setting of the whole grid that has no more.
//
//     target_error [--size PIXELS] [--share N] [--errors LIST] SCENE...
//
// The truth is 32 x 32 samples, 32 deep, with a cutoff of 0.003; it is rendered for one of N pixels (--share 10), other ones
// than the pilot's. Costs are rays, the pilot's included where it says so. Exit status 1 where the promise is broken: the
// error is above the target in more than one of ten cases, or ever above twice the target.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "raytracer/scene_loader.h"
#include "raytracer/target_error.h"

using namespace raytracer;

namespace {

const Setting truth{.samples = 32, .max_recursion = 32, .cutoff = 0.003};

struct Found {
    Setting setting;
    double rays = 0, error = 0;
};

// Every setting of the grid, with its error predicted from its two parts.
std::vector<Found> wholeGrid(Pilot& pilot) {
    Setting deepest = truth;
    deepest.samples = 1;
    const auto depths = depthFront(pilot, deepest, gridCutoffs, 0);
    const double plain = pilot.take(deepest).rays;
    std::vector<Found> grid;
    for (const int samples : gridSamples)
        for (const double adaptive : gridAdaptive) {
            if (adaptive > 0 && samples < 3) continue;
            Setting setting{.samples = samples, .adaptive = adaptive, .max_recursion = 8, .cutoff = 0.1};
            const double error = pilot.error(setting, truth).rmse;
            const double rays = pilot.take(setting).rays / pilot.take({.max_recursion = 8, .cutoff = 0.1}).rays * plain;
            for (const DepthChoice& depth : depths) {
                setting.max_recursion = depth.max_recursion;
                setting.cutoff = depth.cutoff;
                grid.push_back({setting, rays * depth.rays / plain, std::hypot(error, depth.error)});
            }
        }
    std::ranges::stable_sort(grid, {}, &Found::rays);
    return grid;
}

// The cheapest that reaches the target, measured; what is predicted to be far from it is not tried.
Found cheapest(Pilot& pilot, const std::vector<Found>& grid, double target) {
    for (const Found& candidate : grid) {
        if (candidate.error > 1.3 * target) continue;
        const double error = pilot.error(candidate.setting, truth).rmse;
        if (error <= target) return {candidate.setting, pilot.take(candidate.setting).rays, error};
    }
    return {};
}

struct Tally {
    int cases = 0, above = 0, farAbove = 0, slow = 0, unreached = 0;
};

void check(const std::string& file, int size, int share, const std::vector<double>& errors, Tally& tally) {
    const SceneDescription scene = loadScene(file, false).description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    RenderOptions options;
    options.size = imageSize(scene.camera, size);
    options.crop = {0, 0, options.size.width, options.size.height};
    const auto area = static_cast<std::size_t>(options.size.width) * static_cast<std::size_t>(options.size.height);
    Pilot pixels(*renderer, options, scatteredPixels(options.crop, area / static_cast<std::size_t>(share), 77));
    const std::vector<Found> grid = wholeGrid(pixels);
    for (const double target : errors) {
        const TargetChoice choice = chooseSetting(*renderer, options, target);
        const PictureError achieved = pixels.error(choice.setting, truth);
        const Found best = cheapest(pixels, grid, target);
        const double total = pixels.take(choice.setting).rays + choice.pilotRays / static_cast<double>(area);
        std::printf("%-20s %6.0e  %s estimated %.2e  achieved %.2e +- %.0e = %.2f target  rays %7.1f = %.2f best, with pilot %.2f"
                    "  [%s] best [%s] %.2e\n",
                    std::filesystem::path(file).stem().c_str(), target, choice.reached ? "reached " : "NOT     ", choice.error,
                    achieved.rmse, achieved.standardError, achieved.rmse / target, pixels.take(choice.setting).rays,
                    pixels.take(choice.setting).rays / best.rays, total / best.rays, commandLine(choice.setting).c_str(),
                    best.rays > 0 ? commandLine(best.setting).c_str() : "none", best.error);
        std::fflush(stdout);
        if (!choice.reached) {
            ++tally.unreached;
            continue;
        }
        ++tally.cases;
        tally.above += achieved.rmse > target;
        tally.farAbove += achieved.rmse > 2 * target;
        tally.slow += best.rays > 0 && total > 1.5 * best.rays;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Checks --target-error against the whole grid.", "target_error");
    std::vector<std::string> scenes;
    std::vector<double> errors{0.1, 0.03, 0.01, 0.003, 0.001};
    int size = 600, share = 10;
    app.add_option("SCENE", scenes)->required();
    app.add_option("--size", size)->capture_default_str();
    app.add_option("--share", share)->capture_default_str();
    app.add_option("--errors", errors)->delimiter(',');
    CLI11_PARSE(app, argc, argv);
    Tally tally;
    for (const std::string& scene : scenes) check(scene, size, share, errors, tally);
    std::printf("%d cases: %d above the target, %d above twice the target, %d slower than 1.5 times the best (pilot included); "
                "%d more were said to be out of reach\n",
                tally.cases, tally.above, tally.farAbove, tally.slow, tally.unreached);
    return tally.farAbove > 0 || 10 * tally.above > tally.cases;
}
