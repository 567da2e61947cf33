// The trade of speed for accuracy: what its charts claim, and what --target-error promises.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "../../src/accuracy/depth.h"
#include "../../src/accuracy/picture_points.h"
#include "../support/described.h"
#include "raytracer/accuracy/target_error.h"
#include "raytracer/accuracy/tradeoff_report.h"
#include "raytracer/pictures/color_sink.h"
#include "raytracer/util/text.h"

using namespace raytracer;
using namespace raytracer::test;
using Catch::Matchers::Contains;

namespace {

// Calls test(scene, renderer, options) for every scene in scenes/, `longEdge` pixels large.
template <class Test>
void forEveryScene(int longEdge, Test test) {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        test(scene, *makeRenderer(scene, Precision::Double), wholePicture(scene, longEdge));
    }
}

std::vector<glm::dvec3> colorsOf(const Renderer& renderer, const RenderOptions& options) {
    ColorSink sink(options.crop);
    renderer.render(options, sink);
    return sink.colors();
}

// Of 1, 4 and 16 samples, against many others.
std::vector<CostAndError> errorsOfSamples(const Renderer& renderer, const RenderOptions& options) {
    RenderOptions many = withSetting(options, {.samples = 256});
    many.sequence = 1;
    const std::vector<glm::dvec3> truth = colorsOf(renderer, many);
    std::vector<CostAndError> points;
    for (const int samples : {1, 4, 16})
        points.push_back(
            {static_cast<double>(samples),
             pictureError(colorsOf(renderer, withSetting(options, {.samples = samples})), truth).rmse});
    return points;
}

// Balls of glass one in the other, without light of their own, before a bright plane.
SceneDescription glassLayers(int count, bool isMirror) {
    SceneMaker maker;
    maker.material(glm::dvec3(0.8));
    maker.shape(ShapeType::Plane, {"", glm::dvec3(0, 0, -1), {}, {}, {}});
    MaterialDescription& glass = maker.glass(glm::dvec3(0.95), 1.3);
    glass.reflective = isMirror;
    glass.color_reflect = glm::dvec3(0.95);
    for (int i = 0; i < count; ++i)
        maker.shape(ShapeType::Sphere, {"", {}, {}, glm::dvec3(0.4 - 0.04 * i), {}});
    maker.light({3, 2, 9});
    return maker.scene;
}

}  // namespace

TEST_CASE("on every scene the error falls with the samples, faster than that of random ones") {
    forEveryScene(24, [](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const std::vector<CostAndError> points = errorsOfSamples(renderer, options);
        for (std::size_t i = 1; i < points.size(); ++i) CHECK(points[i].error < points[i - 1].error);
        CHECK(fallRate(points) > 0.5);
    });
}

TEST_CASE("the error falls with the samples at the rate that the chart claims") {
    for (const char* name : {"spheres_cylinder", "checker_horizon"}) {
        INFO(name);
        const SceneDescription scene =
            loadScene(std::string(SOURCE_DIR "/scenes/") + name + ".json").description;
        const SceneTradeoff chart =
            measureTradeoff(name, scene, {.size = 24, .samples = 16, .repeats = 1, .report = {}});
        const auto renderer = makeRenderer(scene, Precision::Double);
        const RenderOptions options = wholePicture(scene, 32);
        const double rate = fallRate(errorsOfSamples(*renderer, options));
        REQUIRE(chart.sampleRate);
        INFO("rate " << rate << ", the chart's " << *chart.sampleRate);
        CHECK(std::abs(rate - *chart.sampleRate) < 0.15);
        CHECK_THAT(tradeoffTable(chart), Contains(formatted("falls like samples^-%.2f.", *chart.sampleRate)));
        CHECK_THAT(tradeoffSvg(std::span(&chart, 1)), Contains("sampling error: samples<"));
    }
}

