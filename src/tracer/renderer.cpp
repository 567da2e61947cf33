#include "raytracer/tracer/renderer.h"

#include <algorithm>
#include <cmath>

namespace raytracer {

// Each is defined by render.cpp, compiled for that precision.
namespace float_precision {
std::unique_ptr<Renderer> makeCoreRenderer(const SceneDescription& scene, const BuildOptions& options);
}
inline namespace double_precision {  // the default, types.h
std::unique_ptr<Renderer> makeCoreRenderer(const SceneDescription& scene, const BuildOptions& options);
}
namespace extended_precision {
std::unique_ptr<Renderer> makeCoreRenderer(const SceneDescription& scene, const BuildOptions& options);
}

namespace {

std::unique_ptr<Renderer> makeRendererIn(Precision precision, const SceneDescription& scene,
                                         const BuildOptions& options) {
    switch (precision) {
        case Precision::Float: return float_precision::makeCoreRenderer(scene, options);
        case Precision::Extended: return extended_precision::makeCoreRenderer(scene, options);
        case Precision::Double: break;
    }
    return double_precision::makeCoreRenderer(scene, options);
}

}  // namespace

std::unique_ptr<Renderer> makeRenderer(const SceneDescription& scene, Precision precision,
                                       const BuildOptions& options) {
    auto renderer = makeRendererIn(precision, scene, options);
    for (const Precision wider : {Precision::Double, Precision::Extended})
        if (!renderer->fits() && wider > precision) renderer = makeRendererIn(wider, scene, options);
    return renderer;
}

void onTracingThreads(std::uint32_t jobs, int threads, int max_recursion,
                      const std::function<void(JobQueue&)>& work) {
    const std::size_t stack = usualStack + static_cast<std::size_t>(max_recursion) * recursionStack;
    if (onThreads(jobs, threads, work, stack)) return;
    std::string lower;
    if (const std::size_t there = mainStack(); there >= usualStack)
        lower = "lower it to " + std::to_string((there - usualStack) / recursionStack) + ", or ";
    throw Error("--max-recursion " + std::to_string(max_recursion) +
                " needs a thread, and none can be made: " + lower + "set ulimit -s " +
                std::to_string((limitForMainStack(stack) + 1023) / 1024));
}

ImageSize imageSize(const CameraDescription& camera, int longEdge) {
    const double largest = std::max({std::abs(camera.film_left), std::abs(camera.film_right),
                                     std::abs(camera.film_bottom), std::abs(camera.film_top)});
    const auto length = [exponent = std::ilogb(largest)](double from, double to) {
        return std::abs(std::scalbn(to, -exponent) - std::scalbn(from, -exponent));
    };
    const double width = length(camera.film_left, camera.film_right);
    const double height = length(camera.film_bottom, camera.film_top);
    // The product first: 750 * 0.6 / 0.8 is 562.5, 750 * (0.6 / 0.8) is less.
    const double shortEdge = longEdge * std::min(width, height) / std::max(width, height);
    const int pixels = std::max(1, static_cast<int>(std::lround(shortEdge)));
    return width >= height ? ImageSize{longEdge, pixels} : ImageSize{pixels, longEdge};
}

void keepTerms(SceneDescription& scene, const Terms& terms) {
    for (MaterialDescription& material : scene.materials) {
        if (!terms.ambient) material.color_ambient = glm::dvec3(0);
        if (!terms.diffuse) material.color_diffuse = glm::dvec3(0);
        if (!terms.specular) material.color_specular = glm::dvec3(0);
        if (!terms.reflections) material.reflective = false;
        if (!terms.textures) material.use_diffuse_texture = false;
    }
}

void makeOpaque(SceneDescription& scene) {
    for (MaterialDescription& material : scene.materials) material.refractive = false;
}

TooManyRays::TooManyRays(const RenderCounts& cast)
    : Error("more than " + std::to_string(mostRaysOfSample) +
            " reflected and refracted rays a sample: a lower --max-recursion or a --cutoff bounds them"),
      cast_(cast) {}

RenderCounts& RenderCounts::operator+=(const RenderCounts& other) {
    primary += other.primary;
    shadow += other.shadow;
    reflection += other.reflection;
    refraction += other.refraction;
    tests += other.tests;
    limited += other.limited;
    cutoffBound = std::max(cutoffBound, other.cutoffBound);
    return *this;
}

}  // namespace raytracer
