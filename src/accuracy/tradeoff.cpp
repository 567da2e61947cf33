#include "raytracer/accuracy/tradeoff.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "raytracer/pictures/color_sink.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/util/stopwatch.h"

namespace raytracer {

namespace {

// Renders, and adds the time to the trial's timings. It is processor time, which other load on the machine
// hardly changes.
std::vector<glm::dvec3> timedRender(const Renderer& renderer, const RenderOptions& options, Trial& trial) {
    Stopwatch stopwatch;
    RenderedColors picture = rendered(renderer, withSetting(options, trial.setting));
    trial.timings.push_back(stopwatch.lap().cpu);
    trial.counts = picture.counts;
    return std::move(picture.colors);
}

std::vector<CostAndError> costsAndErrors(std::span<const Trial> trials) {
    std::vector<CostAndError> points;
    for (const Trial& trial : trials) points.push_back({trial.seconds(), trial.error.rmse});
    return points;
}

// Which trials could be on the front if their time were measured again.
std::vector<bool> contenders(std::span<const Trial> trials) {
    std::vector<bool> contender;
    for (const Trial& trial : trials)
        contender.push_back(std::ranges::none_of(trials, [&](const Trial& other) {
            return other.error.rmse <= trial.error.rmse && 1.4 * other.seconds() < trial.seconds();
        }));
    return contender;
}

// Renders the contenders again until each has `repeats` timings. They take turns, so that a passing
// disturbance of the machine affects all of them.
void repeatTimings(const Renderer& renderer, const RenderOptions& options, int repeats,
                   std::vector<Trial>& trials) {
    for (bool isDone = false; !isDone;) {
        isDone = true;
        const std::vector<bool> again = contenders(trials);
        for (std::size_t k = 0; k < trials.size(); ++k) {
            if (!again[k] || std::ssize(trials[k].timings) >= repeats) continue;
            timedRender(renderer, options, trials[k]);
            isDone = false;
        }
    }
}

void markFront(std::vector<Trial>& trials) {
    std::ranges::stable_sort(trials, {}, &Trial::seconds);
    for (const std::size_t i : paretoFront(costsAndErrors(trials))) trials[i].onFront = true;
}

// Fits the rate at which the sampling error falls. The sampling error of n samples is taken to be the
// smallest error at any depth. Errors near the reference's own do not count.
std::optional<double> measuredRate(std::span<const Trial> trials, const Reference& reference) {
    std::vector<CostAndError> points;
    for (const int samples : gridSamples) {
        const CostAndError none{static_cast<double>(samples), 1};
        CostAndError best = none;
        for (const Trial& trial : trials)
            if (trial.setting.samples == samples && trial.setting.adaptive == 0 && !trial.setting.bilinear)
                best.error = std::min(best.error, trial.error.rmse);
        if (best.error < 1 && best.error > 1.5 * reference.doublingError) points.push_back(best);
    }
    if (points.size() < 2) return std::nullopt;
    return fallRate(points);
}

// The default setting and 16 samples, in each precision that suits the scene.
std::vector<Trial> arithmeticTrials(const SceneDescription& scene, const RenderOptions& options,
                                    const BuildOptions& build, int repeats) {
    std::vector<std::unique_ptr<Renderer>> renderers;
    for (const Precision precision : {Precision::Extended, Precision::Double, Precision::Float}) {
        auto renderer = makeRenderer(scene, precision, build);
        if (renderer->precision() == precision) renderers.push_back(std::move(renderer));
    }
    std::vector<Trial> trials;
    for (const int samples : {1, 16}) {
        std::vector<glm::dvec3> truth;
        const std::size_t first = trials.size();
        for (const auto& renderer : renderers) {
            Trial trial{.setting = {.samples = samples}, .precision = renderer->precision()};
            const auto colors = timedRender(*renderer, options, trial);
            if (truth.empty()) truth = colors;
            trial.error = pictureError(colors, truth);
            trials.push_back(trial);
        }
        for (int i = 1; i < repeats; ++i)
            for (std::size_t k = 0; k < renderers.size(); ++k)
                timedRender(*renderers[k], options, trials[first + k]);
    }
    return trials;
}

ByteImage picture(const ImageSize& size, std::span<const glm::dvec3> colors) {
    const PixelRectangle whole{0, 0, size.width, size.height};
    ByteSink sink(whole);
    copyTo(sink, whole, colors);
    return sink.image();
}

Exhibit exhibit(const Renderer& renderer, const RenderOptions& options, const Trial& trial,
                const Reference& reference) {
    const RenderedColors shown = rendered(renderer, withSetting(options, trial.setting));
    std::vector<glm::dvec3> difference;
    for (std::size_t i = 0; i < reference.colors.size(); ++i)
        difference.push_back(exhibitMagnification * glm::abs(glm::clamp(shown.colors[i], 0.0, 1.0) -
                                                             glm::clamp(reference.colors[i], 0.0, 1.0)));
    return {trial.setting, trial.error, picture(options.size, shown.colors),
            picture(options.size, difference)};
}

// The trials on the front that are nearest to each of these errors, half a power of ten apart.
std::vector<Exhibit> exhibits(const Renderer& renderer, const RenderOptions& options,
                              const SceneTradeoff& measured) {
    std::vector<const Trial*> chosen;
    for (const double error : {0.1, 0.03, 0.01, 0.003, 0.001}) {
        const Trial* nearest = nullptr;
        const auto distance = [&](const Trial& trial) {
            return std::abs(std::log(trial.error.rmse / error));
        };
        for (const Trial& trial : measured.truncation)
            if (trial.onFront && (!nearest || distance(trial) < distance(*nearest))) nearest = &trial;
        if (nearest && (chosen.empty() || chosen.back() != nearest)) chosen.push_back(nearest);
    }
    std::vector<Exhibit> shown;
    shown.reserve(chosen.size());
    for (const Trial* trial : chosen) shown.push_back(exhibit(renderer, options, *trial, measured.reference));
    return shown;
}

bool hasTextures(const SceneDescription& scene) {
    return std::ranges::any_of(
        scene.shapes, [&](const auto& s) { return scene.materials[s.material].use_diffuse_texture; });
}

}  // namespace

double Trial::seconds() const {
    std::vector<double> sorted = timings;
    std::ranges::sort(sorted);
    return sorted[sorted.size() / 2];
}

double fallRate(std::span<const CostAndError> points) {
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const CostAndError& point : points) {
        const double cost = std::log(point.cost), error = std::log(point.error);
        x += cost;
        y += error;
        xx += cost * cost;
        xy += cost * error;
    }
    const auto n = static_cast<double>(points.size());
    return -(n * xy - x * y) / (n * xx - x * x);
}