TEST_CASE("one number of samples tells no rate, and none is claimed") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/spheres_cylinder.json").description;
    const SceneTradeoff chart =
        measureTradeoff("one", scene, {.size = 12, .samples = 1, .repeats = 1, .report = {}});
    CHECK(!chart.sampleRate);
    CHECK(tradeoffTable(chart).find("falls like") == std::string::npos);
    CHECK(tradeoffSvg(std::span(&chart, 1)).find("sampling error") == std::string::npos);
}

TEST_CASE(
    "the reference takes shapes that touch up to the rounding of their decimals as touching, as pictures "
    "do") {
    // In double the cubes touch at z = 0.2. In extended precision there is a gap of 3e-17.
    SceneDescription scene = loadScene(SOURCE_DIR "/test/accuracy/touching_cubes.json").description;
    const SceneTradeoff chart =
        measureTradeoff("touching", scene, {.size = 40, .samples = 16, .repeats = 1, .report = {}});
    const auto best =
        std::ranges::min_element(chart.truncation, {}, [](const Trial& t) { return t.error.rmse; });
    CHECK(best->error.rmse < 0.01);
}

TEST_CASE("the errors of the arithmetic are those of the precisions that were computed") {
    SceneDescription scene = loadScene(SOURCE_DIR "/scenes/cone_cube.json").description;
    const auto precisions = [&] {
        const SceneTradeoff chart =
            measureTradeoff("scene", scene, {.size = 12, .samples = 1, .repeats = 1, .report = {}});
        std::vector<Precision> found;
        for (const Trial& trial : chart.arithmetic) found.push_back(trial.precision);
        return found;
    };
    using enum Precision;
    CHECK(precisions() == std::vector{Extended, Double, Float, Extended, Double, Float});
    scene.camera.eye *= 3e4;  // too far away for float
    CHECK(precisions() == std::vector{Extended, Double, Extended, Double});
}

TEST_CASE("a chart shows errors of any size, and none at all") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/spheres_cylinder.json").description;
    SceneTradeoff chart =
        measureTradeoff("small", scene, {.size = 12, .samples = 4, .repeats = 1, .report = {}});
    const auto heights = [&] {
        const std::string svg = tradeoffSvg(std::span(&chart, 1));
        std::string all;
        for (std::size_t at = 0; (at = svg.find(" cy='", at)) != svg.npos; ++at) all += svg.substr(at, 12);
        return all;
    };
    const auto before = heights();
    for (Trial& trial : chart.truncation) trial.error.rmse *= 1e-12;
    CHECK(heights() == before);
    for (Trial& trial : chart.truncation) trial.error.rmse = 0;
    CHECK(heights().find('n') == std::string::npos);  // nan
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
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/spheres_cylinder.json").description;
    const SceneTradeoff measured =
        measureTradeoff("spheres", scene, {.size = 24, .samples = 9, .repeats = 3, .report = {}});
    const Trial* last = nullptr;
    for (const Trial& trial : measured.truncation) {
        CHECK(trial.precision == Precision::Double);
        if (!trial.onFront) continue;
        CHECK(trial.timings.size() == 3);
        if (last) CHECK((trial.error.rmse < last->error.rmse && trial.seconds() > last->seconds()));
        last = &trial;
    }
    REQUIRE(last != nullptr);
    CHECK(std::ranges::count(measured.truncation, Setting{}, &Trial::setting) == 1);
    CHECK(measured.reference.doublingError < last->error.rmse);
    for (const Trial& trial : measured.arithmetic) {
        CHECK(trial.setting.max_recursion ==
              Setting{}.max_recursion);  // the same samples, so that only arithmetic differs
        if (trial.precision == Precision::Extended) CHECK(trial.error.rmse == 0);
        if (trial.precision == Precision::Double) CHECK(trial.error.rmse < 1e-12);
        if (trial.precision == Precision::Float) CHECK((trial.error.rmse > 1e-10 && trial.error.rmse < 1e-3));
    }
    CHECK(!measured.exhibits.empty());
}

