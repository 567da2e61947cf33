// Does `--target-error` keep its word? For every scene and several errors: the setting that it picks, the
// error which that has, and the cheapest setting of the whole grid that has no more.
//
//     target_error [--size PIXELS] [--pixels N] [--errors LIST] [--whole] [--time RAYTRACER] SCENE...
//
// The truth is 48 x 48 samples, 32 deep, with a cutoff of 0.003, for N pixels out of an eighth of the
// picture's (other ones than the pilot's; see stratified_pilot.h). That is too few to tell 2.9 from 3.0 %:
// --whole measures both settings by all pixels, each with twice 12 x 12 jittered samples for the truth. Costs
// are rays, the pilot's included; --time runs the program once with --target-error, once with the best
// setting, and compares their processor seconds. Exit status 1 where the promise is broken: the error is
// above the target in more than one of ten cases or ever above twice the target, the rays are more than 1.5
// times the best's, or something was said to be out of reach that is not. Seconds vary, so they are only
// told.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>

#include <sys/resource.h>

#include <CLI/CLI.hpp>

#include "median.h"
#include "raytracer/accuracy/stratified_pilot.h"
#include "raytracer/accuracy/target_error.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/child_process.h"
#include "raytracer/util/temporary_folder.h"

using namespace raytracer;

namespace {

const Setting truth{.samples = 48, .max_recursion = 32, .cutoff = 0.003};
const Setting firstPhase{.max_recursion = 8, .cutoff = 0.1};  // where the local contrast is measured

Setting with(Setting setting, int samples, double adaptive = 0) {
    setting.samples = samples;
    setting.adaptive = adaptive;
    return setting;
}

// Which pixels have something going on: between the centre, the corners, 4 x 4 samples, what is seen without
// recursion, and what only the deepest rays see: in one pixel of a thousand, but there by far more than the
// targets.
std::vector<double> localContrast(Pilot& pilot) {
    const auto colors = [&](const Setting& setting) -> const auto& { return pilot.colors(setting); };
    const auto &centre = colors(firstPhase), &corners = colors(with(firstPhase, 64, 1)),
               &more = colors(with(firstPhase, 4));
    const auto &shallow = colors({.max_recursion = 1}), &deep = colors(with(truth, 1));
    std::vector<double> contrast;
    for (std::size_t i = 0; i < centre.size(); ++i)
        contrast.push_back(std::sqrt(squaredError(centre[i], corners[i]) + squaredError(centre[i], more[i]) +
                                     squaredError(corners[i], more[i]) +
                                     squaredError(centre[i], shallow[i]) / 3 +
                                     squaredError(centre[i], deep[i])));
    return contrast;
}

struct Found {
    Setting setting;
    double rays = 0, error = 0;
};

std::vector<DepthChoice> depths(StratifiedPilot& pilot) {
    const Setting deepest = with(truth, 1);
    std::vector<DepthChoice> all, front;
    std::vector<CostAndError> points;
    for (const int depth : gridDepths)
        for (const double cutoff : gridCutoffs) {
            if ((depth == 0 && cutoff != gridCutoffs[0]) || (!all.empty() && all.back().error < 1e-6))
                continue;
            const Setting setting{.max_recursion = depth, .cutoff = cutoff};
            all.push_back({depth, cutoff, pilot.rays(setting), pilot.error(setting, deepest).rmse});
            points.push_back({all.back().rays, all.back().error});
        }
    for (const std::size_t i : paretoFront(points)) front.push_back(all[i]);
    return front;
}

// Every setting of the grid, with its error predicted from its two parts.
std::vector<Found> wholeGrid(StratifiedPilot& pilot) {
    const double shallow = pilot.error(firstPhase, with(truth, 1)).rmse;
    const std::vector<DepthChoice> deep = depths(pilot);
    std::vector<Found> grid;
    for (const int samples : gridSamples)
        for (const double adaptive : gridAdaptive) {
            if (adaptive > 0 && samples < 3) continue;
            const Setting setting = with(firstPhase, samples, adaptive);
            const double error = std::pow(pilot.error(setting, truth).rmse, 2) - shallow * shallow;
            const double rays = pilot.rays(setting) / pilot.rays(firstPhase);
            for (const DepthChoice& depth : deep)
                grid.push_back({{samples, adaptive, depth.max_recursion, depth.cutoff},
                                rays * depth.rays,
                                std::sqrt(std::max(0.0, error) + depth.error * depth.error)});
        }
    std::ranges::stable_sort(grid, {}, &Found::rays);
    return grid;
}

// All pixels, in strips, since the samples of all at once would take gigabytes.
class WholePicture {
  public:
    WholePicture(const Renderer& renderer, const RenderOptions& options) {
        const PixelRectangle& crop = options.crop;
        for (int top = crop.y0; top < crop.y1; top += rows) {
            const PixelRectangle strip{crop.x0, top, crop.x1, std::min(top + rows, crop.y1)};
            const auto all = static_cast<std::size_t>(strip.area());
            strips_.push_back(std::make_unique<Pilot>(renderer, options, scatteredPixels(strip, all, 0)));
            strips_.back()->sampleTruth(truth, 12);
        }
    }

