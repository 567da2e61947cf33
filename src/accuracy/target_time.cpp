// Small tiles all over the picture are rendered for ever smaller errors, each with a suitable depth, until
// the whole picture would take too long: with one sample per pixel, then with ever smaller --adaptive.
// Between the last two of these, the one that takes the given time is interpolated. Rendering the tiles
// again, with other samples, gives the error.
#include "raytracer/accuracy/target_time.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "depth.h"
#include "picture_points.h"
#include "raytracer/pictures/tiles.h"
#include "raytracer/tracer/pixel_estimate.h"
#include "raytracer/util/parallel.h"
#include "raytracer/util/stopwatch.h"

namespace raytracer {

namespace {

// The tiles are small so that a small part of the picture represents all of it. With fewer than eight of them
// the estimated time is unreliable.
constexpr int edge = 16;  // pixels
constexpr double timedPart = 1.0 / 50, fewestTiles = 8;
// The errors to try. The largest one there is makes the fastest picture. The next is about that of a picture
// without reflections. Each step takes at most about 1.6 times as long as the one before.
constexpr double largestError = 1, firstError = 0.3, nextError = 1 / 1.5;
constexpr double adaptiveFor = 2;    // `adaptive` over the error of its picture: mostly between 1 and 6
constexpr double estimation = 0.06;  // share of the time: three renders of the tiles give the error

double now() { return Seconds::now().wall; }

class TimeSearch {
  public:
    TimeSearch(const Renderer& renderer, const RenderOptions& options, double seconds)
        : renderer_(renderer), options_(options), end_(now() + (1 - estimation) * seconds) {
        const PixelRectangle& crop = options.crop;
        const auto count = static_cast<std::size_t>(
            std::ceil(std::max(fewestTiles, timedPart * crop.area() / (edge * edge))));
        for (const glm::dvec2& point :
             picturePoints({crop.width(), crop.height()}, count, PointsFor::tiles)) {
            const int x0 = crop.x0 + static_cast<int>(point.x) / edge * edge,
                      y0 = crop.y0 + static_cast<int>(point.y) / edge * edge;
            tiles_.push_back({x0, y0, std::min(x0 + edge, crop.x1), std::min(y0 + edge, crop.y1)});
        }
    }

    TimeChoice choose() {
        TimeChoice choice = step(largestError);
        // Not even mostSamples samples reach an error below 1 / mostSamples.
        for (double error = firstError; error * mostSamples > 1; error *= nextError) {
            const TimeChoice next = step(error);
            if (now() + next.seconds > end_) {
                interpolate(choice, next);
                break;
            }
            choice = next;
        }
        choice.sampleError = errorOf(choice.setting);
        choice.counts = spent_;
        return choice;
    }

  private:
    // The choice for this error, without its sampleError and counts.
    TimeChoice step(double error) {
        const DepthChoice depth = DepthSearch(renderer_, options_, error, 0, spent_).choice();
        const double adaptive = rounded(adaptiveFor * error);
        TimeChoice step{.setting = {1, 0, depth.max_recursion, depth.cutoff, options_.bilinear},
                        .depthError = std::sqrt(depth.squaredError)};
        if (adaptive < PixelEstimate::errorOfOneSample) {
            renderer_.prepare(options_);
            step.setting.samples = mostSamples;
            step.setting.adaptive = adaptive;
        }
        step.seconds = secondsOf(step.setting);
        return step;
    }

    // If both are adaptive, and the time left lies between their times, changes `before` to the setting that
    // takes that time: interpolates `adaptive`, log-log, and keeps the depth.
    void interpolate(TimeChoice& before, const TimeChoice& next) const {
        const double left = end_ - now();
        if (before.setting.adaptive == 0 || left <= before.seconds || next.seconds <= before.seconds) return;
        const double share = std::log(left / before.seconds) / std::log(next.seconds / before.seconds);
        before.setting.adaptive = rounded(before.setting.adaptive *
                                          std::pow(next.setting.adaptive / before.setting.adaptive, share));
        before.seconds = left;
    }

    // Calls work(tile) for each tile, on as many threads as the picture will have.
    template <class Work>
    void forEachTile(Work work) const {
        parallelFor(static_cast<std::uint32_t>(tiles_.size()), options_.threads,
                    [&](std::uint32_t i) { work(tiles_[i]); });
    }

    std::vector<glm::dvec3> colorsOf(const Setting& setting, const PixelRectangle& tile,
                                     std::uint32_t sequence) {
        RenderOptions options = withSetting(options_, setting);
        options.crop = tile;
        options.threads = 1;
        options.sequence = sequence;
        RenderedColors picture = rendered(renderer_, options);
        const std::lock_guard lock(mutex_);
        spent_ += picture.counts;
        return std::move(picture.colors);
    }

    // The samples of the rings around these tiles.
    double ringOf(std::span<const PixelRectangle> tiles) const {
        double ring = 0;
        for (const PixelRectangle& tile : tiles) ring += withRing(tile, options_.size).area() - tile.area();
        return ring;
    }

    // Estimates the seconds of the whole picture from those of the tiles. A tile of an adaptive picture also
    // samples a ring of neighbouring pixels. The picture's own tiles are larger, so their rings cost less per
    // pixel.
    double secondsOf(const Setting& setting) {
        const auto primary = spent_.primary;
        const double start = now();
        forEachTile([&](const PixelRectangle& tile) { colorsOf(setting, tile, 0); });
        const double seconds = now() - start, samples = static_cast<double>(spent_.primary - primary);
        double pixels = 0, ring = 0, ringOfPicture = 0;
        for (const PixelRectangle& tile : tiles_) pixels += tile.area();
        if (setting.adaptive > 0) {
            ring = ringOf(tiles_);
            ringOfPicture = ringOf(tilesOf(options_.crop));
        }
        const double samplesOfPicture = (samples - ring) * options_.crop.area() / pixels + ringOfPicture;
        return seconds * samplesOfPicture / samples;
    }

    double errorOf(const Setting& setting) {
        double sum = 0, pixels = 0;
        forEachTile([&](const PixelRectangle& tile) {
            std::vector<glm::dvec3> colors[3];
            for (const std::uint32_t sequence : {0U, 1U, 2U})
                colors[sequence] = colorsOf(setting, tile, sequence);
            const std::lock_guard lock(mutex_);
            for (std::size_t i = 0; i < colors[0].size(); ++i)
                sum += squaredError(colors[0][i], colors[1][i], colors[2][i]);
            pixels += tile.area();
        });
        return std::sqrt(std::max(0.0, sum) / pixels);
    }

    const Renderer& renderer_;
    const RenderOptions& options_;
    double end_;  // wall time at which the picture is to be done; the error's estimation comes after it
    std::vector<PixelRectangle> tiles_;
    std::mutex mutex_;
    RenderCounts spent_;
};

}  // namespace

TimeChoice chooseForTime(const Renderer& renderer, const RenderOptions& options, double seconds) {
    return TimeSearch(renderer, options, seconds).choose();
}

}  // namespace raytracer
