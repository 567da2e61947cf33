#include <algorithm>
#include <list>
#include <mutex>
#include <vector>

#include "point_stream.h"
#include "raytracer/tracer/scene_builder.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/parallel.h"
#include "scene_renderer.h"
#include "small_parts.h"
#include "tile.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();

// The rays that pilot samples may cast together, which is also the limit of each thread. So the outcome is
// the same for any number of threads, and n threads cast at most n times as many.
std::uint64_t mostRaysOf(std::span<const glm::dvec2> points) { return mostRaysOfSample * points.size(); }

constexpr std::size_t batchSize = 64;  // points that a thread takes at once

std::size_t batchCount(std::size_t points) { return (points + batchSize - 1) / batchSize; }

// Traces the points of a batch. observerOf(i): null where there is none.
template <class ObserverOf, class Take>
void traceBatch(const Scene& scene, const RenderContext& context, std::span<const glm::dvec2> points,
                std::uint32_t batch, ObserverOf observerOf, Take take) {
    PointStream stream(scene, context, take);
    const std::size_t begin = std::size_t{batch} * batchSize;
    for (std::size_t i = begin; i < std::min(begin + batchSize, points.size()); ++i)
        stream.add(i, points[i], observerOf(i));
    stream.finish();
}

// Records what each ray behind a point contributes.
class RayTreeObserver final : public Observer {
  public:
    bool asksWhatShadows() const override { return false; }
    void enter(const Ray&, const RayPath& path) override {
        if (open_.empty()) max_recursion_ = path.max_recursion;
        open_.push_back(rays_.size());
        RayTreeNode ray;
        ray.weight = asDouble(path.weight);
        ray.depth = static_cast<std::uint16_t>(max_recursion_ - path.max_recursion);
        rays_.push_back(ray);
    }
    void meet(const Intersection&, const Color&) override {}
    void shadow(const Shape*, const Color&) override { ++rays_[open_.back()].shadows; }
    void light(const DirectLight&, const Color& sum) override {
        RayTreeNode& ray = rays_[open_.back()];
        ray.light += ray.weight * asDouble(sum);
    }
    void terminate(RayKind, TerminationReason) override {}
    void leave(const Color&) override { open_.pop_back(); }

    // Appends the point's tree to `trees`, and is ready for another point.
    void moveTo(RayTrees& trees) {
        trees.rays.insert(trees.rays.end(), rays_.begin(), rays_.end());
        trees.ends.push_back(trees.rays.size());
        rays_.clear();
    }

  private:
    std::vector<RayTreeNode> rays_;
    std::vector<std::size_t> open_;  // the ray in progress, after those that led to it
    int max_recursion_ = 0;
};

}  // namespace

RenderCounts SceneRenderer::shareOut(const RenderOptions& options, std::size_t jobs,
                                     ProgressListener* progress, std::uint64_t mostRays,
                                     const std::function<Work(const RenderContext&)>& workOf) const {
    std::mutex mutex;
    std::list<RenderCounts> counts;  // of each thread
    const auto all = [&] {
        RenderCounts sum;
        for (const RenderCounts& some : counts) sum += some;
        return sum;
    };
    std::size_t done = 0;
    std::vector<Color> brightest;
    if (options.cutoff > 0) brightest = scene_->brightestColors(options.max_recursion);
    const auto newCounts = [&] {
        const std::lock_guard lock(mutex);
        return &counts.emplace_back();
    };
    const auto workOnJobs = [&](JobQueue& queue) {
        const RenderContext context{&options, brightest.empty() ? nullptr : brightest.data(), newCounts(),
                                    nullptr, mostRays};
        const Work work = workOf(context);
        for (std::uint32_t job; queue.next(job);) {
            work(job);
            if (!progress) continue;
            const std::lock_guard lock(mutex);
            progress->progress(static_cast<double>(++done) / static_cast<double>(jobs));
        }
    };
    try {
        onTracingThreads(static_cast<std::uint32_t>(jobs), options.threads, options.max_recursion,
                         workOnJobs);
    } catch (const TooManyRays&) {  // with the counts of one thread
        throw TooManyRays(all());
    }
    if (all().onwards() > mostRays) throw TooManyRays(all());
    return all();
}

std::shared_ptr<const std::vector<glm::dvec2>> SceneRenderer::smallPartsOf(
    const RenderOptions& options) const {
    const ImageSize& size = options.size;
    const PixelRectangle place = withRing(options.crop, size);
    const std::lock_guard lock(mutex_);
    const bool isKnown = size.width == sizeOfParts_.width && size.height == sizeOfParts_.height &&
                         placeOfParts_.x0 <= place.x0 && placeOfParts_.y0 <= place.y0 &&
                         placeOfParts_.x1 >= place.x1 && placeOfParts_.y1 >= place.y1;
    if (isKnown) return smallParts_;
    constexpr double pixelsOfBand = 1 << 20;
    const std::vector<PixelRectangle> bands = bandsOf(place, pixelsOfBand);
    std::vector<std::vector<glm::dvec2>> found(bands.size());
    parallelFor(static_cast<std::uint32_t>(bands.size()), options.threads,
                [&](std::uint32_t i) { found[i] = smallParts(*scene_, size, bands[i]); });
    std::size_t count = 0;
    for (const auto& some : found) count += some.size();
    requireMemory({}, "what is small in the picture", static_cast<double>(sizeof(glm::dvec2) * count));
    auto all = std::make_shared<std::vector<glm::dvec2>>();
    all->reserve(count);
    for (const auto& some : found) all->insert(all->end(), some.begin(), some.end());
    smallParts_ = std::move(all);
    sizeOfParts_ = size;
    placeOfParts_ = place;
    return smallParts_;
}

