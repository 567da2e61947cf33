#include "tile.h"

#include <algorithm>
#include <vector>

#include "point_stream.h"
#include "raytracer/pictures/color_sink.h"
#include "raytracer/tracer/contrast.h"
#include "raytracer/tracer/pixel_estimate.h"
#include "raytracer/tracer/sample_sequence.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// Calls function(x, y) for each pixel, packet by packet.
template <class Function>
void forEachInPacketOrder(const PixelRectangle& pixels, Function function) {
    for (int top = pixels.y0; top < pixels.y1; top += packetHeight)
        for (int left = pixels.x0; left < pixels.x1; left += packetWidth) {
            const int right = std::min(left + packetWidth, pixels.x1);
            for (int y = top; y < std::min(top + packetHeight, pixels.y1); ++y)
                for (int x = left; x < right; ++x) function(x, y);
        }
}

// Renders one tile after another, in the same memory: a large allocation for each would go back to the
// system.
class Tile {
  public:
    Tile(const Scene& scene, const RenderContext& context, const FirstSamples* first,
         std::span<const glm::dvec2> small, PixelSink& sink)
        : scene_(scene),
          context_(context),
          options_(*context.options),
          first_(first),
          small_(small),
          sink_(sink),
          sequence_(options_.sequence) {}

    void render(const PixelRectangle& tile) {
        tile_ = tile;
        sampled_ = options_.adaptive > 0 ? withRing(tile, options_.size) : tile;
        pixels_.assign(static_cast<std::size_t>(sampled_.area()), {});
        activate(sampled_);
        if (first_) takeOver();
        else sample(0, 1);
        activate(tile_);
        if (options_.adaptive > 0) findContrasts();
        for (int taken = 1; leaveThoseDone(taken); taken = sampleMore(taken)) {
        }
        write();
    }

  private:
    struct Pixel {
        PixelEstimate estimate;
        double truncationBound = 0;  // the sum of its samples'
    };

    void activate(const PixelRectangle& places) {
        active_.clear();
        forEachInPacketOrder(places, [&](int x, int y) { active_.push_back({x, y}); });
    }

    void takeOver() {
        for (const auto& [x, y] : active_) {
            Pixel& pixel = pixels_[sampled_.indexOf(x, y)];
            pixel.estimate.add(first_->colors[static_cast<std::size_t>(y) * options_.size.width + x]);
            pixel.truncationBound = first_->cutoffBound;
        }
    }

    void findContrasts() {
        colors_.clear();
        for (const Pixel& pixel : pixels_) colors_.push_back(pixel.estimate.color());
        contrasts_ = contrasts(sampled_, colors_, extraHere());
    }

    // The extra samples in sampled_.
    std::vector<ExtraSample> extraHere() const {
        std::vector<ExtraSample> here;
        const auto takeFrom = [&](const auto& list) {
            const auto order = [](const auto& sample) {
                const PixelPlace place = ExtraSample{sample}.pixel();
                return std::pair(place.y, place.x);
            };
            for (int y = sampled_.y0; y < sampled_.y1; ++y) {
                const auto end = std::ranges::lower_bound(list, std::pair(y, sampled_.x1), {}, order);
                for (auto i = std::ranges::lower_bound(list, std::pair(y, sampled_.x0), {}, order); i != end;
                     ++i)
                    here.push_back(ExtraSample{*i});
            }
        };
        if (first_) {
            takeFrom(first_->extra);
            return here;
        }
        takeFrom(small_);
        PointStream stream(scene_, context_, [&](std::size_t i, const glm::dvec3& color, const SampleTrace&) {
            here[i].color = color;
        });
        for (std::size_t i = 0; i < here.size(); ++i) stream.add(i, here[i].point);
        stream.finish();
        return here;
    }

    // Drops the pixels that are done. Returns whether any others take more samples.
    bool leaveThoseDone(int taken) {
        if (options_.adaptive > 0)
            std::erase_if(active_, [&, least = leastContrast(options_.size)](const PixelPlace& place) {
                const std::size_t i = sampled_.indexOf(place.x, place.y);
                return pixels_[i].estimate.error(contrasts_[i], least) <= options_.adaptive;
            });
        if (taken < options_.samples) return !active_.empty();
        if (options_.adaptive > 0) context_.counts->limited += active_.size();
        return false;
    }

