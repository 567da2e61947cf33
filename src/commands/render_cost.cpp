#include "render_cost.h"

#include <algorithm>

#include "raytracer/accuracy/ray_growth.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/util/parallel.h"
#include "raytracer/util/stopwatch.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

void remarkOnRays(const RenderArguments& arguments, const SceneDescription& scene, const Renderer& renderer,
                  const RenderOptions& options) {
    const auto rays = excessiveRays(scene, renderer, options);
    if (!rays) return;
    arguments.remark(
        formatted("--max-recursion %d takes about %.1g reflected and refracted rays a sample: they "
                  "double with each bounce where a material is both; a lower one takes fewer, or a --cutoff "
                  "where color_reflect and color_refract are less than 1",
                  options.max_recursion, *rays));
}

// Of one sample on one thread, in seconds: by a small picture of the same view.
double timeOfSample(const Renderer& renderer, RenderOptions options) {
    constexpr int longEdge = 64;  // some milliseconds
    const int longer = std::max(options.size.width, options.size.height);
    const auto shortened = [&](int edge) { return std::max(1, edge * longEdge / longer); };
    options.size = {shortened(options.size.width), shortened(options.size.height)};
    options.crop = {0, 0, options.size.width, options.size.height};
    options.samples = 1;
    options.threads = 1;
    const auto once = [&] {
        ByteSink sink(options.crop);
        Stopwatch watch;
        renderer.render(options, sink);
        return watch.lap().cpu;  // other programs take no part
    };
    once();  // fetches the scene into the caches
    return once() / static_cast<double>(options.crop.area());
}

void remarkOnTime(const RenderArguments& arguments, const Renderer& renderer, const RenderOptions& options) {
    constexpr double few = 3e7;  // samples: of any of our scenes they take less than a minute
    constexpr double longTime = 60;
    const double samples = static_cast<double>(options.crop.area()) * options.samples;
    if (samples < few || options.adaptive > 0) return;
    const double seconds = samples * timeOfSample(renderer, options) / threadCount(options.threads);
    if (seconds < longTime) return;
    const bool isSampled = options.samples > 1;
    arguments.remark(formatted("%d × %d pixels", options.crop.width(), options.crop.height()) +
                     (isSampled ? formatted(" of %d samples", options.samples) : "") + " take about " +
                     durationInWords(seconds) + "; " +
                     (isSampled ? "--adaptive 0.02 takes less" : "a smaller size takes less"));
}

}  // namespace

std::string durationInWords(double seconds) {
    if (seconds < 0.01) return "under 0.01 s";
    if (seconds < 60) return formatted("%.2f s", seconds);
    if (seconds < 3600) return formatted("%.0f min", seconds / 60);
    if (seconds < 48 * 3600) return formatted("%.1f h", seconds / 3600);
    return formatted("%.1f days", seconds / 86400);
}

void remarkOnCost(const RenderArguments& arguments, const SceneDescription& scene, const Renderer& renderer,
                  const RenderOptions& options) {
    if (arguments.quiet) return;
    remarkOnRays(arguments, scene, renderer, options);
    remarkOnTime(arguments, renderer, options);
}

}  // namespace raytracer::commands
