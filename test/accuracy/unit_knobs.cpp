// The knobs that trade speed for accuracy: what each promises, on every scene.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "../support/scene_files.h"
#include "raytracer/accuracy/picture_error.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/accuracy/target_error.h"
#include "raytracer/accuracy/target_time.h"
#include "raytracer/pictures/color_sink.h"
#include "raytracer/tracer/sample_sequence.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

struct Shot {
    std::vector<glm::dvec3> colors;
    RenderCounts counts;
    double rays() const { return static_cast<double>(counts.all()); }
};

Shot shoot(const Renderer& renderer, const RenderOptions& options, const Setting& setting) {
    ColorSink sink(options.crop);
    Shot shot;
    shot.counts = renderer.render(withSetting(options, setting), sink);
    shot.colors = sink.colors();
    return shot;
}

double largestDifference(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::dvec3 difference = glm::abs(a[i] - b[i]);
        largest = std::max({largest, difference.x, difference.y, difference.z});
    }
    return largest;
}

// Calls test(renderer, options) for every scene in scenes/, `longEdge` pixels large.
template <class Test>
void withEveryRenderer(int longEdge, Test test) {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        test(*makeRenderer(scene, Precision::Double), wholePicture(scene, longEdge));
    }
}

constexpr int smallEdge = 48;  // pixels

// Two mirrors that face each other, infinite, without end; the camera and the light are between them.
SceneDescription facingMirrors(double reflect, double ambient) {
    SceneDescription scene;
    scene.camera.look = {0.05, 0.03, -1};
    setFilm(scene, -0.1, 0.1);
    MaterialDescription mirror;
    mirror.color_ambient = glm::dvec3(ambient);
    mirror.color_diffuse = mirror.color_specular = glm::dvec3(0);
    mirror.reflective = true;
    mirror.color_reflect = glm::dvec3(reflect);
    scene.materials = {mirror};
    scene.lights.resize(1);
    scene.transforms.resize(2);
    scene.transforms[0].translate = glm::dvec3(0, 0, 1);
    scene.transforms[1].translate = glm::dvec3(0, 0, -1);
    for (std::size_t i = 0; i < 2; ++i) scene.shapes.push_back({ShapeType::Plane, i, 0, nullptr});
    return scene;
}

}  // namespace

TEST_CASE("no pixel is off by more than the bound that a cutoff reports") {
    withEveryRenderer(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
        for (const int samples : {1, 4}) {
            const Setting exact{.samples = samples, .max_recursion = 6};
            const Shot whole = shoot(renderer, options, exact);
            CHECK(whole.counts.cutoffBound == 0);
            for (const double cutoff : {0.001, 0.01, 0.1, 1.0}) {
                INFO("--samples " << samples << " --cutoff " << cutoff);
                Setting setting = exact;
                setting.cutoff = cutoff;
                const Shot cut = shoot(renderer, options, setting);
                CHECK(largestDifference(cut.colors, whole.colors) <= cut.counts.cutoffBound * (1 + 1e-12));
            }
        }
    });
}

TEST_CASE("a cutoff that no ray falls below changes nothing") {
    withEveryRenderer(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
        const Shot whole = shoot(renderer, options, {}), cut = shoot(renderer, options, {.cutoff = 1e-30});
        CHECK(largestDifference(cut.colors, whole.colors) == 0);
        CHECK(cut.rays() == whole.rays());
    });
}

TEST_CASE("facing mirrors, 64 deep, with a cutoff cost what their visible bounces cost") {
    // The mirror's own light is 1/2, and all that it shows at most 1 = sum 1/2^k / 2, so that the k-th
    // reflection can change its pixel by 1/2^k: the eighth by 1/256.
    const SceneDescription scene = facingMirrors(0.5, 0.5);
    const auto renderer = makeRenderer(scene, Precision::Double);
    const RenderOptions options = wholePicture(scene, 16);
    const double pixels = 16 * 16;
    const Shot deep = shoot(*renderer, options, {.max_recursion = 64});
    REQUIRE(static_cast<double>(deep.counts.reflection) == 64 * pixels);
    const Shot cut = shoot(*renderer, options, {.max_recursion = 64, .cutoff = 1.0 / 250});
    CHECK(static_cast<double>(cut.counts.reflection) == 7 * pixels);
    const Shot shallow = shoot(*renderer, options, {.max_recursion = 7});
    CHECK(cut.rays() == shallow.rays());
    CHECK(largestDifference(cut.colors, shallow.colors) == 0);
    CHECK(largestDifference(cut.colors, deep.colors) <= cut.counts.cutoffBound);
    CHECK(cut.counts.cutoffBound == 1.0 / 256);
}

