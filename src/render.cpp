// Tiles and threads: the only file that has any.
#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "raytracer/packet_tracer.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

constexpr int tileEdge = 32;  // pixels: small enough to share out evenly, large enough to keep rays coherent

// Hands out the jobs 0, 1, ... and counts what is done.
class JobQueue {
  public:
    JobQueue(int count, ProgressListener* progress) : count_(count), progress_(progress) {}

    bool next(int& job) {
        job = next_.fetch_add(1);
        return job < count_;
    }

    void done() {
        if (!progress_) return;
        const std::lock_guard lock(mutex_);
        progress_->progress(static_cast<double>(++done_) / count_);
    }

  private:
    int count_;
    std::atomic<int> next_{0};
    int done_ = 0;
    ProgressListener* progress_;
    std::mutex mutex_;
};

int tileCount(int edge) { return (edge + tileEdge - 1) / tileEdge; }

PixelRectangle tileOf(const PixelRectangle& crop, int index) {
    const int columns = tileCount(crop.width());
    const int x0 = crop.x0 + index % columns * tileEdge, y0 = crop.y0 + index / columns * tileEdge;
    return {x0, y0, std::min(x0 + tileEdge, crop.x1), std::min(y0 + tileEdge, crop.y1)};
}

// The pixels of a tile by packets of their centres.
void renderCenters(const Scene& scene, const PixelRectangle& tile, RenderContext& context, PixelSink& sink) {
    glm::dvec3 rows[PointPacket::height][tileEdge];
    for (int top = tile.y0; top < tile.y1; top += PointPacket::height) {
        const int height = std::min(PointPacket::height, tile.y1 - top);
        for (int left = tile.x0; left < tile.x1; left += PointPacket::width) {
            const int width = std::min(PointPacket::width, tile.x1 - left);
            PointPacket points;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    points.add(static_cast<Real>(left + x) + Real(0.5), static_cast<Real>(top + y) + Real(0.5));
            scene.pointColors(points, context);
            for (int i = 0; i < points.count; ++i) {
                rows[i / width][left - tile.x0 + i % width] = glm::dvec3(points.colorOf(i));
                context.counts.cutoffBound = std::max(context.counts.cutoffBound, points.dropped[i]);
            }
        }
        for (int y = 0; y < height; ++y) sink.write(tile.x0, top + y, {rows[y], static_cast<std::size_t>(tile.width())});
    }
}

void renderTile(const Scene& scene, const PixelRectangle& tile, RenderContext& context, PixelSink& sink) {
    if (context.options->samples == 1) return renderCenters(scene, tile, context, sink);
    glm::dvec3 row[tileEdge];
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x)
            row[x - tile.x0] = scene.pixelColor(x, y, context);
        sink.write(tile.x0, y, {row, static_cast<std::size_t>(tile.width())});
    }
}

// Whether no channel of the colours, as a picture shows them, differs by more than `tolerance`.
bool agree(const PointPacket& points, Real tolerance) {
    Color low(1), high(0);
    for (int i = 0; i < points.count; ++i) {
        const Color shown = glm::clamp(points.colorOf(i), Real(0), Real(1));
        low = glm::min(low, shown);
        high = glm::max(high, shown);
    }
    return tolerance > 0 && maxComponent(high - low) <= tolerance;
}

int threadCount(int asked, int jobs) {
    const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return std::min(asked > 0 ? asked : processors, jobs);
}

// Does work(job, context) for every job, on options.threads threads.
template <class Work>
RenderCounts shareOut(const Scene& scene, const RenderOptions& options, int jobs, ProgressListener* progress, Work work) {
    JobQueue queue(jobs, progress);
    std::mutex mutex;
    RenderCounts counts;
    std::vector<Color> brightest;
    if (options.cutoff > 0) brightest = scene.brightestColors(options.max_recursion);
    const auto drain = [&] {
        RenderContext context{&options, brightest.empty() ? nullptr : brightest.data(), nullptr, {}};
        for (int job; queue.next(job); queue.done()) work(job, context);
        const std::lock_guard lock(mutex);
        counts += context.counts;
    };
    std::vector<std::jthread> helpers;
    for (int i = threadCount(options.threads, jobs); i > 1; --i) helpers.emplace_back(drain);
    drain();
    helpers.clear();  // joins
    return counts;
}

}  // namespace