    ErrorEstimate error(const Setting& setting) {
        std::vector<double> all;
        for (const auto& strip : strips_) {
            const std::vector<double> errors = strip->squaredErrors(strip->colors(setting));
            all.insert(all.end(), errors.begin(), errors.end());
        }
        return rootOf(meanOf(all));
    }

    double rays(const Setting& setting) {
        double rays = 0, pixels = 0;
        for (const auto& strip : strips_) {
            const auto count = static_cast<double>(strip->pixelCount());
            rays += count * strip->rays(setting);
            pixels += count;
        }
        return rays / pixels;
    }

  private:
    static constexpr int rows = 16;
    std::vector<std::unique_ptr<Pilot>> strips_;
};

double processorSecondsOfChildren() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Whole processes: a scene by the raytracer, with one thread and what follows of its command line.
class Timer {
  public:
    Timer(const std::string& program, const std::string& scene, int size)
        : program_(program),
          base_{scene, folder_.file("out.png"), std::to_string(size), "--quiet", "--threads", "1"} {}

    // What --target-error takes, as a multiple of a render with the best setting: the median of three, or of
    // as many as take a few seconds, each of both in turn.
    double ratio(double target, const Setting& best) const {
        constexpr double enough = 5;  // seconds
        std::vector<double> ratios;
        for (double all = 0; (all < enough && ratios.size() < 15) || ratios.size() < 3;) {
            const double chosen = seconds("--target-error " + std::to_string(target));
            const double shortest = seconds(best == Setting{} ? "" : commandLine(best));
            ratios.push_back(chosen / shortest);
            all += chosen + shortest;
        }
        return median(ratios);
    }

  private:
    static constexpr double timeout = 3600;  // seconds

    double seconds(const std::string& options) const {
        std::vector<std::string> arguments = base_;
        std::istringstream words(options);
        for (std::string word; words >> word;) arguments.push_back(word);
        const double before = processorSecondsOfChildren();
        const ProcessEnd end = runProcess(program_, arguments, folder_.file("log"), timeout);
        if (end.exitStatus > 1 || end.signal || end.timedOut)
            throw std::runtime_error(program_ + " " + end.description());
        return processorSecondsOfChildren() - before;
    }

    const TemporaryFolder folder_;
    std::string program_;
    std::vector<std::string> base_;
};

struct Arguments {
    std::vector<std::string> scenes;
    std::vector<double> errors{0.1, 0.03, 0.01, 0.003, 0.001};
    int size = 600, pixels = 2400;
    bool whole = false;
    std::string program;  // to time, or none
};

struct Tally {
    int cases = 0, above = 0, farAbove = 0, slow = 0, unreached = 0, wronglyUnreached = 0;
    double slowest = 0;
    std::vector<double> seconds;  // of the cases timed, as multiples of the best setting's

    bool isBroken() const { return farAbove > 0 || 10 * above > cases || slow > 0 || wronglyUnreached > 0; }
};

class SceneCheck {
  public:
    SceneCheck(const std::string& file, const Arguments& arguments)
        : name_(std::filesystem::path(file).stem()),
          scene_(loadScene(file, false).description),
          renderer_(makeRenderer(scene_, Precision::Double)) {
        options_.size = imageSize(scene_.camera, arguments.size);
        options_.crop = {0, 0, options_.size.width, options_.size.height};
        area_ = options_.crop.area();
        Pilot first(*renderer_, options_,
                    scatteredPixels(options_.crop, static_cast<std::size_t>(area_ / 8), 77));
        pilot_ = std::make_unique<StratifiedPilot>(*renderer_, options_);
        pilot_->add(first.pixels(), localContrast(first), static_cast<std::size_t>(arguments.pixels));
        grid_ = wholeGrid(*pilot_);
        if (!arguments.program.empty()) timer_.emplace(arguments.program, file, arguments.size);
        if (arguments.whole) whole_ = std::make_unique<WholePicture>(*renderer_, options_);
    }