TEST_CASE("the mirror corridor, 64 deep, with a cutoff costs what its visible bounces cost") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/mirror_corridor.json").description;
    const auto renderer = makeRenderer(scene, Precision::Double);
    const RenderOptions options = wholePicture(scene, 64);
    const Shot deep = shoot(*renderer, options, {.max_recursion = 64});
    for (const double cutoff : {0.1, 0.3, 1.0}) {
        INFO("--cutoff " << cutoff);
        const Shot cut = shoot(*renderer, options, {.max_recursion = 64, .cutoff = cutoff});
        int visible = 0;  // the bounces that a depth limit needs to be as close
        const double error = pictureError(cut.colors, deep.colors).rmse;
        while (pictureError(shoot(*renderer, options, {.max_recursion = visible}).colors, deep.colors).rmse >
               error)
            ++visible;
        INFO("as close with --max-recursion " << visible);
        CHECK(cut.rays() <= 1.01 * shoot(*renderer, options, {.max_recursion = visible}).rays());
    }
}

TEST_CASE("counts are monotone in each knob") {
    withEveryRenderer(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
        const auto checkGrowing = [&](const std::vector<Setting>& settings) {
            Shot before;
            for (const Setting& setting : settings) {
                INFO(commandLine(setting));
                const Shot shot = shoot(renderer, options, setting);
                CHECK(shot.counts.primary >= before.counts.primary);
                CHECK(shot.counts.shadow >= before.counts.shadow);
                CHECK(shot.counts.reflection >= before.counts.reflection);
                CHECK(shot.counts.refraction >= before.counts.refraction);
                before = shot;
            }
        };
        checkGrowing({{.max_recursion = 0}, {.max_recursion = 1}, {}, {.max_recursion = 6}});
        checkGrowing(
            {{.max_recursion = 0, .cutoff = 0.1}, {.cutoff = 0.1}, {.max_recursion = 6, .cutoff = 0.1}});
        checkGrowing({{.cutoff = 1}, {.cutoff = 0.1}, {.cutoff = 0.01}, {}});
        checkGrowing({{}, {.samples = 2}, {.samples = 3}, {.samples = 16}});
        checkGrowing({{.samples = 16, .adaptive = 0.1}, {.samples = 16, .adaptive = 0.01}, {.samples = 20}});
        checkGrowing({{}, {.bilinear = true}});  // a black texel needs no shadow ray
    });
}

// The colours of a crop, from those of the whole picture.
std::vector<glm::dvec3> cropped(const std::vector<glm::dvec3>& colors, const ImageSize& size,
                                const PixelRectangle& crop) {
    std::vector<glm::dvec3> part;
    for (int y = crop.y0; y < crop.y1; ++y)
        for (int x = crop.x0; x < crop.x1; ++x)
            part.push_back(colors[static_cast<std::size_t>(y * size.width + x)]);
    return part;
}

TEST_CASE("a crop is what the whole picture has there, whatever the knobs and the threads") {
    withEveryRenderer(80, [](const Renderer& renderer, RenderOptions options) {
        for (const Setting& setting : {Setting{.samples = 16, .adaptive = 0.05, .cutoff = 0.1},
                                       Setting{.samples = 3, .max_recursion = 2}}) {
            INFO(commandLine(setting));
            const Shot whole = shoot(renderer, options, setting);
            const int width = options.size.width, height = options.size.height;
            for (const PixelRectangle& crop : {PixelRectangle{0, 0, 1, 1},
                                               {width / 2, height / 2, width / 2 + 1, height / 2 + 1},
                                               {1, height / 3, width - 3, height},
                                               {width / 3, 0, width / 3 + 2, height - 1}}) {
                RenderOptions part = options;
                part.crop = crop;
                part.threads = 1 + crop.x0 % 3;
                CHECK(shoot(renderer, part, setting).colors == cropped(whole.colors, options.size, crop));
            }
        }
    });
}

