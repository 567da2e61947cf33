// Each pixel stops by its own error estimate (pixel_estimate.h), so that the picture's error is a slowly
// changing fraction of one number, --adaptive. The search samples pilot pixels, more of them where the
// contrast is large, until they stop at that number. Two more estimates of each pilot pixel, from other
// samples, give its squared error: never too small on average. The depth is chosen before that (depth.h).
#include "raytracer/accuracy/target_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "depth.h"
#include "picture_points.h"
#include "pilots.h"
#include "raytracer/pictures/image.h"
#include "raytracer/tracer/contrast.h"
#include "raytracer/tracer/pixel_estimate.h"
#include "raytracer/util/memory.h"
#include "systematic_sampling.h"

namespace raytracer {

namespace {

// The first `adaptive`, as a multiple of the target. A picture's error is 0.1 to 1.3 times `adaptive`. With a
// coarser one, single pixels have errors that pilot samples may miss.
constexpr double coarsest = 8;
// Pilot pixels take at least this part of the picture's samples (of a halved picture's, mostFirst). Else
// something small that none of them meets would be missed in large pictures, where it costs least to look.
constexpr double pilotShare = 0.1;
constexpr double finer = 1 / 1.09;     // from one `adaptive` to the next: on average 4 % below the target
constexpr double mostFirst = 1 << 22;  // pixels whose first samples and contrasts are kept: 185 MB
constexpr std::size_t mostRequested = 1 << 14;  // samples that are taken at once
// Pilot samples may cast about raysOfRandom / target^2 rays for each pixel of the picture. Random samples of
// 0 and 1 would reach the target with 1 / (4 target^2) samples. A pilot pixel takes three times as many (its
// own and two truths), at some 10 rays each.
constexpr double raysOfRandom = 8;

double areaOf(const ImageSize& size) { return static_cast<double>(size.width) * size.height; }

class Search {
  public:
    Search(const Renderer& renderer, const RenderOptions& options, double target,
           const SearchListener& listener)
        : renderer_(renderer),
          options_(options),
          target_(target),
          listener_(listener),
          area_(areaOf(options.size)) {
        // Halving the picture overestimates the error, which is safe: more of a smaller picture's pixels are
        // edges.
        while (areaOf(options_.size) > mostFirst)
            options_.size = {std::max(1, options_.size.width / 2), std::max(1, options_.size.height / 2)};
        options_.crop = {0, 0, options_.size.width, options_.size.height};
        least_ = leastContrast(options_.size);
    }

    // Throws TooManyRays where the pixels with the largest contrast cast many more rays than others. The
    // caller then tries again with half of depth().
    TargetChoice choose(int mostDepth) {
        DepthSearch depths(renderer_, options_, target_, area_, choice_.counts, mostDepth);
        depth_ = depths.choice();
        takeFirst();
        const DepthChoice confirmed = depths.confirmed(choice_.first.leftOut);
        if (!std::exchange(depth_, confirmed).isSameAs(confirmed)) takeFirst();
        choice_.depthError = std::sqrt(depth_.squaredError);
        choice_.isLimited = depth_.isLimited;
        sortPixels();
        drawPixels(fewestPilots);
        choice_.setting = {mostSamples, 0, depth_.max_recursion, depth_.cutoff, options_.bilinear};
        chooseAdaptive();
        choice_.reached = choice_.reached && !choice_.isLimited;
        if (needsOneSample()) choice_.setting.samples = 1;
        if (choice_.setting.samples == 1) choice_.setting.adaptive = 0;
        if (isHalved()) choice_.first = {};
        return std::move(choice_);
    }

    int depth() const { return depth_.max_recursion; }
    const RenderCounts& counts() const { return choice_.counts; }

  private:
    void takeFirst() {
        // Of each pixel: its first colour, what is left out, the contrast, and its place in their order.
        constexpr std::size_t bytesOfPixel =
            sizeof(glm::dvec3) + sizeof(float) + sizeof(double) + sizeof(pixels_[0]);
        const ImageSize& size = options_.size;
        if (choice_.first.colors.empty())
            requireMemory({}, "the first samples of " + pixelsInWords(size.width, size.height),
                          static_cast<double>(bytesOfPixel) * size.width * size.height);
        options_.max_recursion = depth_.max_recursion;
        options_.cutoff = depth_.cutoff;
        choice_.counts += renderer_.renderFirst(options_, choice_.first);
    }

    PixelPlace placeOf(std::uint32_t i) const {
        const auto width = static_cast<std::uint32_t>(options_.size.width);
        return {static_cast<int>(i % width), static_cast<int>(i / width)};
    }

    // A pixel's weight in the drawing: what its first sample may miss, clamped to a few targets, since a
    // pixel that may miss more takes more samples anyway.
    double weightOf(double contrast) const {
        return std::min(contrast * PixelEstimate::errorOfOneSample, errorMargin * target_);
    }

    void sortPixels() {
        const std::vector<double> contrast =
            contrasts(options_.crop, choice_.first.colors, choice_.first.extra);
        pixels_.reserve(contrast.size());
        for (std::uint32_t i = 0; i < contrast.size(); ++i) {
            pixels_.emplace_back(static_cast<float>(std::max(contrast[i], least_)), i);
            totalWeight_ += weightOf(static_cast<double>(pixels_.back().first));
        }
        std::ranges::sort(pixels_);
    }

