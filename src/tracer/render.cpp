// A picture by tiles, shared out among threads.
#include <algorithm>
#include <mutex>
#include <vector>

#include "ray_follower.h"
#include "raytracer/tracer/packet_tracer.h"
#include "raytracer/tracer/sample_grid.h"
#include "raytracer/util/parallel.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

constexpr int tileEdge = 32;  // pixels: small enough to share out evenly, large enough to keep rays coherent

int tileCount(int edge) { return (edge + tileEdge - 1) / tileEdge; }

PixelRectangle tileOf(const PixelRectangle& crop, int index) {
    const int columns = tileCount(crop.width());
    const int x0 = crop.x0 + index % columns * tileEdge, y0 = crop.y0 + index / columns * tileEdge;
    return {x0, y0, std::min(x0 + tileEdge, crop.x1), std::min(y0 + tileEdge, crop.y1)};
}

// Pixels of several samples, which share packets whosever they are.
class PixelGroup {
  public:
    PixelGroup(const Scene& scene, std::span<const PixelPlace> pixels, RenderContext& context)
        : scene_(scene),
          pixels_(pixels),
          context_(context),
          grid_{context.options->samples},
          tolerance_(static_cast<Real>(context.options->adaptive)) {}

    void render(std::span<Color> colors) {
        for (int pixel = 0; pixel < count(); ++pixel)
            grid_.forEachCorner([&](int i, int j) { add(pixel, i, j); });
        take();
        for (int pixel = 0; pixel < count(); ++pixel)
            if (!isFlat(sums_[pixel])) grid_.forEachOther([&](int i, int j) { add(pixel, i, j); });
        take();
        for (int pixel = 0; pixel < count(); ++pixel) {
            const Sum& sum = sums_[pixel];
            colors[static_cast<std::size_t>(pixel)] = sum.color / static_cast<Real>(sum.taken);
            context_.counts.cutoffBound = std::max(context_.counts.cutoffBound, sum.dropped / sum.taken);
        }
    }

  private:
    struct Sum {
        Color color{0};
        int taken = 0;
        double dropped = 0;
        ColorSpread<Real> spread;  // of the samples; only for `adaptive`
    };

    int count() const { return static_cast<int>(pixels_.size()); }

    void add(int pixel, int i, int j) {
        const PixelPlace& place = pixels_[static_cast<std::size_t>(pixel)];
        owners_[points_.count] = pixel;
        points_.add(static_cast<Real>(place.x) + grid_.offset<Real>(i),
                    static_cast<Real>(place.y) + grid_.offset<Real>(j));
        if (points_.count == PointPacket::most) take();
    }

    void take() {
        if (points_.count == 0) return;
        scene_.pointColors(points_, context_);
        for (int i = 0; i < points_.count; ++i) {
            Sum& sum = sums_[owners_[i]];
            const Color color = points_.colorOf(i);
            if (tolerance_ > 0) sum.spread.add(color);
            sum.color += color;
            sum.dropped += points_.dropped[i];
            ++sum.taken;
        }
        points_.count = 0;
    }

    bool isFlat(const Sum& sum) const { return tolerance_ > 0 && sum.spread.largest() <= tolerance_; }

    const Scene& scene_;
    std::span<const PixelPlace> pixels_;
    RenderContext& context_;
    SampleGrid grid_;
    Real tolerance_;
    PointPacket points_;
    int owners_[PointPacket::most];
    Sum sums_[PointPacket::most];
};

void renderTile(const Scene& scene, const PixelRectangle& tile, RenderContext& context, PixelSink& sink) {
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
            scene.pixelColors({places, count}, colors, context);
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
    RenderCounts counts;
    std::size_t done = 0;
    std::vector<Color> brightest;
    if (options.cutoff > 0) brightest = scene.brightestColors(options.max_recursion);
    onThreads(static_cast<std::uint32_t>(jobs), options.threads, [&](JobQueue& queue) {
        RenderContext context{&options, brightest.empty() ? nullptr : brightest.data()};
        for (std::uint32_t job; queue.next(job);) {
            work(job, context);
            if (!progress) continue;
            const std::lock_guard lock(mutex);
            progress->progress(static_cast<double>(++done) / static_cast<double>(jobs));
        }
        const std::lock_guard lock(mutex);
        counts += context.counts;
    });
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
    if (packets_ && context.options->pass == Pass::Color && points.count >= PointPacket::least)
        return packets_->trace(*this, points, context);
    for (int i = 0; i < points.count; ++i) {
        context.dropped = 0;
        if (context.followers) context.observer = &context.followers[i];
        const Color color = pointColor(points.x[i], points.y[i], context);
        for (int channel = 0; channel < 3; ++channel) points.color[channel][i] = color[channel];
        points.dropped[i] = context.dropped;
    }
}

