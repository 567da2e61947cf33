#include "render.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "pixel_colors.h"
#include "ray_tree_observer.h"
#include "raytracer/util/parallel.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

constexpr int tileEdge = 32;  // pixels: small enough to share out evenly, large enough to keep rays coherent

int tileCount(int edge) { return (edge + tileEdge - 1) / tileEdge; }

PixelRectangle tileOf(const PixelRectangle& crop, int index) {
    const int columns = tileCount(crop.width());
    const int x0 = crop.x0 + index % columns * tileEdge, y0 = crop.y0 + index / columns * tileEdge;
    return {x0, y0, std::min(x0 + tileEdge, crop.x1), std::min(y0 + tileEdge, crop.y1)};
}

void renderTile(const Scene& scene, const PixelRectangle& tile, const RenderContext& context,
                PixelSink& sink) {
    glm::dvec3 rows[PointPacket::height][tileEdge];
    for (int top = tile.y0; top < tile.y1; top += PointPacket::height) {
        const int height = std::min(PointPacket::height, tile.y1 - top);
        for (int left = tile.x0; left < tile.x1; left += PointPacket::width) {
            const int right = std::min(left + PointPacket::width, tile.x1);
            PixelPlace places[PointPacket::most];
            Color colors[PointPacket::most];
            std::size_t count = 0;
            for (int y = 0; y < height; ++y)
                for (int x = left; x < right; ++x) places[count++] = {x, top + y};
            pixelColors(scene, {places, count}, colors, context);
            const Color* color = colors;
            for (int y = 0; y < height; ++y)
                for (int x = left; x < right; ++x) rows[y][x - tile.x0] = glm::dvec3(*color++);
        }
        for (int y = 0; y < height; ++y)
            sink.write(tile.x0, top + y, {rows[y], static_cast<std::size_t>(tile.width())});
    }
}

// Does work(job, context) for every job, on options.threads threads.
template <class Work>
RenderCounts shareOut(const Scene& scene, const RenderOptions& options, std::size_t jobs,
                      ProgressListener* progress, Work work) {
    std::mutex mutex;
    RenderCounts all;
    std::size_t done = 0;
    std::vector<Color> brightest;
    if (options.cutoff > 0) brightest = scene.brightestColors(options.max_recursion);
    onThreads(static_cast<std::uint32_t>(jobs), options.threads, [&](JobQueue& queue) {
        RenderCounts counts;
        const RenderContext context{&options, brightest.empty() ? nullptr : brightest.data(), &counts};
        for (std::uint32_t job; queue.next(job);) {
            work(job, context);
            if (!progress) continue;
            const std::lock_guard lock(mutex);
            progress->progress(static_cast<double>(++done) / static_cast<double>(jobs));
        }
        const std::lock_guard lock(mutex);
        all += counts;
    });
    return all;
}

// Pixels that one thread takes at once: few enough to share out evenly.
std::size_t batchSize(const RenderOptions& options) { return options.samples == 1 ? 64 : PointPacket::most; }

std::size_t batchCount(std::span<const PixelPlace> pixels, std::size_t batch) {
    return (pixels.size() + batch - 1) / batch;
}

// Calls function(pixels, first) for up to PointPacket::most of a batch's pixels at a time, from pixels[first]
// on. They may lie far apart; but what meets the same surface is shaded together.
template <class Function>
void forEachPacket(std::span<const PixelPlace> pixels, std::size_t batch, std::uint32_t job,
                   Function function) {
    const std::size_t begin = std::size_t{job} * batch, end = std::min(begin + batch, pixels.size());
    for (std::size_t i = begin; i < end; i += PointPacket::most)
        function(pixels.subspan(i, std::min<std::size_t>(PointPacket::most, end - i)), i);
}

}  // namespace

RenderCounts renderPicture(const Scene& scene, const RenderOptions& options, PixelSink& sink,
                           ProgressListener* progress) {
    const PixelRectangle& crop = options.crop;
    const auto tiles = static_cast<std::size_t>(tileCount(crop.width()) * tileCount(crop.height()));
    return shareOut(scene, options, tiles, progress, [&](std::uint32_t job, const RenderContext& context) {
        renderTile(scene, tileOf(crop, static_cast<int>(job)), context, sink);
    });
}

RenderCounts renderPixels(const Scene& scene, const RenderOptions& options,
                          std::span<const PixelPlace> pixels, std::span<glm::dvec3> colors) {
    const std::size_t batch = batchSize(options);
    const auto work = [&](std::uint32_t job, const RenderContext& context) {
        forEachPacket(pixels, batch, job, [&](std::span<const PixelPlace> some, std::size_t first) {
            Color together[PointPacket::most];
            pixelColors(scene, some, together, context);
            for (std::size_t k = 0; k < some.size(); ++k) colors[first + k] = together[k];
        });
    };
    return shareOut(scene, options, batchCount(pixels, batch), nullptr, work);
}

RenderCounts traceRayTrees(const Scene& scene, const RenderOptions& options,
                           std::span<const PixelPlace> pixels, RayTrees& trees) {
    RenderOptions once = options;
    once.samples = 1;
    once.pass = Pass::Color;
    const std::size_t batch = batchSize(once);
    std::vector<RayTrees> parts(batchCount(pixels, batch));
    const auto work = [&](std::uint32_t job, const RenderContext& context) {
        RayTreeObserver watching[PointPacket::most];
        Observer* observers[PointPacket::most];
        for (int i = 0; i < PointPacket::most; ++i) observers[i] = &watching[i];
        forEachPacket(pixels, batch, job, [&](std::span<const PixelPlace> some, std::size_t) {
            Color colors[PointPacket::most];
            pixelColors(scene, some, colors, context, observers);
            for (std::size_t i = 0; i < some.size(); ++i) watching[i].moveTo(parts[job]);
        });
    };
    const RenderCounts counts = shareOut(scene, once, parts.size(), nullptr, work);
    trees = {};
    for (const RayTrees& part : parts) {
        const std::size_t before = trees.rays.size();
        trees.rays.insert(trees.rays.end(), part.rays.begin(), part.rays.end());
        for (const std::size_t end : part.ends) trees.ends.push_back(before + end);
    }
    for (const Color& color : scene.brightestColors(options.max_recursion))
        trees.brightest.emplace_back(color);
    return counts;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
