// Tiles and threads: the only file that has any.
#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "raytracer/scene.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

constexpr int tileEdge = 32;  // pixels: small enough to share out evenly, large enough to keep rays coherent

// Shares out the tiles of the crop, and counts what is done.
class TileQueue {
  public:
    TileQueue(const PixelRectangle& crop, ProgressListener* progress)
        : crop_(crop), columns_((crop.width() + tileEdge - 1) / tileEdge),
          count_(columns_ * ((crop.height() + tileEdge - 1) / tileEdge)), progress_(progress) {}

    int count() const { return count_; }

    bool next(PixelRectangle& tile) {
        const int index = next_.fetch_add(1);
        if (index >= count_) return false;
        tile.x0 = crop_.x0 + index % columns_ * tileEdge;
        tile.y0 = crop_.y0 + index / columns_ * tileEdge;
        tile.x1 = std::min(tile.x0 + tileEdge, crop_.x1);
        tile.y1 = std::min(tile.y0 + tileEdge, crop_.y1);
        return true;
    }

    void done() {
        if (!progress_) return;
        const std::lock_guard lock(mutex_);
        progress_->progress(static_cast<double>(++done_) / count_);
    }

  private:
    PixelRectangle crop_;
    int columns_, count_;
    std::atomic<int> next_{0};
    int done_ = 0;
    ProgressListener* progress_;
    std::mutex mutex_;
};

void renderTile(const Scene& scene, const PixelRectangle& tile, RenderContext& context, PixelSink& sink) {
    glm::dvec3 row[tileEdge];
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x)
            row[x - tile.x0] = scene.pixelColor(x, y, context);
        sink.write(tile.x0, y, {row, static_cast<std::size_t>(tile.width())});
    }
}

// Whether no channel of the four colours, as a picture shows them, differs by more than `tolerance`.
bool agree(const Color (&color)[4], Real tolerance) {
    Color low(1), high(0);
    for (const Color& c : color) {
        const Color shown = glm::clamp(c, Real(0), Real(1));
        low = glm::min(low, shown);
        high = glm::max(high, shown);
    }
    return tolerance > 0 && maxComponent(high - low) <= tolerance;
}

int threadCount(int asked, int tiles) {
    const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return std::min(asked > 0 ? asked : processors, tiles);
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

Color Scene::pixelColor(int x, int y, RenderContext& context) const {
    const int n = context.options->samples;
    const auto sample = [&](int i, int j) {
        const Real cell = 1 / static_cast<Real>(n);
        return pointColor(static_cast<Real>(x) + (static_cast<Real>(i) + Real(0.5)) * cell,
                          static_cast<Real>(y) + (static_cast<Real>(j) + Real(0.5)) * cell, context);
    };
    context.dropped = 0;
    Color color(0);
    int taken = 1;
    if (n == 1) {
        color = sample(0, 0);
    } else {
        // The corners first: where they agree to within `adaptive` they stand for the whole grid.
        const Color corner[4] = {sample(0, 0), sample(n - 1, 0), sample(0, n - 1), sample(n - 1, n - 1)};
        color = corner[0] + corner[1] + corner[2] + corner[3];
        taken = 4;
        if (n > 2 && !agree(corner, static_cast<Real>(context.options->adaptive))) {
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i)
                    if ((i != 0 && i != n - 1) || (j != 0 && j != n - 1)) color += sample(i, j);
            taken = n * n;
        }
        color /= static_cast<Real>(taken);
    }
    context.counts.cutoffBound = std::max(context.counts.cutoffBound, context.dropped / taken);
    return color;
}

RenderCounts Scene::render(const RenderOptions& options, PixelSink& sink, ProgressListener* progress) const {
    TileQueue tiles(options.crop, progress);
    std::mutex mutex;
    RenderCounts counts;
    const std::vector<Color> brightest = options.cutoff > 0 ? brightestColors(options.max_recursion) : std::vector<Color>();
    const auto work = [&] {
        RenderContext context{&options, brightest.empty() ? nullptr : brightest.data(), nullptr, {}};
        for (PixelRectangle tile; tiles.next(tile); tiles.done()) renderTile(*this, tile, context, sink);
        const std::lock_guard lock(mutex);
        counts += context.counts;
    };
    std::vector<std::jthread> helpers;
    for (int i = threadCount(options.threads, tiles.count()); i > 1; --i) helpers.emplace_back(work);
    work();
    helpers.clear();  // joins
    return counts;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
