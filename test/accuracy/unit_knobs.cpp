// The knobs that trade speed for accuracy: what each promises, on every scene.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/common.hpp>

#include "../support/scene_files.h"
#include "raytracer/accuracy/picture_error.h"
#include "raytracer/accuracy/setting.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

struct Shot {
    std::vector<glm::dvec3> colors;
    RenderCounts counts;
    double rays() const { return rayCount(counts); }
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
void forEveryScene(int longEdge, Test test) {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file, true).description;
        test(*makeRenderer(scene, Precision::Double), wholePicture(scene, longEdge));
    }
}

constexpr int smallEdge = 48;  // pixels

// Two mirrors that face each other, infinite, without end; the camera and the light are between them.
SceneDescription facingMirrors(double reflect, double ambient) {
    SceneDescription scene;
    scene.camera.look = {0.05, 0.03, -1};
    scene.camera.film_left = scene.camera.film_bottom = -0.1;
    scene.camera.film_right = scene.camera.film_top = 0.1;
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
    forEveryScene(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
        for (const int samples : {1, 2}) {
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
    forEveryScene(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
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
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/mirror_corridor.json", true).description;
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
    forEveryScene(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
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
        checkGrowing({{}, {.samples = 2}, {.samples = 3}, {.samples = 4}});
        checkGrowing({{.samples = 4, .adaptive = 1},
                      {.samples = 4, .adaptive = 0.1},
                      {.samples = 4, .adaptive = 0.01},
                      {.samples = 4}});
        checkGrowing({{}, {.bilinear = true}});  // a black texel needs no shadow ray
    });
}

TEST_CASE("some pixels alone are those of the whole picture") {
    forEveryScene(smallEdge, [](const Renderer& renderer, RenderOptions options) {
        const Setting setting{.samples = 3, .adaptive = 0.1, .cutoff = 0.1};
        const Shot whole = shoot(renderer, options, setting);
        std::vector<PixelPlace> pixels;
        for (int y = options.crop.y1 - 1; y >= 0; y -= 3)
            for (int x = y % 7; x < options.crop.x1; x += 7) pixels.push_back({x, y});
        for (const int threads : {1, 3}) {
            options.threads = threads;
            std::vector<glm::dvec3> colors(pixels.size());
            renderer.renderPixels(withSetting(options, setting), pixels, colors);
            const auto width = static_cast<std::size_t>(options.size.width);
            bool equal = true;
            for (std::size_t i = 0; i < pixels.size(); ++i)
                equal = equal && colors[i] == whole.colors[static_cast<std::size_t>(pixels[i].y) * width +
                                                           static_cast<std::size_t>(pixels[i].x)];
            CHECK(equal);
        }
    });
}

// The mean over n x n of its pixels for each pixel of a picture; over the four at a pixel's corners alone.
std::vector<glm::dvec3> shrunk(const std::vector<glm::dvec3>& colors, const ImageSize& size, int n,
                               bool onlyCorners) {
    const auto isOuter = [&](int k) { return k == 0 || k == n - 1; };
    std::vector<glm::dvec3> means;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            glm::dvec3 sum(0);
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    if (!onlyCorners || (isOuter(i) && isOuter(j)))
                        sum += colors[(static_cast<std::size_t>(n) * y + j) * n * size.width + n * x + i];
            means.push_back(sum / (onlyCorners ? 4.0 : n * n));
        }
    return means;
}

TEST_CASE("a pixel's samples are the pixels of a picture so many times as large") {
    forEveryScene(smallEdge, [](const Renderer& renderer, const RenderOptions& options) {
        constexpr int n = 3;
        RenderOptions large = options;
        large.size = {n * options.size.width, n * options.size.height};
        large.crop = {0, 0, large.size.width, large.size.height};
        const std::vector<glm::dvec3> colors = shoot(renderer, large, {}).colors;
        for (const double adaptive : {0.0, 1.0}) {  // 1: the corners stand for all
            const auto sampled = shoot(renderer, options, {.samples = n, .adaptive = adaptive}).colors;
            const auto means = shrunk(colors, options.size, n, adaptive == 1);
            std::size_t off = 0;
            for (std::size_t i = 0; i < means.size(); ++i) off += squaredError(sampled[i], means[i]) > 1e-16;
            CHECK(off <= means.size() / 500);  // where a point is rounded to the other side of an edge
        }
    });
}

TEST_CASE("the knobs' defaults are a render's own") {
    const RenderOptions usual;
    const RenderOptions set = withSetting(usual, {});
    CHECK(set.samples == usual.samples);
    CHECK(set.adaptive == usual.adaptive);
    CHECK(set.max_recursion == usual.max_recursion);
    CHECK(set.cutoff == usual.cutoff);
    CHECK(set.bilinear == usual.bilinear);
}
