// The trade of speed for accuracy: what its charts claim, and what --target-error promises.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include <catch2/catch.hpp>

#include "../../src/accuracy/depth_search.h"
#include "../support/scene_files.h"
#include "raytracer/accuracy/estimated_picture.h"
#include "raytracer/accuracy/stratified_pilot.h"
#include "raytracer/accuracy/target_error.h"
#include "raytracer/accuracy/tradeoff_report.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

// Calls test(scene, renderer, options) for every scene in scenes/, `longEdge` pixels large.
template <class Test>
void forEveryScene(int longEdge, Test test) {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file, true).description;
        test(scene, *makeRenderer(scene, Precision::Double), wholePicture(scene, longEdge));
    }
}

std::vector<PixelPlace> allPixels(const RenderOptions& options) {
    return scatteredPixels(options.crop, static_cast<std::size_t>(options.crop.area()), 0);
}

// Of 1, 4 and 16 samples.
std::vector<CostAndError> errorsOfSamples(Pilot& picture) {
    std::vector<CostAndError> points;
    for (const int samples : {1, 2, 4})
        points.push_back({static_cast<double>(samples) * samples,
                          picture.error({.samples = samples}, {.samples = 12}).rmse});
    return points;
}

double meanContrast(Pilot& pilot, std::vector<double>& contrast) {
    const auto &centre = pilot.colors({}), &corners = pilot.colors({.samples = 64, .adaptive = 1});
    contrast.clear();
    for (std::size_t i = 0; i < centre.size(); ++i) contrast.push_back(squaredError(centre[i], corners[i]));
    return std::accumulate(contrast.begin(), contrast.end(), 0.0) / static_cast<double>(contrast.size());
}

}  // namespace

TEST_CASE(
    "on every scene the error falls with the samples, at least like that of edges along the pixels' grid") {
    forEveryScene(24, [](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        Pilot picture(renderer, options, allPixels(options));
        const std::vector<CostAndError> points = errorsOfSamples(picture);
        for (std::size_t i = 1; i < points.size(); ++i) CHECK(points[i].error < points[i - 1].error);
        CHECK(fallRate(points) >
              0.45);  // edges along the grid: 1/2 for each ray; at an angle: 3/4; smooth light: more
    });
}

TEST_CASE("the error falls with the samples at the rate that the chart claims") {
    for (const char* name : {"spheres_cylinder", "checker_horizon"}) {
        INFO(name);
        const SceneDescription scene =
            loadScene(std::string(SOURCE_DIR "/scenes/") + name + ".json", true).description;
        const SceneTradeoff chart = measureTradeoff(
            name, scene,
            {.size = 24, .samples = 4, .repeats = 1, .referencePrecision = Precision::Double, .report = {}});
        const auto renderer = makeRenderer(scene, Precision::Double);
        const RenderOptions options = wholePicture(scene, 32);
        Pilot picture(*renderer, options, allPixels(options));
        const double rate = fallRate(errorsOfSamples(picture));
        REQUIRE(chart.sampleRate);
        INFO("rate " << rate << ", the chart's " << *chart.sampleRate);
        CHECK(std::abs(rate - *chart.sampleRate) < 0.15);
    }
}

TEST_CASE("one number of samples tells no rate, and none is claimed") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/spheres_cylinder.json", true).description;
    const SceneTradeoff chart = measureTradeoff(
        "one", scene,
        {.size = 12, .samples = 1, .repeats = 1, .referencePrecision = Precision::Double, .report = {}});
    CHECK(!chart.sampleRate);
    CHECK(tradeoffTable(chart).find("falls like") == std::string::npos);
    CHECK(tradeoffSvg(std::span(&chart, 1)).find("between the samples") == std::string::npos);
}

TEST_CASE("the rate of a power law is its exponent") {
    std::vector<CostAndError> points;
    for (const double cost : {1.0, 4.0, 9.0, 64.0}) points.push_back({cost, 0.3 * std::pow(cost, -0.75)});
    CHECK(fallRate(points) == Approx(0.75));
}

