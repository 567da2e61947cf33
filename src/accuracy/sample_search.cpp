#include "sample_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace raytracer {

namespace {

// Along an axis. Finer than the grid's, whose next step may cost much more than what is enough.
constexpr int sampleSteps[] = {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, SampleSearch::sampleLimit};
// The error of n x n samples falls like n^-1 (textures) to n^-1.5 (edges).
constexpr double usualFall = 1.2, fastestFall = 1.5;

// Pixels of the first call of addPixels.
constexpr double scatteredPart = 1.0 / 256, leastScattered = 1000;  // of the picture's pixels: first phase
constexpr double secondPhase = 200, secondPhaseOfOne = 400;         // second phase: a + b / samples
// Squared difference of the corners below which `adaptive` is likely to take no more samples.
constexpr double flat = 0.01;

constexpr double estimatedPart = 1.0 / 60, leastEstimated = 1000;  // of the pixels of a whole picture
// A smaller picture costs more to estimate than to render; a larger one takes more than 40 MB.
constexpr double leastPixels = 20 * leastEstimated, mostPixels = 1 << 22;
// Of the target: the truncation error to allow if the sampling error alone is nearly the target.
constexpr double minorDepth = 0.1;
// In standard errors. Wrongly rejecting a picture costs four times its rays.
constexpr double possibleMargin = 2, rejectMargin = 1.6;

Setting cornersOf(Setting setting) {
    setting.samples = 64;
    setting.adaptive = 1;  // takes no other samples
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
      deep_(sampledAt(depths.fine(), 1)),
      pilot_(renderer, options) {}

double SampleSearch::firstPixels() const {
    return std::max(leastScattered, scatteredPart * options_.crop.area());
}

Setting SampleSearch::sampledAt(const DepthChoice& depth, int samples, double adaptive) const {
    return {samples, adaptive, depth.max_recursion, depth.cutoff, options_.bilinear};
}

double SampleSearch::raysSpent() const {
    double spent = pilot_.raysSpent();
    for (const std::unique_ptr<Pilot>& pilot : firstPhases_) spent += pilot->raysSpent();
    if (picture_) spent += rayCount(picture_->counts) + picture_->estimationRays;
    return spent;
}

std::size_t SampleSearch::pixelCount() const {
    return pilot_.pixelCount() + (picture_ ? picture_->estimatedPixels : 0);
}

int SampleSearch::stepBelow(int samples) { return std::ranges::lower_bound(sampleSteps, samples)[-1]; }

int SampleSearch::stepFrom(double samples) {
    for (const int step : sampleSteps)
        if (step >= samples) return step;
    return sampleLimit;
}

void SampleSearch::addPixels(double times) {
    const auto count = static_cast<std::size_t>(std::min(times * firstPixels(), options_.crop.area()));
    const auto seed = static_cast<std::uint32_t>(2 + firstPhases_.size());
    firstPhases_.push_back(
        std::make_unique<Pilot>(renderer_, options_, scatteredPixels(options_.crop, count, seed)));
    Pilot& pilot = *firstPhases_.back();
    if (samples_ == 0) samples_ = guessSamples(pilot);
    pilot_.add(pilot.pixels(), localContrast(pilot),
               static_cast<std::size_t>(times * (secondPhase + secondPhaseOfOne / samples_)));
}

// A first guess from the differences between a pixel's centre and the mean of its corners, as if all five
// were independent. Rather too few, which findSamples notices, than too many, which are expensive.
int SampleSearch::guessSamples(Pilot& pilot) const {
    const double one = pilot.error(sampled(1), cornersOf(sampled(1))).rmse / std::sqrt(1.25);
    return stepFrom(std::floor(std::pow(one / target_, 1 / fastestFall)));
}

// Of each pixel: the distance of its centre from its corners, from 2 x 2 samples and from a coarse depth.
// Where the corners are equal but the samples differ, `adaptive` misses the difference whatever the number of
// samples, so that it weighs more.
std::vector<double> SampleSearch::localContrast(Pilot& pilot) const {
    const auto &centre = pilot.colors(sampled(1)), &corners = pilot.colors(cornersOf(sampled(1)));
    std::vector<double> contrast(centre.size(), 0);
    const auto addDifference = [&](const std::vector<glm::dvec3>& colors) {
        for (std::size_t i = 0; i < contrast.size(); ++i) contrast[i] += squaredError(centre[i], colors[i]);
    };
    addDifference(corners);
    if (samples_ > 2) {
        const auto& some = pilot.colors(sampled(2));
        for (std::size_t i = 0; i < contrast.size(); ++i)
            if (contrast[i] < flat) contrast[i] += samples_ * samples_ * squaredError(corners[i], some[i]);
        addDifference(some);
    }
    const DepthChoice& coarse = depths_.coarsest();
    if (coarse.error > DepthSearch::enough * target_) addDifference(pilot.colors(sampledAt(coarse, 1)));
    for (double& each : contrast) each = std::sqrt(each);
    return contrast;
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
    const Setting deep = sampled(setting.samples, setting.adaptive);
    return setting == deep ? pilot_.error(setting) : pilot_.errorOfShallow(setting, deep);
}

bool SampleSearch::tryPicture() {
    const double area = options_.crop.area();
    if (picture_ || samples_ > 2 || area < leastPixels || area > mostPixels) return false;
    const ErrorEstimate one = error(sampled(1));
    const auto with = [&](const DepthChoice& depth, double errors) {
        return std::hypot(one.rmse + errors * one.standardError, depth.error);
    };
    if (with(depths_.fine(), -possibleMargin) > target_ || with(depths_.fine(), sureMargin) <= target_)
        return false;
    const DepthChoice& depth = depths_.deeper(minorDepth);
    const auto decide = [&](const ErrorEstimate& samples) {
        const ErrorEstimate error{std::hypot(samples.rmse, depth.error), samples.standardError};
        if (isWithin(error, sureMargin, target_)) return Decision::Accept;
        return error.rmse - rejectMargin * error.standardError > target_ ? Decision::Reject
                                                                         : Decision::Continue;
    };
    picture_ = renderEstimated(renderer_, options_, sampledAt(depth, 1), sink_,
                               std::max(leastEstimated, estimatedPart * area), decide);
    return true;
}

}  // namespace raytracer