TEST_CASE("a reference has no cutoff, but where glass would take many times the rays") {
    int cut = 0;
    forEveryScene(12, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const Reference reference = makeReference(renderer, options, 1);
        const Setting whole{.max_recursion = reference.setting.max_recursion};
        const Setting glass{.max_recursion = whole.max_recursion, .cutoff = 1e-5};
        const bool isCut = reference.setting.cutoff > 0;
        cut += isCut;
        const auto rays = [&](const Setting& setting) {
            ColorSink sink(options.crop);
            return renderer.render(withSetting(options, setting), sink).all();
        };
        CHECK(isCut == (rays(whole) > 4 * rays(glass)));
        CHECK(isCut == (reference.cutoffBound > 0));
        CHECK(reference.cutoffBound < 0.01);
    });
    CHECK(cut == 1);  // nested_glass
}

TEST_CASE("ray trees tell what every depth costs and leaves out") {
    forEveryScene(32, [](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        const std::vector<glm::dvec2> points = picturePoints(options.size, 500, PointsFor::depth);
        const Setting deepest{.max_recursion = 9, .cutoff = 0.02};
        RenderCounts spent;
        const Depths depths(renderer, options, points, deepest, {0.02, 0.1, 0.5}, spent);
        const auto render = [&](const Setting& setting, std::vector<glm::dvec3>& colors) {
            colors.resize(points.size());
            return renderer.renderPoints(withSetting(options, setting), points, colors).all();
        };
        std::vector<glm::dvec3> truth, colors;
        render(deepest, truth);
        for (const int depth : {0, 1, 2, 5, 9})
            for (const double cutoff : {0.02, 0.1, 0.5}) {
                INFO(depth << ", cutoff " << cutoff);
                const auto rays =
                    static_cast<double>(render({.max_recursion = depth, .cutoff = cutoff}, colors));
                const DepthChoice choice = depths.measured(depth, cutoff);
                CHECK(choice.max_recursion == depth);
                CHECK(choice.cutoff == (choice.max_recursion == 0 ? 0 : cutoff));
                CHECK(choice.rays == Approx(rays / 500));
                CHECK(std::sqrt(choice.squaredError) ==
                      Approx(pictureError(colors, truth).rmse).margin(1e-12));
            }
    });
}

TEST_CASE("ray trees of huge colours stay finite") {
    SceneDescription scene = loadScene(SOURCE_DIR "/scenes/refraction.json").description;
    for (LightDescription& light : scene.lights) light.color = glm::dvec3(1e300);
    const RenderOptions options = wholePicture(scene, 16);
    RayTrees trees;
    const RenderOptions deep = withSetting(options, {.max_recursion = 6, .cutoff = 0.1});
    makeRenderer(scene, Precision::Double)
        ->rayTrees(deep, picturePoints(options.size, 256, PointsFor::depth), trees);
    for (const RayTreeNode& ray : trees.rays) CHECK(std::isfinite(glm::dot(ray.light, glm::dvec3(1))));
}

TEST_CASE("target-error: the error is hardly ever above it, never far, on every scene") {
    int cases = 0, above = 0;
    forEveryScene(48, [&](const SceneDescription&, const Renderer& renderer, const RenderOptions& options) {
        RenderOptions deep = withSetting(options, {4096, 0.004, 16, 0.002});
        deep.sequence = 7;
        const std::vector<glm::dvec3> truth = colorsOf(renderer, deep);
        for (const double target : {0.1, 0.03, 0.01}) {
            const TargetChoice choice = chooseSetting(renderer, options, target);
            INFO(commandLine(choice.setting) << " for " << target);
            CHECK(choice.reached);
            const auto colors = colorsOf(renderer, withSetting(options, choice.setting));
            const double error = pictureError(colors, truth).rmse;
            CHECK(error <= 1.2 * target);
            ++cases;
            above += error > target;
        }
    });
    CHECK(20 * above <= cases);
}