TEST_CASE("the front has what no other point beats") {
    const CostAndError points[] = {{3, 1}, {1, 3}, {2, 3}, {1, 4}, {2, 2}, {2, 2}, {4, 1}};
    CHECK(paretoFront(points) == std::vector<std::size_t>{1, 4, 0});
    CHECK(paretoFront({}).empty());
}

TEST_CASE(
    "a measured scene: its front is one, its errors are apart, its reference is trusted no more than it "
    "says") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/spheres_cylinder.json", true).description;
    const SceneTradeoff measured =
        measureTradeoff("spheres", scene, {.size = 24, .samples = 3, .repeats = 3, .report = {}});
    const Trial* last = nullptr;
    for (const Trial& trial : measured.truncation) {
        CHECK(trial.setting.precision == Precision::Double);
        if (!trial.onFront) continue;
        CHECK(trial.timings.size() == 3);
        if (last) CHECK((trial.error.rmse < last->error.rmse && trial.seconds() > last->seconds()));
        last = &trial;
    }
    REQUIRE(last != nullptr);
    CHECK(std::ranges::count(measured.truncation, Setting{}, &Trial::setting) == 1);
    CHECK(measured.reference.setting.precision == Precision::Extended);
    CHECK(measured.reference.doublingError < last->error.rmse);
    for (const Trial& trial : measured.arithmetic) {
        CHECK(trial.setting.max_recursion ==
              Setting{}.max_recursion);  // the same samples, so that only arithmetic differs
        if (trial.setting.precision == Precision::Extended) CHECK(trial.error.rmse == 0);
        if (trial.setting.precision == Precision::Double) CHECK(trial.error.rmse < 1e-12);
        if (trial.setting.precision == Precision::Float)
            CHECK((trial.error.rmse > 1e-10 && trial.error.rmse < 1e-3));
    }
    CHECK(!measured.exhibits.empty());
}

TEST_CASE("a reference has no cutoff, but where glass would take many times the rays") {
    int cut = 0;
    forEveryScene(12, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const Reference reference = makeReference(renderer, options, 1);
        Pilot picture(renderer, options, allPixels(options));
        const Setting whole{.max_recursion = reference.setting.max_recursion};
        const Setting glass{.max_recursion = whole.max_recursion, .cutoff = 1e-5};
        const bool isCut = reference.setting.cutoff > 0;
        cut += isCut;
        CHECK(isCut == (picture.rays(whole) > 4 * picture.rays(glass)));
        CHECK(isCut == (reference.cutoffBound > 0));
        CHECK(reference.cutoffBound < 0.01);
    });
    CHECK(cut == 1);  // nested_glass
}

TEST_CASE(
    "a stratified pilot of all pixels has the picture's error, of few one that its standard error tells") {
    int far = 0, scenes = 0;
    forEveryScene(32, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const std::vector<PixelPlace> pixels = allPixels(options);
        Pilot picture(renderer, options, pixels);
        std::vector<double> contrast;
        const double mean = meanContrast(picture, contrast);
        const Setting setting{.samples = 2}, truth{.samples = 6};
        const PictureError whole = picture.error(setting, truth);
        StratifiedPilot all(renderer, options);
        all.add(pixels, contrast, 8 * pixels.size());
        CHECK(all.pixelCount() == pixels.size());
        CHECK(all.error(setting, truth).rmse == Approx(whole.rmse));
        CHECK(all.rays(setting) == Approx(picture.rays(setting)));
        StratifiedPilot some(renderer, options);
        some.add(pixels, contrast, 160);
        CHECK(some.pixelCount() <= 160);
        const ErrorEstimate estimate = some.error(setting, truth);
        INFO("contrast " << mean << ", error " << whole.rmse << ", estimated " << estimate.rmse << " +- "
                         << estimate.standardError);
        CHECK(std::abs(estimate.rmse - whole.rmse) < 4 * estimate.standardError);
        far += std::abs(estimate.rmse - whole.rmse) > 2 * estimate.standardError;
        ++scenes;
    });
    CHECK(far <= scenes / 5);
}

