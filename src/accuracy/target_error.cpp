// Each pixel stops by its own estimate (pixel_estimate.h), so that the picture's error is a slowly changing
// part of one number, --adaptive. Some pixels, more where the contrast is large, are taken to their end with
// it, and the truth at them is estimated twice from other samples, which gives their squared error without
// bias. The depth is chosen before that, from ray trees of points all over the picture.
#include "raytracer/accuracy/target_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "depth.h"
#include "picture_points.h"
#include "raytracer/pictures/color_sink.h"
#include "raytracer/tracer/contrast.h"
#include "raytracer/tracer/pixel_estimate.h"

namespace raytracer {

namespace {

// The first `adaptive` and the last, in targets. A picture's error is 0.1 to 1.3 of it; from a larger one on
// single pixels have errors that pilot samples may miss. The last is far below 1 / 1.3, for the margin.
constexpr double coarsest = 8, finest = 1 / 16.0;
constexpr double finer = 1 / 1.09;  // from one `adaptive` to the next: 4 % of the error are lost in the mean
constexpr double mostFirst = 1 << 22;           // pixels whose first samples and contrasts are kept: 170 MB
constexpr std::size_t mostRequested = 1 << 14;  // samples that are taken at once
// Rays of pilot samples, about, for each pixel of the picture: so many over the target's square. Random
// samples of 0 and 1 would reach it with 1 / (4 target^2); there are three times as many, of some 10 rays.
constexpr double raysOfRandom = 8;

// A pilot pixel: its own samples, and twice as many others.
struct PilotPixel {
    PixelPlace place;
    double contrast = 0;
    double draws = 0;          // how often it was drawn
    double weight = 0;         // of a draw's squared error in the picture's mean square
    std::uint32_t others = 0;  // the number of its first other sequence, so that no two pixels' errors agree
    PixelEstimate own{}, truth[2]{};
};

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
        // A smaller picture has more error: more of its pixels are edges.
        while (areaOf(options_.size) > mostFirst)
            options_.size = {std::max(1, options_.size.width / 2), std::max(1, options_.size.height / 2)};
        options_.crop = {0, 0, options_.size.width, options_.size.height};
    }

    // Throws TooManyRays where the rays of the pixels with the largest contrast are many more than those of
    // others: then with half the depth() there are fewer.
    TargetChoice choose(int mostDepth) {
        depth_ = chooseDepth(renderer_, options_, target_, area_, choice_.counts, mostDepth);
        options_.max_recursion = depth_.max_recursion;
        options_.cutoff = depth_.cutoff;
        choice_.depthError = std::sqrt(depth_.squaredError);
        choice_.isLimited = depth_.isLimited;
        takeFirst();
        sortPixels();
        drawPixels(fewestPilots);
        choice_.setting = {mostSamples, 0, depth_.max_recursion, depth_.cutoff, options_.bilinear};
        chooseAdaptive();
        choice_.reached = choice_.reached && !choice_.isLimited;
        if (choice_.setting.adaptive >= 0.25) {  // no pixel would take a second sample
            choice_.setting.samples = 1;
            choice_.setting.adaptive = 0;
        }
        if (areaOf(options_.size) < area_) choice_.first = {};
        return std::move(choice_);
    }

    int depth() const { return depth_.max_recursion; }
    const RenderCounts& counts() const { return choice_.counts; }

  private:
    void takeFirst() {
        options_.samples = 1;
        options_.adaptive = 0;
        ColorSink sink(options_.crop);
        const RenderCounts counts = renderer_.render(options_, sink);
        choice_.counts += counts;
        choice_.first = {std::move(sink).colors(), counts.cutoffBound};
    }

    PixelPlace placeOf(std::uint32_t i) const {
        const auto width = static_cast<std::uint32_t>(options_.size.width);
        return {static_cast<int>(i % width), static_cast<int>(i / width)};
    }

    // How likely a pixel is drawn: by the error of one sample, as far as a target allows it for long.
    double weightOf(double contrast) const { return std::min(contrast / 4, errorMargin * target_); }

    void sortPixels() {
        const std::vector<double> contrast =
            contrasts(choice_.first.colors, options_.size, leastContrast(options_.size));
        pixels_.reserve(contrast.size());
        for (std::uint32_t i = 0; i < contrast.size(); ++i) {
            pixels_.emplace_back(static_cast<float>(contrast[i]), i);
            totalWeight_ += weightOf(static_cast<double>(pixels_.back().first));
        }
        std::ranges::sort(pixels_);
    }

    // At equal steps of weight through all pixels in the order of their contrast: of each contrast as many as
    // it deserves (systematic sampling: Cochran, Sampling Techniques, 8).
    void drawPixels(double count) {
        const double step = totalWeight_ / count;
        double sum = 0, next = SampleSequence()[draws_++].x * step;
        for (const auto& [contrast, i] : pixels_) {
            const double weight = weightOf(static_cast<double>(contrast));
            sum += weight;
            if (sum <= next) continue;
            const double draws = std::ceil((sum - next) / step);
            next += draws * step;
            const double part = totalWeight_ / (weight * static_cast<double>(pixels_.size()));
            const auto others = options_.sequence + 1 + 2 * static_cast<std::uint32_t>(pilots_.size());
            pilots_.push_back({placeOf(i), static_cast<double>(contrast), draws, part, others});
            pilots_.back().own.add(choice_.first.colors[i]);
        }
        count_ += count;
    }