void Scene::pixelColors(std::span<const PixelPlace> pixels, std::span<Color> colors,
                        RenderContext& context) const {
    if (context.options->samples > 1) return PixelGroup(*this, pixels, context).render(colors);
    PointPacket points;
    for (const PixelPlace& pixel : pixels)
        points.add(static_cast<Real>(pixel.x) + Real(0.5), static_cast<Real>(pixel.y) + Real(0.5));
    pointColors(points, context);
    for (int i = 0; i < points.count; ++i) {
        colors[static_cast<std::size_t>(i)] = points.colorOf(i);
        context.counts.cutoffBound = std::max(context.counts.cutoffBound, points.dropped[i]);
    }
}

RenderCounts Scene::render(const RenderOptions& options, PixelSink& sink, ProgressListener* progress) const {
    const PixelRectangle& crop = options.crop;
    const auto work = [&](std::uint32_t job, RenderContext& context) {
        renderTile(*this, tileOf(crop, static_cast<int>(job)), context, sink);
    };
    const auto tiles = static_cast<std::size_t>(tileCount(crop.width()) * tileCount(crop.height()));
    return shareOut(*this, options, tiles, progress, work);
}

RenderCounts Scene::renderPixels(const RenderOptions& options, std::span<const PixelPlace> pixels,
                                 std::span<glm::dvec3> colors) const {
    // Pixels that one thread takes at once: few enough to share out evenly.
    const std::size_t batch = options.samples == 1 ? 64 : PointPacket::most;
    const auto work = [&](std::uint32_t job, RenderContext& context) {
        const std::size_t begin = std::size_t{job} * batch, end = std::min(begin + batch, pixels.size());
        // They may lie far apart; but what meets the same surface is shaded together.
        for (std::size_t i = begin; i < end; i += PointPacket::most) {
            Color together[PointPacket::most];
            const std::size_t count = std::min<std::size_t>(PointPacket::most, end - i);
            pixelColors(pixels.subspan(i, count), together, context);
            for (std::size_t k = 0; k < count; ++k) colors[i + k] = together[k];
        }
    };
    return shareOut(*this, options, (pixels.size() + batch - 1) / batch, nullptr, work);
}

RenderCounts Scene::rayTrees(const RenderOptions& options, std::span<const PixelPlace> pixels,
                             RayTrees& followed) const {
    RenderOptions once = options;
    once.samples = 1;
    once.pass = Pass::Color;
    const std::size_t batch = 64, jobs = (pixels.size() + batch - 1) / batch;
    std::vector<RayTrees> parts(jobs);
    const auto work = [&](std::uint32_t job, RenderContext& context) {
        const std::size_t begin = std::size_t{job} * batch;
        std::span<const PixelPlace> some = pixels.subspan(begin, std::min(batch, pixels.size() - begin));
        RayFollower followers[PointPacket::most];
        context.followers = followers;
        for (Color colors[PointPacket::most]; !some.empty();) {
            const std::size_t count = std::min<std::size_t>(PointPacket::most, some.size());
            pixelColors(some.first(count), colors, context);
            for (std::size_t i = 0; i < count; ++i) followers[i].moveTo(parts[std::size_t{job}]);
            some = some.subspan(count);
        }
        context.followers = nullptr, context.observer = nullptr;
    };
    const RenderCounts counts = shareOut(*this, once, jobs, nullptr, work);
    followed = {};
    for (const RayTrees& part : parts) {
        const std::size_t before = followed.rays.size();
        followed.rays.insert(followed.rays.end(), part.rays.begin(), part.rays.end());
        for (const std::size_t end : part.ends) followed.ends.push_back(before + end);
    }
    for (const Color& color : brightestColors(options.max_recursion)) followed.brightest.emplace_back(color);
    return counts;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