void SceneRenderer::prepare(const RenderOptions& options) const { smallPartsOf(options); }

RenderCounts SceneRenderer::render(const RenderOptions& options, PixelSink& sink, ProgressListener* progress,
                                   const FirstSamples* first) const {
    const std::vector<PixelRectangle> tiles = tilesOf(options.crop, options.part);
    auto small = std::make_shared<const std::vector<glm::dvec2>>();
    if (options.adaptive > 0 && options.samples > 1 && !first) small = smallPartsOf(options);
    return shareOut(options, tiles.size(), progress, unlimited, [&](const RenderContext& context) {
        return [&, render = tileRenderer(*scene_, context, first, *small, sink)](std::uint32_t job) {
            render(tiles[job]);
        };
    });
}

RenderCounts SceneRenderer::renderFirst(RenderOptions options, FirstSamples& first) const {
    options.crop = {0, 0, options.size.width, options.size.height};
    options.samples = 1;
    options.adaptive = 0;
    const std::vector<PixelRectangle> tiles = tilesOf(options.crop);
    const auto pixels = static_cast<std::size_t>(options.crop.area());
    first.colors.resize(pixels);
    first.leftOut.resize(pixels);
    RenderCounts counts =
        shareOut(options, tiles.size(), nullptr, unlimited, [&](const RenderContext& context) {
            return [&](std::uint32_t job) { raytracer::renderFirst(*scene_, tiles[job], context, first); };
        });
    first.cutoffBound = counts.cutoffBound;
    const auto points = smallPartsOf(options);
    requireMemory({}, "samples of what is small",
                  static_cast<double>((sizeof(ExtraSample) + sizeof(glm::dvec3)) * points->size()));
    std::vector<glm::dvec3> colors(points->size());
    counts += tracePoints(options, *points, colors, unlimited);
    first.extra.clear();
    first.extra.reserve(colors.size());
    for (std::size_t i = 0; i < colors.size(); ++i) first.extra.push_back({(*points)[i], colors[i]});
    return counts;
}

RenderCounts SceneRenderer::renderPoints(const RenderOptions& options, std::span<const glm::dvec2> points,
                                         std::span<glm::dvec3> colors) const {
    return tracePoints(options, points, colors, mostRaysOf(points));
}

RenderCounts SceneRenderer::tracePoints(const RenderOptions& options, std::span<const glm::dvec2> points,
                                        std::span<glm::dvec3> colors, std::uint64_t mostRays,
                                        Observer* observer) const {
    const auto workOf = [&](const RenderContext& context) {
        const auto take = [&](std::size_t i, const glm::dvec3& color, const SampleTrace& trace) {
            colors[i] = color;
            double& bound = context.counts->cutoffBound;
            bound = std::max(bound, trace.truncationBound);
        };
        return [&, take](std::uint32_t job) {
            traceBatch(
                *scene_, context, points, job, [&](std::size_t) { return observer; }, take);
        };
    };
    return shareOut(options, batchCount(points.size()), nullptr, mostRays, workOf);
}

RenderCounts SceneRenderer::rayTrees(const RenderOptions& options, std::span<const glm::dvec2> points,
                                     RayTrees& trees) const {
    RenderOptions shaded = options;
    shaded.pass = Pass::Color;
    std::vector<RayTrees> parts(batchCount(points.size()));
    const auto workOf = [&](const RenderContext& context) {
        return [&](std::uint32_t job) {
            RayTreeObserver watching[PointPacket::most];
            const auto watcher = [&](std::size_t i) { return &watching[i % PointPacket::most]; };
            traceBatch(*scene_, context, points, job, watcher,
                       [&](std::size_t i, const glm::dvec3&, const SampleTrace&) {
                           watcher(i)->moveTo(parts[job]);
                       });
        };
    };
    const RenderCounts counts = shareOut(shaded, parts.size(), nullptr, mostRaysOf(points), workOf);
    trees = {};
    for (const RayTrees& part : parts) {
        const std::size_t before = trees.rays.size();
        trees.rays.insert(trees.rays.end(), part.rays.begin(), part.rays.end());
        for (const std::size_t end : part.ends) trees.ends.push_back(before + end);
    }
    for (const Color& brightest : scene_->brightestColors(options.max_recursion))
        trees.brightest.push_back(asDouble(brightest));
    return counts;
}

std::unique_ptr<Renderer> makeCoreRenderer(const SceneDescription& description, const BuildOptions& options) {
    return std::make_unique<SceneRenderer>(buildScene(description, options));
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