    int sampleMore(int taken) {
        const int next = options_.adaptive > 0 ? nextLevel(taken, options_.samples) : options_.samples;
        sample(taken, next);
        return next;
    }

    // A pixel's samples share packets, since they are nearer to each other than pixels are.
    void sample(int begin, int end) {
        std::vector<glm::dvec2> offsets;
        for (int i = begin; i < end; ++i) offsets.push_back(sequence_[static_cast<std::uint32_t>(i)]);
        PointStream stream(scene_, context_,
                           [&](std::size_t owner, const glm::dvec3& color, const SampleTrace& trace) {
                               Pixel& pixel = pixels_[owner];
                               pixel.estimate.add(color);
                               pixel.truncationBound += trace.truncationBound;
                           });
        for (const auto& [x, y] : active_)
            for (const glm::dvec2& offset : offsets)
                stream.add(sampled_.indexOf(x, y), glm::dvec2(x, y) + offset);
        stream.finish();
    }

    void write() {
        colors_.clear();
        double& bound = context_.counts->cutoffBound;
        for (int y = tile_.y0; y < tile_.y1; ++y)
            for (int x = tile_.x0; x < tile_.x1; ++x) {
                const Pixel& pixel = pixels_[sampled_.indexOf(x, y)];
                colors_.push_back(pixel.estimate.color());
                bound = std::max(bound, pixel.truncationBound / pixel.estimate.samples());
            }
        copyTo(sink_, tile_, colors_);
    }

    const Scene& scene_;
    const RenderContext& context_;
    const RenderOptions& options_;
    const FirstSamples* first_;
    std::span<const glm::dvec2> small_;  // points of the picture
    PixelSink& sink_;
    SampleSequence sequence_;
    PixelRectangle tile_{}, sampled_{};
    std::vector<Pixel> pixels_;       // of sampled_
    std::vector<glm::dvec3> colors_;  // of sampled_, then of tile_
    std::vector<double> contrasts_;   // of sampled_, where adaptive
    std::vector<PixelPlace> active_;  // the pixels that take more samples
};

// Traces the first sample of each pixel of a tile in `place`, and calls take(i, color, trace) for it: the
// pixel is the i-th of the place, row by row.
template <class Take>
void traceFirst(const Scene& scene, const PixelRectangle& tile, const PixelRectangle& place,
                const RenderContext& context, Take take) {
    double& bound = context.counts->cutoffBound;
    const glm::dvec2 centre = SampleSequence(context.options->sequence)[0];
    PointStream stream(scene, context, [&](std::size_t i, const glm::dvec3& color, const SampleTrace& trace) {
        take(i, color, trace);
        bound = std::max(bound, trace.truncationBound);
    });
    forEachInPacketOrder(tile,
                         [&](int x, int y) { stream.add(place.indexOf(x, y), glm::dvec2(x, y) + centre); });
    stream.finish();
}

// The same as Tile with one sample a pixel, without its estimates: a tenth less CPU time for
// scenes/spheres_cylinder.json.
void renderCentres(const Scene& scene, const PixelRectangle& tile, const RenderContext& context,
                   PixelSink& sink) {
    std::vector<glm::dvec3> colors(tile.size().area());
    traceFirst(scene, tile, tile, context,
               [&](std::size_t i, const glm::dvec3& color, const SampleTrace&) { colors[i] = color; });
    copyTo(sink, tile, colors);
}

}  // namespace

std::function<void(const PixelRectangle&)> tileRenderer(const Scene& scene, const RenderContext& context,
                                                        const FirstSamples* first,
                                                        std::span<const glm::dvec2> small, PixelSink& sink) {
    const RenderOptions& options = *context.options;
    if (options.samples == 1 && options.adaptive == 0 && !first)
        return [&](const PixelRectangle& tile) { renderCentres(scene, tile, context, sink); };
    return [tile = Tile(scene, context, first, small, sink)](const PixelRectangle& place) mutable {
        tile.render(place);
    };
}

void renderFirst(const Scene& scene, const PixelRectangle& tile, const RenderContext& context,
                 FirstSamples& first) {
    traceFirst(scene, tile, context.options->crop, context,
               [&](std::size_t i, const glm::dvec3& color, const SampleTrace& trace) {
                   first.colors[i] = color;
                   first.leftOut[i] = static_cast<float>(trace.leftOut);
               });
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