TEST_CASE("first samples that are there already are not cast again, and change nothing") {
    withEveryRenderer(smallEdge, [](const Renderer& renderer, RenderOptions options) {
        FirstSamples known;
        renderer.renderFirst(options, known);
        const Setting setting{.samples = 32, .adaptive = 0.05};
        options.crop = {3, 2, options.size.width - 1, options.size.height};
        const Shot all = shoot(renderer, options, setting);
        ColorSink sink(options.crop);
        const RenderCounts counts = renderer.render(withSetting(options, setting), sink, nullptr, &known);
        CHECK(sink.colors() == all.colors);
        CHECK(counts.primary + static_cast<std::uint64_t>(options.crop.area()) <= all.counts.primary);
    });
}

// Each pixel's samples, at the points of the sequence.
std::vector<std::vector<glm::dvec3>> samplesOf(const Renderer& renderer, const RenderOptions& options,
                                               std::uint32_t samples) {
    std::vector<glm::dvec2> points;
    const SampleSequence sequence;
    for (int y = 0; y < options.size.height; ++y)
        for (int x = 0; x < options.size.width; ++x)
            for (std::uint32_t i = 0; i < samples; ++i) points.push_back(glm::dvec2(x, y) + sequence[i]);
    std::vector<glm::dvec3> colors(points.size());
    renderer.renderPoints(options, points, colors);
    std::vector<std::vector<glm::dvec3>> pixels;
    for (std::size_t i = 0; i < colors.size(); i += samples)
        pixels.emplace_back(&colors[i], &colors[i] + samples);
    return pixels;
}

glm::dvec3 meanOf(const std::vector<glm::dvec3>& colors, std::size_t count) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < count; ++i) sum += colors[i];
    return sum / static_cast<double>(count);
}

TEST_CASE("a pixel is the mean of the colours at the points of the sequence") {
    withEveryRenderer(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
        const auto samples = samplesOf(renderer, options, 6);
        for (const int n : {1, 2, 6}) {
            const Shot shot = shoot(renderer, options, {.samples = n});
            std::vector<glm::dvec3> means;
            for (const auto& pixel : samples) means.push_back(meanOf(pixel, static_cast<std::size_t>(n)));
            CHECK(shot.colors == means);
        }
    });
}

// The rule of `adaptive`, plainly: the samples that pixel (x, y) takes, and whether the limit stops it.
std::pair<int, bool> samplesTaken(const std::vector<std::vector<glm::dvec3>>& samples,
                                  const std::vector<ExtraSample>& extra, const ImageSize& size, int x, int y,
                                  int limit, double adaptive) {
    const auto of = [&](int column, int row) -> const auto& {
        return samples[static_cast<std::size_t>(row * size.width + column)];
    };
    glm::dvec3 low(16), high(-16);
    for (int row = std::max(0, y - 1); row <= std::min(size.height - 1, y + 1); ++row)
        for (int column = std::max(0, x - 1); column <= std::min(size.width - 1, x + 1); ++column) {
            const glm::dvec3 color = glm::clamp(of(column, row)[0], -16.0, 16.0);
            low = glm::min(low, color);
            high = glm::max(high, color);
        }
    for (const ExtraSample& sample : extra)
        if (std::abs(sample.pixel().x - x) <= 1 && std::abs(sample.pixel().y - y) <= 1) {
            const glm::dvec3 color = glm::clamp(sample.color, -16.0, 16.0);
            low = glm::min(low, color);
            high = glm::max(high, color);
        }
    const double contrast = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    const double hidden = std::min(1.0, 16 / std::sqrt(static_cast<double>(size.width) * size.height));
    for (int n = 1;; n = std::min(limit, n == 1 ? 4 : 2 * n)) {
        const double weight = n == 1 ? 1 : std::pow(16.0 / n, 0.25);
        double bySamples = 0, byContrast = 0;  // mean squares over the channels
        for (int channel = 0; channel < 3; ++channel) {
            double mean = 0, moment = 0;  // the fourth
            for (int i = 0; i < n; ++i) mean += of(x, y)[i][channel] / n;
            for (int i = 0; i < n; ++i)
                moment += std::pow(of(x, y)[i][channel] - mean, 4) / std::max(1, n - 1);
            const auto shown = [mean](double error) {
                const auto clamped = [](double value) { return std::clamp(value, 0.0, 1.0); };
                const double below = clamped(mean) - clamped(mean - 4 * error);
                return std::min(error, std::max(below, clamped(mean + 4 * error) - clamped(mean)));
            };
            bySamples += std::pow(weight * shown(std::pow(moment, 0.25) / std::pow(n, 0.75)), 2) / 3;
            byContrast += std::pow(weight * shown(contrast / (4 * n)), 2) / 3;
        }
        const double error = std::max(std::sqrt(std::max(bySamples, byContrast)), weight * hidden / (4 * n));
        if (error <= adaptive || n == limit) return {n, error > adaptive};
    }
}