    void check(double target, Tally& tally) {
        ColorSink sink(options_.crop);
        const TargetChoice choice = chooseSetting(*renderer_, options_, target, sink);
        const ErrorEstimate achieved = error(choice.setting);
        const Found best = cheapest(target);
        const double rays = this->rays(choice.setting), cost = (rays + choice.pilotRays / area_) / best.rays;
        std::printf(
            "%-18s %5.0e %s estimated %.2e +- %2.0f%%  achieved %.2e +- %2.0f%% = %.2f target  rays %7.1f = "
            "%.2f best, "
            "with pilot %.2f",
            name_.c_str(), target, choice.reached ? "reached" : "NOT    ", choice.error,
            100 * choice.standardError / choice.error, achieved.rmse,
            100 * achieved.standardError / achieved.rmse, achieved.rmse / target, rays, rays / best.rays,
            cost);
        if (timer_ && best.rays > 0) {
            tally.seconds.push_back(timer_->ratio(target, best.setting));
            std::printf(", seconds %.2f", tally.seconds.back());
        }
        std::printf("  [%s] best [%s] %.2e\n", commandLine(choice.setting).c_str(),
                    best.rays > 0 ? commandLine(best.setting).c_str() : "none", best.error);
        std::fflush(stdout);
        count(choice.reached, achieved.rmse / target, best.rays > 0 ? cost : 0, tally);
    }

  private:
    ErrorEstimate error(const Setting& setting) {
        return whole_ ? whole_->error(setting) : pilot_->error(setting, truth);
    }
    double rays(const Setting& setting) { return whole_ ? whole_->rays(setting) : pilot_->rays(setting); }

    // The cheapest that reaches the target, measured; what is predicted to be far from it is not tried.
    Found cheapest(double target) {
        for (const Found& candidate : grid_) {
            if (candidate.error > 1.1 * target || pilot_->error(candidate.setting, truth).rmse > 1.1 * target)
                continue;
            const double error = this->error(candidate.setting).rmse;
            if (error <= target) return {candidate.setting, rays(candidate.setting), error};
        }
        return {};
    }

    static void count(bool reached, double error, double cost, Tally& tally) {
        if (!reached) {
            ++tally.unreached;
            tally.wronglyUnreached += cost > 0;
            return;
        }
        ++tally.cases;
        tally.above += error > 1;
        tally.farAbove += error > 2;
        tally.slow += cost > 1.5;
        tally.slowest = std::max(tally.slowest, cost);
    }

    std::string name_;
    SceneDescription scene_;
    std::unique_ptr<Renderer> renderer_;
    RenderOptions options_;
    double area_;
    std::unique_ptr<StratifiedPilot> pilot_;
    std::unique_ptr<WholePicture> whole_;
    std::optional<Timer> timer_;
    std::vector<Found> grid_;
};

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Checks --target-error against the whole grid.", "target_error");
    Arguments arguments;
    app.add_option("SCENE", arguments.scenes)->required();
    app.add_option("--size", arguments.size)->capture_default_str();
    app.add_option("--pixels", arguments.pixels)->capture_default_str();
    app.add_option("--errors", arguments.errors)->delimiter(',')->allow_extra_args(false);
    app.add_flag("--whole", arguments.whole);
    app.add_option("--time", arguments.program, "the program to time")->check(CLI::ExistingFile);
    CLI11_PARSE(app, argc, argv);
    Tally tally;
    for (const std::string& scene : arguments.scenes) {
        if (scene.ends_with(".schema.json")) continue;  // so that scenes/*.json is all scenes
        SceneCheck check(scene, arguments);
        for (const double target : arguments.errors) check.check(target, tally);
    }
    std::printf(
        "%d cases said to be reached: %d above the target, %d above twice the target, %d dearer than 1.5 "
        "times the best "
        "(pilot included; at most %.2f); %d said to be out of reach, %d of them wrongly\n",
        tally.cases, tally.above, tally.farAbove, tally.slow, tally.slowest, tally.unreached,
        tally.wronglyUnreached);
    if (!tally.seconds.empty())
        std::printf(
            "processor seconds: %zu cases, %zu of them over 1.5 times the best, median %.2f, at most %.2f\n",
            tally.seconds.size(),
            static_cast<std::size_t>(
                std::ranges::count_if(tally.seconds, [](double ratio) { return ratio > 1.5; })),
            median(tally.seconds), std::ranges::max(tally.seconds));
    return tally.isBroken();
}