    struct SquaredError {
        double mean = 0;
        double margin = 0;
    };

    // From the coarsest on, until the target is reached with the margin.
    void chooseAdaptive() {
        double& adaptive = choice_.setting.adaptive;
        adaptive = rounded(coarsest * target_);
        before_ = choice_.counts.all();
        for (bool isLast = false;;) {
            takeSamples(adaptive);
            const SquaredError error = squaredErrorOfPicture();
            const double left = target_ * target_ - depth_.squaredError - error.mean;
            // The search ends where the mean is small by chance: a standard error makes up for that.
            choice_.sampleError = std::sqrt(error.mean + error.margin / standardErrors);
            choice_.reached = left >= (isLast ? error.margin / standardErrors : error.margin);
            if (isSpent()) endHere();
            if (choice_.reached || isLast || isSpent()) return;
            if (left >= 0 && mayDrawMore(error)) {
                drawPixels(count_);
                continue;
            }
            adaptive = rounded(adaptive * finer);
            isLast = adaptive < finest * target_;
        }
    }

    bool isSpent() const {
        const double most = std::min<double>(mostSamples, raysOfRandom / (target_ * target_));
        return static_cast<double>(choice_.counts.all() - before_) > most * area_;
    }

    // No pixel of the picture takes more samples than a pilot pixel has taken.
    void endHere() {
        choice_.setting.samples = 1;
        for (const PilotPixel& pixel : pilots_)
            choice_.setting.samples = std::max(choice_.setting.samples, pixel.own.samples());
    }

    // Whether a sample of twice the pilot pixels, which shrink the margin by a factor of sqrt(2), gains more
    // than a further sample of the picture, whose squared error falls as samples^-3/2.
    bool mayDrawMore(const SquaredError& error) const {
        double taken = 0, perPixel = 0;  // after the first
        for (const PilotPixel& pixel : pilots_) {
            const int own = pixel.own.samples();
            perPixel += pixel.draws / count_ * pixel.weight * (own - 1);
            taken += own + 2 * pixel.truth[0].samples();
        }
        const double samples = perPixel * static_cast<double>(pixels_.size());
        return error.margin * (1 - std::sqrt(0.5)) * samples > 1.5 * error.mean * taken;
    }

    // Takes the pilot pixels to their end, or as far as the rays go: each at least a first step.
    void takeSamples(double adaptive) {
        bool isEnd = false;
        do {
            isEnd = true;
            for (PilotPixel& pixel : pilots_) {
                int samples = pixel.own.samples();
                if (pixel.own.error(pixel.contrast) > adaptive) samples = nextLevel(samples, mostSamples);
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

    // What was requested.
    void take() {
        std::vector<glm::dvec3> colors(points_.size());
        choice_.counts += renderer_.renderPoints(options_, points_, colors);
        for (std::size_t i = 0; i < colors.size(); ++i) takers_[i]->add(colors[i]);
        points_.clear();
        takers_.clear();
        if (listener_) listener_(choice_.counts.primary);
    }

    // Of the picture: its mean square, without bias, and how much more it may be: so many standard errors,
    // and more where few draws decide, whose distribution is skew (Johnson, Modified t tests and confidence
    // intervals for asymmetrical populations, JASA 73, 1978).
    SquaredError squaredErrorOfPicture() const {
        double first = 0, second = 0, third = 0;  // moments of a draw
        for (const PilotPixel& pixel : pilots_) {
            const double value = pixel.weight * squaredError(pixel.own.color(), pixel.truth[0].color(),
                                                             pixel.truth[1].color());
            const double part = pixel.draws / count_;
            first += part * value;
            second += part * value * value;
            third += part * value * value * value;
        }
        const double variance = std::max(0.0, second - first * first);
        const double thirdCentral = std::max(0.0, third - first * (3 * variance + first * first));
        const double skewness = variance > 0 ? thirdCentral / variance / std::sqrt(variance) : 0;
        const double deviations =
            standardErrors + skewness / std::sqrt(count_) / 6 * (1 + 2 * standardErrors * standardErrors);
        return {std::max(0.0, first),  // below zero by chance
                deviations * std::hypot(std::sqrt(variance / count_), depth_.standardError)};
    }

    const Renderer& renderer_;
    RenderOptions options_;
    double target_;
    const SearchListener& listener_;
    double area_;
    DepthChoice depth_;
    TargetChoice choice_;
    std::vector<std::pair<float, std::uint32_t>> pixels_;  // all: contrast and index, in this order
    double totalWeight_ = 0;                               // of all pixels
    std::vector<PilotPixel> pilots_;
    double count_ = 0;                // draws
    std::uint32_t draws_ = 0;         // calls of drawPixels
    std::uint64_t before_ = 0;        // rays, the pilot samples
    std::vector<glm::dvec2> points_;  // requested samples
    std::vector<PixelEstimate*> takers_;
};

}  // namespace

TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target,
                           const SearchListener& listener) {
    RenderCounts before;  // of searches that went too deep
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