TEST_CASE("target-error: the error is estimated without bias") {
    double estimated = 0;  // parts of the measured squared errors
    for (const char* name : {"cone_cube", "texture", "extreme_scale", "mesh"}) {
        const SceneDescription scene =
            loadScene(std::string(SOURCE_DIR "/scenes/") + name + ".json").description;
        const auto renderer = makeRenderer(scene, Precision::Double);
        RenderOptions options = wholePicture(scene, 64);
        RenderOptions others = withSetting(options, {4096, 0.005, 4, 0.005});
        others.sequence = 1000;
        const std::vector<glm::dvec3> truth = colorsOf(*renderer, others);
        double estimates = 0, errors = 0;
        for (std::uint32_t sequence = 0; sequence < 96; sequence += 3) {
            options.sequence = sequence;
            const TargetChoice choice = chooseSetting(*renderer, options, 0.03);
            estimates += choice.sampleError * choice.sampleError;
            const auto colors =
                colorsOf(*renderer, withSetting(options, {4096, choice.setting.adaptive, 4, 0.005}));
            errors += std::pow(pictureError(colors, truth).rmse, 2);
        }
        estimated += estimates / errors / 4;
    }
    INFO(estimated);
    CHECK(std::abs(estimated - 1) < 0.15);
}

TEST_CASE("target-error: where nothing reaches it, no promise") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/checker_horizon.json").description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    CHECK(!chooseSetting(*renderer, wholePicture(scene, 2), 1e-7).reached);
}

// The rays double at each of many bounces in glass whose reflections are as bright, and nobody can follow
// them.
TEST_CASE("target-error: where the rays would be too many it goes less deep, without a promise") {
    for (const bool isMirror : {true, false}) {
        const SceneDescription scene = glassLayers(6, isMirror);
        const auto renderer = makeRenderer(scene, Precision::Double);
        const TargetChoice choice = chooseSetting(*renderer, wholePicture(scene, 16), 0.02);
        CHECK(choice.isLimited == isMirror);
        CHECK(choice.reached == !isMirror);
        CHECK(choice.setting.max_recursion >= 4);
    }
}

TEST_CASE(
    "target-error: what is behind layers of clear glass is seen, though the first of them show nothing") {
    const SceneDescription scene = glassLayers(3, false);
    const auto renderer = makeRenderer(scene, Precision::Double);
    CHECK(chooseSetting(*renderer, wholePicture(scene, 16), 0.05).setting.max_recursion >= 6);
}

TEST_CASE("target-error: the choice is the whole picture's, whatever the crop and the threads") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/texture.json").description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    RenderOptions options = wholePicture(scene, 60), part = options;
    part.crop = {7, 3, 20, 33};
    part.threads = 3;
    options.threads = 1;
    CHECK(chooseSetting(*renderer, options, 0.02).setting == chooseSetting(*renderer, part, 0.02).setting);
}

TEST_CASE("target-error: the texture filter stays the one that was asked for") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/texture.json").description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    RenderOptions options = wholePicture(scene, 24);
    options.bilinear = true;
    CHECK(chooseSetting(*renderer, options, 0.05).setting.bilinear);
}

TEST_CASE("a search casts some 65536 rays for each pixel, and says what is left") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/refraction.json").description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    for (const int size : {1, 4}) {
        const RenderOptions options = wholePicture(scene, size);
        const TargetChoice choice = chooseSetting(*renderer, options, 1e-8);
        const auto bound = static_cast<std::uint64_t>(options.crop.area()) << 16;
        CHECK(choice.counts.all() >= bound);
        CHECK(choice.counts.all() < 3 * bound + (1 << 18));  // the depth's points, and the last step
        CHECK_FALSE(choice.reached);
        CHECK_FALSE(choice.isLimited);
        CHECK(choice.sampleError > 1e-6);
        CHECK(choice.setting.samples < mostSamples);
    }
}