Color Scene::pointColor(Real x, Real y, RenderContext& context) const {
    const RenderOptions& options = *context.options;
    const Ray ray = camera.getRay(camera.getPixelUV(x, y, options.size.width, options.size.height));
    ++context.counts.primary;
    if (options.pass == Pass::Color) return rayColor(ray, {Color(1), options.max_recursion}, context);
    const Intersection hit = closestIntersection(ray, context);
    if (options.pass == Pass::Raycast) return hit.valid ? hit.material->color_diffuse : Color(0);
    return hit.valid ? (hit.normal + Real(1)) / Real(2) : Color(Real(54) / 255);
}

void Scene::pointColors(PointPacket& points, RenderContext& context) const {
    const TracePacket tracePacket = packetTracer();
    if (usesPackets_ && tracePacket && context.options->pass == Pass::Color && points.count >= PointPacket::least)
        return tracePacket(*this, points, context);
    for (int i = 0; i < points.count; ++i) {
        context.dropped = 0;
        const Color color = pointColor(points.x[i], points.y[i], context);
        for (int channel = 0; channel < 3; ++channel) points.color[channel][i] = color[channel];
        points.dropped[i] = context.dropped;
    }
}

Color Scene::pixelColor(int x, int y, RenderContext& context) const {
    const int n = context.options->samples;
    Color color(0);
    double dropped = 0;
    PointPacket points;
    const auto add = [&](int i, int j) {
        const Real cell = 1 / static_cast<Real>(n);
        points.add(static_cast<Real>(x) + (static_cast<Real>(i) + Real(0.5)) * cell,
                   static_cast<Real>(y) + (static_cast<Real>(j) + Real(0.5)) * cell);
    };
    const auto take = [&] {
        if (points.count == 0) return;
        pointColors(points, context);
        for (int i = 0; i < points.count; ++i) color += points.colorOf(i), dropped += points.dropped[i];
    };
    int taken = 1;
    if (n == 1) {
        add(0, 0);
        take();
    } else {
        // The corners first: where they agree to within `adaptive` they stand for the whole grid.
        add(0, 0), add(n - 1, 0), add(0, n - 1), add(n - 1, n - 1);
        take();
        taken = 4;
        if (n > 2 && !agree(points, static_cast<Real>(context.options->adaptive))) {
            points.count = 0;
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    if ((i == 0 || i == n - 1) && (j == 0 || j == n - 1)) continue;
                    add(i, j);
                    if (points.count == PointPacket::most) take(), points.count = 0;
                }
            take();
            taken = n * n;
        }
        color /= static_cast<Real>(taken);
    }
    context.counts.cutoffBound = std::max(context.counts.cutoffBound, dropped / taken);
    return color;
}

RenderCounts Scene::render(const RenderOptions& options, PixelSink& sink, ProgressListener* progress) const {
    const PixelRectangle& crop = options.crop;
    const auto work = [&](int job, RenderContext& context) { renderTile(*this, tileOf(crop, job), context, sink); };
    return shareOut(*this, options, tileCount(crop.width()) * tileCount(crop.height()), progress, work);
}

RenderCounts Scene::renderPixels(const RenderOptions& options, std::span<const PixelPlace> pixels,
                                 std::span<glm::dvec3> colors) const {
    constexpr std::size_t batch = 64;  // pixels: few enough to share out evenly
    const auto work = [&](int job, RenderContext& context) {
        const std::size_t begin = static_cast<std::size_t>(job) * batch, end = std::min(begin + batch, pixels.size());
        for (std::size_t i = begin; i < end; ++i) colors[i] = pixelColor(pixels[i].x, pixels[i].y, context);
    };
    return shareOut(*this, options, static_cast<int>((pixels.size() + batch - 1) / batch), nullptr, work);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