TEST_CASE("an adaptive pixel stops by the rule, and it is counted where the limit stops it") {
    withEveryRenderer(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
        const auto samples = samplesOf(renderer, options, 20);
        FirstSamples first;
        renderer.renderFirst(options, first);
        for (const double adaptive : {0.1, 0.02}) {
            const Shot shot = shoot(renderer, options, {.samples = 20, .adaptive = adaptive});
            std::vector<glm::dvec3> means;
            std::size_t limited = 0;
            for (int y = 0; y < options.size.height; ++y)
                for (int x = 0; x < options.size.width; ++x) {
                    const auto [n, isLimited] =
                        samplesTaken(samples, first.extra, options.size, x, y, 20, adaptive);
                    means.push_back(meanOf(samples[means.size()], static_cast<std::size_t>(n)));
                    limited += isLimited;
                }
            CHECK(shot.colors == means);
            CHECK(shot.counts.limited == limited);
        }
    });
}

TEST_CASE("the error against two estimates of the truth has no bias where samples are brighter than white") {
    // One of 64 samples is 30: the truth is 0.47. Estimates of four samples are 0 or 7.5 or more.
    double sum = 0;
    const auto chance = [](int hits) {
        return std::pow(1 / 64.0, hits) * std::pow(63 / 64.0, 4 - hits) *
               std::array{1, 4, 6, 4, 1}[static_cast<std::size_t>(hits)];
    };
    for (int one = 0; one <= 4; ++one)
        for (int other = 0; other <= 4; ++other)
            sum += chance(one) * chance(other) *
                   squaredError(glm::dvec3(0), glm::dvec3(7.5 * one), glm::dvec3(7.5 * other));
    CHECK(std::sqrt(sum) == Approx(30 / 64.0).epsilon(0.02));
    CHECK(squaredError(glm::dvec3(3), glm::dvec3(2), glm::dvec3(5)) == 0);
}

TEST_CASE("the error against two estimates of the truth is not too small on average in bright pixels") {
    // A part of the samples is 30; n of them are taken three times, independently.
    for (const double part : {0.01, 0.03, 0.1, 0.3})
        for (const int n : {4, 16}) {
            const auto chance = [&](int hits) {
                const double ways = std::tgamma(n + 1) / std::tgamma(hits + 1) / std::tgamma(n - hits + 1);
                return ways * std::pow(part, hits) * std::pow(1 - part, n - hits);
            };
            double estimated = 0, real = 0;
            const auto mean = [&](int hits) { return glm::dvec3(30.0 * hits / n); };
            for (int own = 0; own <= n; ++own) {
                real += chance(own) * squaredError(mean(own), glm::dvec3(30 * part));
                for (int one = 0; one <= n; ++one)
                    for (int other = 0; other <= n; ++other)
                        estimated += chance(own) * chance(one) * chance(other) *
                                     squaredError(mean(own), mean(one), mean(other));
            }
            INFO(part << " " << n);
            CHECK(estimated >= real * (1 - 1e-9));
        }
}

TEST_CASE("the error of a picture is at most what its pixels' errors are estimated to be") {
    withEveryRenderer(100, [](const Renderer& renderer, const RenderOptions& options) {
        const Setting deep{.samples = 1024, .max_recursion = 3, .cutoff = 0.01};
        RenderOptions others = options;
        others.sequence = 1;
        Setting setting = deep;
        setting.adaptive = 0.0025;
        const std::vector<glm::dvec3> truth = shoot(renderer, others, setting).colors;
        for (const double adaptive : {0.1, 0.03, 0.01}) {
            setting.adaptive = adaptive;
            INFO("--adaptive " << adaptive);
            CHECK(pictureError(shoot(renderer, options, setting).colors, truth).rmse <= adaptive);
        }
    });
}

