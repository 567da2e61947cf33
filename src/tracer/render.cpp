#include "render.h"

#include <algorithm>
#include <list>
#include <mutex>
#include <vector>

#include "point_stream.h"
#include "ray_tree_observer.h"
#include "raytracer/tracer/renderer.h"
#include "tile.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();

// The rays that pilot samples may cast together, which is also the limit of each thread. So the outcome is
// the same for any number of threads, and n threads cast at most n times as many.
std::uint64_t mostRaysOf(std::span<const glm::dvec2> points) { return mostRaysOfSample * points.size(); }

// Does every job, on options.threads threads. Each thread makes its `work` by workOf(context), and calls
// work(job).
template <class WorkOf>
RenderCounts shareOut(const Scene& scene, const RenderOptions& options, std::size_t jobs,
                      ProgressListener* progress, std::uint64_t mostRays, WorkOf workOf) {
    std::mutex mutex;
    std::list<RenderCounts> counts;  // of each thread
    const auto all = [&] {
        RenderCounts sum;
        for (const RenderCounts& some : counts) sum += some;
        return sum;
    };
    std::size_t done = 0;
    std::vector<Color> brightest;
    if (options.cutoff > 0) brightest = scene.brightestColors(options.max_recursion);
    const auto newCounts = [&] {
        const std::lock_guard lock(mutex);
        return &counts.emplace_back();
    };
    const auto workOnJobs = [&](JobQueue& queue) {
        const RenderContext context{&options, brightest.empty() ? nullptr : brightest.data(), newCounts(),
                                    nullptr, mostRays};
        auto work = workOf(context);
        for (std::uint32_t job; queue.next(job);) {
            work(job);
            if (!progress) continue;
            const std::lock_guard lock(mutex);
            progress->progress(static_cast<double>(++done) / static_cast<double>(jobs));
        }
    };
    try {
        onTracingThreads(static_cast<std::uint32_t>(jobs), options, workOnJobs);
    } catch (const TooManyRays&) {  // with the counts of one thread
        throw TooManyRays(all());
    }
    if (all().onwards() > mostRays) throw TooManyRays(all());
    return all();
}

constexpr std::size_t batchSize = 64;  // points that a thread takes at once

std::size_t batchCount(std::size_t points) { return (points + batchSize - 1) / batchSize; }

}  // namespace

void onTracingThreads(std::uint32_t jobs, const RenderOptions& options,
                      const std::function<void(JobQueue&)>& work) {
    const std::size_t stack = usualStack + static_cast<std::size_t>(options.max_recursion) * recursionStack;
    if (onThreads(jobs, options.threads, work, stack)) return;
    std::string lower;
    if (const std::size_t there = mainStack(); there >= usualStack)
        lower = "lower it to " + std::to_string((there - usualStack) / recursionStack) + ", or ";
    throw Error("--max-recursion " + std::to_string(options.max_recursion) +
                " needs a thread, and none can be made: " + lower + "set ulimit -s " +
                std::to_string((limitForMainStack(stack) + 1023) / 1024));
}

RenderCounts renderPicture(const Scene& scene, const RenderOptions& options, PixelSink& sink,
                           ProgressListener* progress, const FirstSamples* first) {
    const std::vector<PixelRectangle> tiles = tilesOf(options.crop, options.part);
    return shareOut(scene, options, tiles.size(), progress, unlimited, [&](const RenderContext& context) {
        return [&, render = tileRenderer(scene, context, first, sink)](std::uint32_t job) {
            render(tiles[job]);
        };
    });
}

RenderCounts renderPoints(const Scene& scene, const RenderOptions& options,
                          std::span<const glm::dvec2> points, std::span<glm::dvec3> colors) {
    const auto renderBatch = [&](std::uint32_t job, const RenderContext& context) {
        PointStream stream(scene, context,
                           [&](std::size_t i, const glm::dvec3& color, const SampleTrace& trace) {
                               colors[i] = color;
                               double& bound = context.counts->cutoffBound;
                               bound = std::max(bound, trace.truncationBound);
                           });
        const std::size_t begin = std::size_t{job} * batchSize;
        for (std::size_t i = begin; i < std::min(begin + batchSize, points.size()); ++i)
            stream.add(i, points[i]);
        stream.finish();
    };
    return shareOut(
        scene, options, batchCount(points.size()), nullptr, mostRaysOf(points),
        [&](const RenderContext& context) { return [&](std::uint32_t job) { renderBatch(job, context); }; });
}

RenderCounts traceRayTrees(const Scene& scene, const RenderOptions& options,
                           std::span<const glm::dvec2> points, RayTrees& trees) {
    RenderOptions shaded = options;
    shaded.pass = Pass::Color;
    std::vector<RayTrees> parts(batchCount(points.size()));
    const auto traceBatch = [&](std::uint32_t job, const RenderContext& context) {
        RayTreeObserver watching[PointPacket::most];
        PointStream stream(scene, context, [&](std::size_t i, const glm::dvec3&, const SampleTrace&) {
            watching[i % PointPacket::most].moveTo(parts[job]);
        });
        const std::size_t begin = std::size_t{job} * batchSize;
        for (std::size_t i = begin; i < std::min(begin + batchSize, points.size()); ++i)
            stream.add(i, points[i], &watching[i % PointPacket::most]);
        stream.finish();
    };
    const RenderCounts counts = shareOut(
        scene, shaded, parts.size(), nullptr, mostRaysOf(points),
        [&](const RenderContext& context) { return [&](std::uint32_t job) { traceBatch(job, context); }; });
    trees = {};
    for (const RayTrees& part : parts) {
        const std::size_t before = trees.rays.size();
        trees.rays.insert(trees.rays.end(), part.rays.begin(), part.rays.end());
        for (const std::size_t end : part.ends) trees.ends.push_back(before + end);
    }
    for (const Color& brightest : scene.brightestColors(options.max_recursion))
        trees.brightest.push_back(asDouble(brightest));
    return counts;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