    // Draws pixels in the order of their contrast.
    void drawPixels(double count) {
        requireMemory({}, "pilot pixels", sizeof(PilotPixel) * count);
        const double step = totalWeight_ / count;
        const auto contrastOf = [&](std::size_t i) { return static_cast<double>(pixels_[i].first); };
        drawSystematically(
            pixels_.size(), step, SampleSequence()[draws_++].x * step,
            [&](std::size_t i) { return weightOf(contrastOf(i)); },
            [&](std::size_t i, double weight, double draws) {
                const std::uint32_t pixel = pixels_[i].second;
                const double part = totalWeight_ / (weight * static_cast<double>(pixels_.size()));
                const auto others = options_.sequence + 1 + 2 * static_cast<std::uint32_t>(pilots_.size());
                pilots_.push_back({placeOf(pixel), contrastOf(i), draws, part, others});
                pilots_.back().own.add(choice_.first.colors[pixel]);
            });
        count_ += count;
    }

    bool isHalved() const { return areaOf(options_.size) < area_; }

    // Whether no pixel of the picture takes a second sample. No error of one sample is above 1.
    bool needsOneSample() const {
        const auto contrast = static_cast<double>(pixels_.back().first);  // the largest
        const double most = isHalved() ? 1 : std::min(1.0, contrast * PixelEstimate::errorOfOneSample);
        return most <= choice_.setting.adaptive;
    }

    // Lowers `adaptive` from the coarsest until the target is reached with the margin.
    void chooseAdaptive() {
        double& adaptive = choice_.setting.adaptive;
        adaptive = rounded(coarsest * target_);
        before_ = choice_.counts.all();
        for (;;) {
            takeSamples(adaptive);
            const SquaredError error = squaredErrorOf(pilots_, count_);
            const double left = depth_.leftOf(target_) - error.mean;
            // The search tends to stop where the mean is too small by chance: one standard error makes up for
            // that.
            choice_.sampleError = std::min(1.0, std::sqrt(error.mean + error.margin / standardErrors));
            const bool isEnd = isSpent();
            const Samples samples = samplesOf(pilots_, count_, static_cast<double>(pixels_.size()));
            const bool areFew = !isEnd && samples.ofPilots < pilotShare * samples.ofPicture;
            choice_.reached =
                target_ >= 1 || (!areFew && left >= (isEnd ? error.margin / standardErrors : error.margin));
            if (isEnd) endHere();
            if (choice_.reached || isEnd) return;
            if (left >= 0 && (areFew || isBetterToDraw(error, samples))) drawPixels(count_);
            else adaptive = rounded(adaptive * finer);
        }
    }

    // Whether no more samples come: the rays are spent, or every pilot pixel has the most samples.
    bool isSpent() const {
        const double most = std::min<double>(mostSamples, raysOfRandom / (target_ * target_));
        return static_cast<double>(choice_.counts.all() - before_) > most * area_ ||
               std::ranges::all_of(pilots_,
                                   [](const PilotPixel& p) { return p.own.samples() == mostSamples; });
    }

    // Out of rays: limits the picture's samples to the most that a pilot pixel has taken.
    void endHere() {
        choice_.setting.samples = 1;
        for (const PilotPixel& pixel : pilots_)
            choice_.setting.samples = std::max(choice_.setting.samples, pixel.own.samples());
    }

    // Samples each pilot pixel until it stops by its own estimate, or until the rays are spent. Each takes at
    // least one step.
    void takeSamples(double adaptive) {
        bool isEnd = false;
        do {
            isEnd = true;
            for (PilotPixel& pixel : pilots_) {
                int samples = pixel.own.samples();
                if (pixel.own.error(pixel.contrast, least_) > adaptive)
                    samples = nextLevel(samples, mostSamples);
                isEnd = isEnd && pixel.own.samples() == samples;
                request(pixel.place, options_.sequence, pixel.own, samples);
                for (const std::uint32_t i : {0, 1})
                    request(pixel.place, pixel.others + i, pixel.truth[i],
                            std::max(samples, nextLevel(1, mostSamples)));
            }
            take();
        } while (!isEnd && !isSpent());
    }

    void request(const PixelPlace& place, std::uint32_t number, PixelEstimate& estimate, int samples) {
        const SampleSequence sequence(number);
        for (int i = estimate.samples(); i < samples; ++i) {
            points_.push_back(glm::dvec2(place.x, place.y) + sequence[static_cast<std::uint32_t>(i)]);
            takers_.push_back(&estimate);
            if (points_.size() == mostRequested) take();
        }
    }

    // Takes the requested samples.
    void take() {
        std::vector<glm::dvec3> colors(points_.size());
        choice_.counts += renderer_.renderPoints(options_, points_, colors);
        for (std::size_t i = 0; i < colors.size(); ++i) takers_[i]->add(colors[i]);
        points_.clear();
        takers_.clear();
        if (listener_) listener_(choice_.counts.primary);
    }

    const Renderer& renderer_;
    RenderOptions options_;
    double target_;
    const SearchListener& listener_;
    double area_;
    DepthChoice depth_;
    TargetChoice choice_;
    double least_;                                         // leastContrast
    std::vector<std::pair<float, std::uint32_t>> pixels_;  // contrast and index of each, sorted
    double totalWeight_ = 0;                               // of all pixels
    std::vector<PilotPixel> pilots_;
    double count_ = 0;                // draws
    std::uint32_t draws_ = 0;         // calls of drawPixels
    std::uint64_t before_ = 0;        // rays cast before the pilot samples
    std::vector<glm::dvec2> points_;  // requested samples
    std::vector<PixelEstimate*> takers_;
};

}  // namespace

TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target,
                           const SearchListener& listener) {
    RenderCounts before;  // rays of the searches that went too deep
    for (int mostDepth = mostRecursion;;) {
        Search search(renderer, options, target, listener);
        try {
            TargetChoice choice = search.choose(mostDepth);
            choice.counts += before;
            return choice;
        } catch (const TooManyRays& tooMany) {
            before += search.counts();
            before += tooMany.cast();
            mostDepth = search.depth() / 2;
        }
    }
}

}  // namespace raytracer