TEST_CASE("a pilot's adaptive pixels are the render's, and cost about as many rays") {
    forEveryScene(32, [](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const std::vector<PixelPlace> pixels = allPixels(options);
        Pilot pilot(renderer, options, pixels);
        for (const double adaptive : {1.0, 0.2, 0.03}) {  // 1: the corners stand for all
            const Setting setting{.samples = 4, .adaptive = adaptive};
            INFO(adaptive);
            std::vector<glm::dvec3> colors(pixels.size());
            const double rays =
                rayCount(renderer.renderPixels(withSetting(options, setting), pixels, colors));
            const std::vector<glm::dvec3>& combined = pilot.colors(setting);
            std::size_t off = 0;
            for (std::size_t i = 0; i < colors.size(); ++i)
                off += squaredError(combined[i], colors[i]) > 1e-16;
            CHECK(off <= colors.size() / 500);  // where a point is rounded to the other side of an edge
            CHECK(pilot.rays(setting) == Approx(rays / static_cast<double>(pixels.size())).epsilon(0.25));
        }
    });
}

TEST_CASE("pruned ray trees are the pixels of every smaller recursion, and their rays") {
    forEveryScene(32, [](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const std::vector<PixelPlace> pixels = allPixels(options);
        const Setting deepest{.max_recursion = 9, .cutoff = 0.02};
        RayTrees trees;
        renderer.rayTrees(withSetting(options, deepest), pixels, trees);
        REQUIRE(trees.pixelCount() == pixels.size());
        for (const Setting& setting :
             {deepest, Setting{.max_recursion = 9, .cutoff = 0.3},
              Setting{.max_recursion = 2, .cutoff = 0.02}, Setting{.max_recursion = 1, .cutoff = 0.1},
              Setting{.max_recursion = 0, .cutoff = 1}}) {
            INFO(commandLine(setting));
            std::vector<glm::dvec3> colors(pixels.size());
            const double rays =
                rayCount(renderer.renderPixels(withSetting(options, setting), pixels, colors));
            double counted = 0;
            double off = 0;
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                const PrunedPixel pixel = prunedPixel(trees, i, setting.max_recursion, setting.cutoff);
                counted += pixel.rays;
                off = std::max(off, squaredError(pixel.color, colors[i]));
            }
            CHECK(off < 1e-24);
            CHECK(counted == rays);
        }
    });
}

TEST_CASE("a depth costs and leaves out what its pixels say, one by one") {
    forEveryScene(32, [](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const std::vector<PixelPlace> pixels = allPixels(options);
        const Setting deepest{.max_recursion = 9, .cutoff = 0.02};
        RayTrees trees;
        renderer.rayTrees(withSetting(options, deepest), pixels, trees);
        DepthPilot pilot(renderer, options, pixels, deepest);
        for (const int depth : {0, 1, 2, 5, 9})
            for (const double cutoff : {0.02, 0.1, 0.5}) {
                INFO(depth << ", cutoff " << cutoff);
                double rays = 0;
                std::vector<double> errors;
                for (std::size_t i = 0; i < pixels.size(); ++i) {
                    const PrunedPixel pixel = prunedPixel(trees, i, depth, cutoff);
                    rays += pixel.rays / static_cast<double>(pixels.size());
                    errors.push_back(squaredError(pixel.color, prunedPixel(trees, i, 9, 0.02).color));
                }
                const ErrorEstimate error = rootOf(meanOf(errors));
                const DepthChoice choice = pilot.measured(depth, cutoff);
                CHECK(choice.max_recursion == depth);
                CHECK(choice.cutoff == cutoff);
                CHECK(choice.rays == Approx(rays));
                CHECK(choice.error == Approx(error.rmse).margin(1e-12));
                CHECK(choice.standardError == Approx(error.standardError).margin(1e-12));
                CHECK(pilot.distance(choice, pilot.measured(9, 0.02)) == Approx(error.rmse).margin(1e-12));
            }
    });
}

