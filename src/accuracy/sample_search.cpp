#include "sample_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace raytracer {

namespace {

// Along an axis; also between the grid's, since the next one of those may be much dearer than what is enough.
constexpr int sampleSteps[] = {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, SampleSearch::sampleLimit};
constexpr double usualFall = 1.2,
                 fastestFall = 1.5;  // the error of n x n samples: like n^-1 (textures) to n^-1.5 (edges)

// The first look's pixels; later ones may have as many as all before.
constexpr double scatteredPart = 1.0 / 256, leastScattered = 1000;  // of the picture's pixels: looked at
constexpr double judgedPixels = 200, fewSamplesPixels = 400;  // these, divided by the samples, are judged too
constexpr double flat =
    0.01;  // squared difference between corners where adaptive is likely to take no more samples

constexpr double judgedPart = 1.0 / 60, leastJudged = 1000;  // of the pixels of a whole picture
constexpr double leastPixels = 20 * leastJudged;  // of such a picture: less is dearer to judge than to render
constexpr double mostPixels = 1 << 22;            // 40 MB
constexpr double minorDepth =
    0.1;  // of the target: what a depth may leave, where the samples alone leave nearly all of it
constexpr double possibleMargin = 2,
                 tooFarMargin = 1.6;  // standard errors: missing it costs four times as much

Setting cornersOf(Setting setting) {
    setting.samples = 64;
    setting.adaptive = 1;  // no others are taken
    return setting;
}

}  // namespace

SampleSearch::SampleSearch(const Renderer& renderer, const RenderOptions& options, double target,
                           DepthSearch& depths, PixelSink& sink)
    : renderer_(renderer),
      options_(options),
      target_(target),
      depths_(depths),
      sink_(sink),
      judged_(sampledAt(depths.fine(), 1)),
      pilot_(renderer, options) {}

double SampleSearch::firstPixels() const {
    return std::max(leastScattered, scatteredPart * options_.crop.area());
}

Setting SampleSearch::sampledAt(const DepthChoice& depth, int samples, double adaptive) const {
    return {samples, adaptive, depth.max_recursion, depth.cutoff, options_.bilinear};
}

double SampleSearch::raysSpent() const {
    double spent = pilot_.raysSpent();
    for (const std::unique_ptr<Pilot>& look : looks_) spent += look->raysSpent();
    if (picture_) spent += rayCount(picture_->counts) + picture_->judgingRays;
    return spent;
}

std::size_t SampleSearch::pixelCount() const {
    return pilot_.pixelCount() + (picture_ ? picture_->judgedPixels : 0);
}

int SampleSearch::stepBelow(int samples) { return std::ranges::lower_bound(sampleSteps, samples)[-1]; }

int SampleSearch::stepFrom(double samples) {
    for (const int step : sampleSteps)
        if (step >= samples) return step;
    return sampleLimit;
}

void SampleSearch::look(double times) {
    const auto count = static_cast<std::size_t>(std::min(times * firstPixels(), options_.crop.area()));
    const auto seed = static_cast<std::uint32_t>(2 + looks_.size());
    looks_.push_back(
        std::make_unique<Pilot>(renderer_, options_, scatteredPixels(options_.crop, count, seed)));
    Pilot& look = *looks_.back();
    if (samples_ == 0) samples_ = guessSamples(look);
    pilot_.add(look.pixels(), activity(look),
               static_cast<std::size_t>(times * (judgedPixels + fewSamplesPixels / samples_)));
}

// How many samples it may take, from how far a pixel's centre is from the mean of its corners, as if all five
// were independent. Rather too few, which shows, than too many, which are dear.
int SampleSearch::guessSamples(Pilot& look) const {
    const double one = look.error(sampled(1), cornersOf(sampled(1))).rmse / std::sqrt(1.25);
    return stepFrom(std::floor(std::pow(one / target_, 1 / fastestFall)));
}

// How much each pixel has going on: how far apart is what its centre, its corners, 2 x 2 samples and a coarse
// depth see. Where the corners tell nothing but the samples do, adaptive will miss it all; the rest falls
// with the samples.
std::vector<double> SampleSearch::activity(Pilot& look) const {
    const auto &centre = look.colors(sampled(1)), &corners = look.colors(cornersOf(sampled(1)));
    std::vector<double> activity(centre.size(), 0);
    const auto addDifference = [&](const std::vector<glm::dvec3>& colors) {
        for (std::size_t i = 0; i < activity.size(); ++i) activity[i] += squaredError(centre[i], colors[i]);
    };
    addDifference(corners);
    if (samples_ > 2) {
        const auto& some = look.colors(sampled(2));
        for (std::size_t i = 0; i < activity.size(); ++i)
            if (activity[i] < flat) activity[i] += samples_ * samples_ * squaredError(corners[i], some[i]);
        addDifference(some);
    }
    const DepthChoice& coarse = depths_.coarsest();
    if (coarse.error > DepthSearch::enough * target_) addDifference(look.colors(sampledAt(coarse, 1)));
    for (double& each : activity) each = std::sqrt(each);
    return activity;
}

void SampleSearch::findSamples() {
    for (;;) {
        pilot_.sampleTruth(sampled(1), samples_ > 2 ? samples_ + 1 : 2);
        if (samples_ == sampleLimit || isEnough(sampled(samples_))) break;
        const double excess = error(sampled(samples_)).rmse / target_;
        samples_ = stepFrom(std::max(samples_ + 1.0, samples_ * std::pow(excess, 1 / usualFall)));
    }
    while (samples_ > 1 && isEnough(sampled(stepBelow(samples_)))) samples_ = stepBelow(samples_);
}

ErrorEstimate SampleSearch::error(const Setting& setting) {
    if (picture_ && setting.samples == 1) return picture_->error;
    const Setting judged = sampled(setting.samples, setting.adaptive);
    return setting == judged ? pilot_.error(setting) : pilot_.errorOfShallow(setting, judged);
}

bool SampleSearch::judgePicture() {
    const double area = options_.crop.area();
    if (picture_ || samples_ > 2 || area < leastPixels || area > mostPixels) return false;
    const ErrorEstimate one = error(sampled(1));
    const auto with = [&](const DepthChoice& depth, double errors) {
        return std::hypot(one.rmse + errors * one.standardError, depth.error);
    };
    if (with(depths_.fine(), -possibleMargin) > target_ || with(depths_.fine(), sureMargin) <= target_)
        return false;
    const DepthChoice& depth = depths_.deeper(minorDepth);
    const auto judge = [&](const ErrorEstimate& samples) {
        const ErrorEstimate error{std::hypot(samples.rmse, depth.error), samples.standardError};
        if (isWithin(error, sureMargin, target_)) return Judgement::Enough;
        return error.rmse - tooFarMargin * error.standardError > target_ ? Judgement::TooFar
                                                                         : Judgement::Unclear;
    };
    picture_ = renderJudged(renderer_, options_, sampledAt(depth, 1), sink_,
                            std::max(leastJudged, judgedPart * area), judge);
    return true;
}

}  // namespace raytracer