SceneTradeoff measureTradeoff(const std::string& name, const SceneDescription& scene,
                              const TradeoffOptions& tradeoff) {
    const auto report = [&](const std::string& step) {
        if (tradeoff.report) tradeoff.report(name + ": " + step);
    };
    SceneTradeoff result;
    result.name = name;
    result.size = imageSize(scene.camera, tradeoff.size);
    RenderOptions options;
    options.size = result.size;
    options.crop = {0, 0, options.size.width, options.size.height};
    options.threads = tradeoff.threads;

    report("the reference");
    const BuildOptions build{.threads = tradeoff.threads};
    const auto renderer = makeRenderer(scene, Precision::Double, build);
    result.reference = makeReference(*renderer, options, tradeoff.samples);
    result.referencePicture = picture(options.size, result.reference.colors);

    for (const Setting& setting :
         settingsToTry(*renderer, options, result.reference, hasTextures(scene), tradeoff.samples))
        result.truncation.push_back({.setting = setting});
    report(std::to_string(result.truncation.size()) + " settings");
    for (Trial& trial : result.truncation)
        trial.error = pictureError(timedRender(*renderer, options, trial), result.reference.colors);
    report("timing those near the front again");
    repeatTimings(*renderer, options, tradeoff.repeats, result.truncation);
    markFront(result.truncation);
    result.sampleRate = measuredRate(result.truncation, result.reference);
    report("the arithmetic");
    result.arithmetic = arithmeticTrials(scene, options, build, tradeoff.repeats);
    result.exhibits = exhibits(*renderer, options, result);
    return result;
}

}  // namespace raytracer