TEST_CASE("target-error: the depth has no end but the scene's own") {
    // The pixels after n reflections: 0.05 sum 0.95^k = 1 - 0.95^(n + 1).
    const SceneDescription scene = facingMirrors(0.95, 0.05);
    const auto renderer = makeRenderer(scene, Precision::Double);
    const RenderOptions options = wholePicture(scene, 16);
    for (const double target : {0.05, 0.01, 0.002}) {
        const TargetChoice choice = chooseSetting(*renderer, options, target);
        CHECK(choice.reached);
        double error = 0;
        for (const glm::dvec3& color : shoot(*renderer, options, choice.setting).colors)
            error = std::max(error, 1 - color.x);
        INFO(commandLine(choice.setting) << " for " << target);
        CHECK(error <= target);
    }
}

TEST_CASE("target-error: a reflection in few pixels of a small picture is seen") {
    // Two small mirrors show each other in some pixels; the rest is black.
    SceneDescription scene = facingMirrors(1, 0.5);
    for (std::size_t i = 0; i < 2; ++i) scene.shapes[i].type = ShapeType::Sphere;
    setFilm(scene, -1, 1);
    scene.camera.eye = {0, 0, 12};
    scene.camera.look = {0, 0, -1};
    for (std::size_t i = 0; i < 2; ++i) {
        scene.transforms[i].translate = glm::dvec3(i == 0 ? 0.6 : -0.6, 0, 0);
        scene.transforms[i].scale = glm::dvec3(0.5);
    }
    const auto renderer = makeRenderer(scene, Precision::Double);
    const RenderOptions options = wholePicture(scene, 40);
    RenderOptions others = options;
    others.sequence = 7;
    const auto truth =
        shoot(*renderer, others, {.samples = 4096, .adaptive = 0.0005, .max_recursion = 64, .cutoff = 1e-5});
    const TargetChoice choice = chooseSetting(*renderer, options, 0.001);
    INFO(commandLine(choice.setting));
    CHECK(pictureError(shoot(*renderer, options, choice.setting).colors, truth.colors).rmse <= 0.001);
}

TEST_CASE("the first samples tell what the recursion left out") {
    const SceneDescription scene = facingMirrors(0.5, 0.5);
    const auto renderer = makeRenderer(scene, Precision::Double);
    RenderOptions options = wholePicture(scene, 16);
    for (const int depth : {0, 3}) {
        options.max_recursion = depth;
        FirstSamples first;
        const RenderCounts counts = renderer->renderFirst(options, first);
        const Shot picture = shoot(*renderer, options, {.max_recursion = depth});
        CHECK(first.colors == picture.colors);
        CHECK(counts.all() == picture.counts.all());
        CHECK(first.leftOut == std::vector<float>(16 * 16, depth == 0 ? 0.5F : 0.0625F));
    }
    options.cutoff = 0.3;  // of 0.5: the next ray's weight times its brightest colour
    FirstSamples cut;
    renderer->renderFirst(options, cut);
    CHECK(cut.leftOut == std::vector<float>(16 * 16, 0.25F));
}

TEST_CASE("target-error: a small window of three clear panes is seen, wherever it is") {
    // Until the last pane the window is black. It covers 0.25 % of the picture.
    SceneDescription scene;
    scene.camera.type = CameraDescription::Type::Orthographic;
    scene.camera.eye = {0, 0, 9};
    setFilm(scene, -3, 3);
    MaterialDescription wall, clear;
    wall.color_diffuse = glm::dvec3(1);
    wall.color_specular = clear.color_diffuse = clear.color_specular = glm::dvec3(0);
    clear.refractive = true;
    clear.color_refract = glm::dvec3(1);
    clear.index_of_refraction = 1;
    scene.materials = {wall, clear};
    scene.lights.resize(1);
    scene.lights[0].position = {0, 0, 9};
    scene.transforms.resize(4);
    scene.transforms[3].translate = glm::dvec3(0, 0, -2);
    scene.shapes.push_back({ShapeType::Plane, 3, 0, nullptr});
    for (std::size_t i = 0; i < 3; ++i) scene.shapes.push_back({ShapeType::Cube, i, 1, nullptr});
    for (const glm::dvec2& place : {glm::dvec2(-1.653, 2.409), glm::dvec2(0.7, -1.1), glm::dvec2(2.2, 0.3)}) {
        for (std::size_t i = 0; i < 3; ++i) {
            scene.transforms[i].translate = glm::dvec3(place, static_cast<double>(i));
            scene.transforms[i].scale = glm::dvec3(0.15, 0.15, 0.01);
        }
        const auto renderer = makeRenderer(scene, Precision::Double);
        const TargetChoice choice = chooseSetting(*renderer, wholePicture(scene, 100), 0.01);
        CHECK(choice.setting.max_recursion == 6);
        CHECK(choice.reached);
    }
}