TEST_CASE("ray trees of huge colours stay finite") {
    SceneDescription scene = loadScene(SOURCE_DIR "/scenes/refraction.json", true).description;
    for (LightDescription& light : scene.lights) light.color = glm::dvec3(1e300);
    const RenderOptions options = wholePicture(scene, 16);
    RayTrees trees;
    const RenderOptions deep = withSetting(options, {.max_recursion = 6, .cutoff = 0.1});
    makeRenderer(scene, Precision::Double)->rayTrees(deep, allPixels(options), trees);
    for (const RayTreeNode& ray : trees.rays) CHECK(std::isfinite(glm::dot(ray.light, glm::dvec3(1))));
}

TEST_CASE("a truth of two noisy estimates gives the error without bias") {
    double off = 0;  // standard errors
    int estimates = 0;
    forEveryScene(48, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const Setting setting{.samples = 2}, converged{.samples = 12};
        Pilot picture(renderer, options, allPixels(options));
        const double truth = picture.squaredError(setting, converged).mean;
        for (const int n : {2, 3}) {  // of 2 x 2 samples, then of 3 x 3 more
            picture.sampleTruth(setting, n);
            const MeanSquare estimate = picture.squaredError(setting);
            INFO(n << ": " << truth << ", estimated " << estimate.mean << " +- "
                   << std::sqrt(estimate.variance));
            CHECK(std::abs(estimate.mean - truth) < 4 * std::sqrt(estimate.variance));
            off += (estimate.mean - truth) / std::sqrt(estimate.variance);
            ++estimates;
        }
    });
    CHECK(std::abs(off / estimates) < 0.7);
}

TEST_CASE("a truth that grows takes other samples, and no more than it lacks") {
    // Remembers where in the picture it was asked to look.
    class Places : public Renderer {
      public:
        RenderCounts render(const RenderOptions&, PixelSink&, ProgressListener*) const override { return {}; }
        RenderCounts rayTrees(const RenderOptions&, std::span<const PixelPlace>, RayTrees&) const override {
            return {};
        }
        RayExplanation explain(const RenderOptions&, int, int) const override { return {}; }
        RenderCounts renderPixels(const RenderOptions& options, std::span<const PixelPlace> pixels,
                                  std::span<glm::dvec3>) const override {
            for (const PixelPlace& pixel : pixels)
                places.emplace_back((pixel.x + 0.5) / options.size.width,
                                    (pixel.y + 0.5) / options.size.height);
            return {};
        }
        mutable std::vector<std::pair<double, double>> places;
    };
    const Places renderer;
    RenderOptions options;
    options.size = {10, 10};
    options.crop = {0, 0, 10, 10};
    Pilot pilot(renderer, options, allPixels(options));
    constexpr std::size_t samples[] = {4, 4 + 9, 4 + 9 + 4, 4 + 9 + 4 + 9};  // of a pixel and an estimate
    for (int n = 2; n <= 5; ++n) {
        pilot.sampleTruth({}, n);
        CHECK(renderer.places.size() == 2 * 100 * samples[n - 2]);
    }
    const std::set<std::pair<double, double>> different(renderer.places.begin(), renderer.places.end());
    CHECK(different.size() > renderer.places.size() * 19 / 20);  // the two of a cell meet in 1 of 256
}