TEST_CASE("target-error: a search ends where no pilot pixel takes more samples, and soon in bright scenes") {
    // A bright spot at the only pixel's centre: its first sample is white, and no other one meets the spot.
    SceneDescription scene;
    scene.camera.type = CameraDescription::Type::Orthographic;
    setFilm(scene, -1, 1);
    scene.materials.resize(1);
    scene.lights.resize(1);
    scene.transforms.resize(1);
    scene.transforms[0].translate = glm::dvec3(0, 0, -5);
    scene.shapes.push_back({ShapeType::Sphere, 0, 0, nullptr});
    const auto choose = [&](double ambient, double radius, int size, double target) {
        scene.materials[0].color_ambient = glm::dvec3(ambient);
        scene.transforms[0].scale = glm::dvec3(radius);
        return chooseSetting(*makeRenderer(scene, Precision::Double), wholePicture(scene, size), target);
    };
    CHECK(!choose(100, 0.01, 1, 0.3).reached);
    CHECK(choose(1e300, 0.6, 7, 1).reached);
    CHECK(choose(1e300, 0.6, 40, 0.1).counts.primary < 1'000'000);
    CHECK(choose(1, 0.01, 2100, 0.5).setting.samples == 1);
}

TEST_CASE("target-error: white pixels whose samples are not all white do not keep the search from its end") {
    // In each pixel a disc of brightness 1.35 covers 0.8 of it: on average it is brighter than white. But of
    // four samples two may miss the disc.
    SceneDescription scene;
    constexpr int size = 20;
    scene.camera.type = CameraDescription::Type::Orthographic;
    setFilm(scene, 0, size);
    scene.lights.resize(1);
    scene.materials.resize(1);
    scene.materials[0].color_ambient = glm::dvec3(1.35);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            TransformDescription transform;
            transform.translate = glm::dvec3(x + 0.5, y + 0.5, -5);
            transform.scale = glm::dvec3(0.505);
            scene.shapes.push_back({ShapeType::Sphere, scene.transforms.size(), 0, nullptr});
            scene.transforms.push_back(transform);
        }
    const TargetChoice choice =
        chooseSetting(*makeRenderer(scene, Precision::Double), wholePicture(scene, size), 0.02);
    CHECK(choice.reached);
    CHECK(choice.counts.primary < 1'000'000);
}

TEST_CASE("target-error: trees confirm the depth at most once in each pixel") {
    SceneDescription scene = facingMirrors(1, 0.1);  // the second mirror is out of view, and shows nothing
    scene.shapes.pop_back();
    scene.shapes[0].type = ShapeType::Sphere;
    const auto renderer = makeRenderer(scene, Precision::Double);
    const RenderOptions options = wholePicture(scene, 32);
    CHECK(chooseSetting(*renderer, options, 1e-5).counts.primary < 1'000'000);
}

TEST_CASE("target-time: where no time is enough, the fastest setting is chosen") {
    withEveryRenderer(100, [](const Renderer& renderer, const RenderOptions& options) {
        CHECK(chooseForTime(renderer, options, 1e-9).setting == Setting{.max_recursion = 0});
        const Shot one = shoot(renderer, options, {});
        const Shot coarsest = shoot(renderer, options, {.samples = 64, .adaptive = 1});
        CHECK(coarsest.colors == one.colors);
        CHECK(coarsest.counts.primary > one.counts.primary);  // so one sample is faster
    });
}