TEST_CASE("an estimated picture is the render's, and its error estimate has no bias") {
    double off = 0;  // standard errors
    int scenes = 0;
    forEveryScene(64, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const Setting setting{.max_recursion = 2, .cutoff = 0.1};
        ColorSink sink(options.crop), other(options.crop);
        const EstimatedPicture estimated = renderEstimated(
            renderer, options, setting, sink, 500, [](const ErrorEstimate&) { return Decision::Continue; });
        const RenderCounts counts = renderer.render(withSetting(options, setting), other);
        CHECK(sink.colors() == other.colors());
        CHECK(rayCount(estimated.counts) == rayCount(counts));
        CHECK(estimated.isWhole);
        CHECK(estimated.estimatedPixels < 510);
        const EstimatedPicture clear = renderEstimated(renderer, options, setting, other, 500,
                                                       [](const ErrorEstimate&) { return Decision::Accept; });
        CHECK(sink.colors() == other.colors());
        CHECK(clear.estimatedPixels < 130);
        CHECK(clear.error.standardError > estimated.error.standardError);
        Pilot picture(renderer, options, allPixels(options));
        Setting converged = setting;
        converged.samples = 12;
        const double truth = picture.error(setting, converged).rmse;
        const double errors = (estimated.error.rmse - truth) / estimated.error.standardError;
        INFO(truth << ", estimated " << estimated.error.rmse << " +- " << estimated.error.standardError);
        CHECK(std::abs(errors) < 4);
        off += errors;
        ++scenes;
    });
    CHECK(std::abs(off / scenes) < 0.7);
}

TEST_CASE("an estimated picture is rejected after a quarter, which estimates the error of all") {
    double sum = 0, half = 0;  // of squared relative differences
    int scenes = 0;
    forEveryScene(150, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const Setting setting{.max_recursion = 2, .cutoff = 0.1};
        ColorSink sink(options.crop);
        std::vector<ErrorEstimate> told;
        const EstimatedPicture whole =
            renderEstimated(renderer, options, setting, sink, 4000, [&](const ErrorEstimate& error) {
                told.push_back(error);
                return Decision::Continue;
            });
        REQUIRE(told.size() == 4);
        int asked = 0;
        const EstimatedPicture part =
            renderEstimated(renderer, options, setting, sink, 4000, [&](const ErrorEstimate&) {
                ++asked;
                return Decision::Reject;
            });
        CHECK(asked == 1);
        CHECK(!part.isWhole);
        CHECK(static_cast<double>(part.counts.primary) == Approx(options.crop.area() / 4).epsilon(0.05));
        CHECK(part.error.rmse == told[0].rmse);
        CHECK(part.error.standardError == told[0].standardError);
        sum += std::pow(told[0].rmse / whole.error.rmse - 1, 2);
        half += std::pow(told[1].rmse / whole.error.rmse - 1, 2);
        ++scenes;
    });
    INFO("a quarter differs by " << std::sqrt(sum / scenes) << ", a half by " << std::sqrt(half / scenes));
    CHECK(std::sqrt(sum / scenes) < 0.15);
    CHECK(std::sqrt(half / scenes) < 0.1);
}

TEST_CASE("what a depth leaves out is the same whatever the samples, or nearly: 2 x 2 tell it") {
    forEveryScene(32, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        Pilot picture(renderer, options, allPixels(options));
        for (const int samples : {1, 2, 4}) {
            const Setting deep{.samples = samples, .max_recursion = 6, .cutoff = 0.03};
            Setting shallow = deep;
            shallow.max_recursion = 2;
            picture.sampleTruth(deep, 4);
            const double told = std::sqrt(picture.squaredErrorOfShallow(shallow, deep).mean);
            const double error = std::sqrt(picture.squaredError(shallow).mean);
            INFO(samples << ": " << told << " instead of " << error);
            if (samples <= 2) CHECK(told == Approx(error));
            else CHECK(told == Approx(error).epsilon(0.15).margin(1e-4));
        }
    });
}

TEST_CASE("a pilot's flat pixels: the others count as right, and take no samples") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/spheres_cylinder.json", true).description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    const RenderOptions options = wholePicture(scene, 32);
    const std::vector<PixelPlace> pixels = allPixels(options);
    Pilot pilot(*renderer, options, pixels);
    pilot.sampleTruth({}, 3);
    const Setting whole{.samples = 6}, some{.samples = 6, .adaptive = 0.2}, none{.samples = 6, .adaptive = 1};
    const double before = pilot.raysSpent(), ofCorners = pilot.squaredErrorOfFlat(some).mean;
    const double cornerRays = pilot.raysSpent() - before, spent = pilot.raysSpent();
    const double estimated = pilot.rays(some);
    CHECK(pilot.raysSpent() == spent);
    const std::vector<double> mixed = pilot.squaredErrors(pilot.colors(some)),
                              flat = pilot.squaredErrors(pilot.colors(none));
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (mixed[i] == flat[i]) sum += flat[i];
    CHECK(sum / static_cast<double>(pixels.size()) == Approx(ofCorners));
    pilot.colors(whole);
    CHECK(pilot.rays(whole) == Approx(cornerRays * 9 / static_cast<double>(pixels.size())).epsilon(0.25));
    CHECK(pilot.rays(some) == Approx(estimated).epsilon(0.25));
    CHECK(pilot.raysSpent() - before ==
          Approx(pilot.rays(whole) * static_cast<double>(pixels.size())));  // none was taken twice
}

static TargetChoice choose(const Renderer& renderer, const RenderOptions& options, double target,
                           const ChoiceListener& tell = {}) {
    ColorSink sink(options.crop);
    return chooseSetting(renderer, options, target, sink, tell);
}

TEST_CASE("target-error: hardly ever above, never above twice, on every scene") {
    int cases = 0, above = 0;
    forEveryScene(24, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        Pilot picture(renderer, options, allPixels(options));
        for (const double target : {0.1, 0.04}) {
            const TargetChoice choice = choose(renderer, options, target);
            CHECK(choice.reached);
            const double error =
                picture.error(choice.setting, {.samples = 6, .max_recursion = 8, .cutoff = 0.05}).rmse;
            INFO(commandLine(choice.setting) << " has " << error << " for " << target);
            CHECK(error <= 2 * target);
            ++cases;
            above += error > target;
        }
    });
    CHECK(10 * above <= cases);
}

TEST_CASE("target-error: where nothing reaches it, the most accurate and no promise") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/checker_horizon.json", true).description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    const TargetChoice choice = choose(*renderer, wholePicture(scene, 6), 1e-9);
    CHECK(!choice.reached);
    CHECK(choice.setting.samples == 16);
    CHECK(choice.setting.adaptive == 0);
    CHECK(choice.error > 1e-9);
}

// Rays deeper than 8 contribute to few pixels here: the first measurement misses all of them.
TEST_CASE("target-error: measuring depths again starts from the finest, not from what few pixels said") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/mirror_corridor.json", true).description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    const RenderOptions options = wholePicture(scene, 420);
    DepthSearch depths(*renderer, options, 0.001);
    REQUIRE(depths.widen(500));
    const DepthChoice& best = *std::ranges::min_element(depths.choices(), {}, &DepthChoice::error);
    CHECK(best.error < 0.0005);
    CHECK(best.max_recursion > 12);
}

TEST_CASE("target-error: tells what it would choose so far, at last what it chooses") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/spheres_cylinder.json", true).description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    std::vector<Setting> told;
    const TargetChoice choice = choose(*renderer, wholePicture(scene, 64), 0.02,
                                       [&](const TargetChoice& soFar) { told.push_back(soFar.setting); });
    REQUIRE(!told.empty());
    CHECK(told.back() == choice.setting);
}

TEST_CASE("target-error: the texture filter stays the one that was asked for") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/texture.json", true).description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    RenderOptions options = wholePicture(scene, 24);
    options.bilinear = true;
    CHECK(choose(*renderer, options, 0.05).setting.bilinear);
}
