#include "raytracer/target_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "depth_search.h"
#include "raytracer/stratified_pilot.h"
#include "target_statistics.h"

namespace raytracer {

namespace {

// The error has two parts, which a pilot can measure apart since they hardly know of each other: of what rays bring that
// are not followed (depth), and of what lies between the samples. Their squares add up.
struct Candidate {
    Setting setting;
    double rays = 0;  // for each pixel, predicted up to a factor that is the same for all
    double sampleError = 0, depthError = 0;  // RMSE
    double sampleStandardError = 0;
    double error() const { return std::hypot(sampleError, depthError); }
    double standardError() const { return error() > 0 ? sampleStandardError * sampleError / error() : 0; }
};

// Along an axis; also between the grid's, since the next one of those may be much dearer than what is enough.
constexpr int sampleSteps[] = {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16};
constexpr int sampleLimit = std::end(sampleSteps)[-1];
constexpr double adaptiveSteps[] = {0.3, 0.1, 0.03, 0.01};
constexpr double usualFall = 1.2, fastestFall = 1.5;  // the error of n x n samples: like n^-1 (textures) to n^-1.5 (edges)

// The first look's pixels; later ones may have as many as all before.
constexpr double scatteredPart = 1.0 / 256, leastScattered = 1000;  // of the picture's pixels: looked at
constexpr double judgedPixels = 200, fewSamplesPixels = 250;        // these, divided by the samples, are judged too
constexpr double adaptivePart = 1.0 / 64;  // of them, where adaptive may help: what it misses is in few pixels
constexpr double leastLook = 0.25;  // of all pixels before: fewer would tell little more
constexpr double flat = 0.01;       // squared difference between corners where adaptive is likely to take no more samples

// What the best setting may cost, times this, is the most that all may cost, the pilot included.
constexpr double promise = 1.5;
// No look is begun that would exceed such a share of it, all pilots together:
constexpr double pilotShare = 0.25;
constexpr double checkShare = 0.2;  // where it would only make sure,
constexpr double lastShare = 0.4;   // where the promise is going to be broken.
constexpr double hope = 0.25;       // of what more pixels seem to save, this part
constexpr double smallStep = 1.05;  // a setting dearer by no more than this is as good

// Standard errors. With some odds to spare, since only a picture in ten may be above, and the cheapest that seems to do is
// likely to seem better than it is (Notes.txt).
constexpr double margin = 1.6, sureMargin = 2, likelyMargin = 0.6;
constexpr double likelyExcess = 1.2;  // of the target: the most that what is likely within it may have

class Search {
  public:
    Search(const Renderer& renderer, const RenderOptions& options, double target)
        : renderer_(renderer), options_(options), target_(target), depths_(renderer, options, target),
          judged_(sampledAt(depths_.fine(), 1)), pilot_(renderer, options) {}

    // In looks at ever more pixels, until the choice is clear or more would cost too much of what it can save.
    TargetChoice choose() {
        double all = look(1), pixels = all, before = depths_.raysSpent();
        const double more = adaptivePart * options_.crop.area() / firstPixels() - 1;
        if (samples_ > 2 && more > leastLook) all = pixels += look(more);
        for (;;) {
            TargetChoice choice = round();
            const double each = (spent() - before) / pixels;  // rays, for as many pixels as the first look has
            if (depths_.widen(leastRays(choice))) choice = round();
            if (depths_.halve(choice.setting)) choice = round();
            pixels = std::min(all, worthwhile(choice) / each);
            if (pixels < leastLook * all) return choice;
            before = spent();
            all += look(pixels);
        }
    }

  private:
    TargetChoice round() {
        findSamples();
        collect();
        return pick();
    }

    // What the best setting may cost.
    static double leastRays(const TargetChoice& choice) { return choice.cheaper ? choice.cheaperRays : choice.rays; }

    // Rays that may be spent on more pixels: they may lead to a cheaper setting (and to a part of what seems to be possible),
    // or show that this one will not do.
    double worthwhile(const TargetChoice& choice) const {
        const double best = leastRays(choice) * options_.crop.area(), chosen = choice.rays * options_.crop.area();
        const double share = chosen + spent() > promise * best ? lastShare : pilotShare;
        const double saving = std::min(share * best - spent(), hope * (chosen - best));
        if (upperLimit(choice.error, choice.standardError, sureMargin) <= target_) return saving;
        return std::max(saving, checkShare * best - spent());
    }

    double spent() const {
        double spent = depths_.raysSpent() + pilot_.raysSpent();
        for (const std::unique_ptr<Pilot>& look : looks_) spent += look->raysSpent();
        return spent;
    }

    const DepthChoice& judgedDepth() const { return depths_.of(judged_); }

    Setting sampled(int samples, double adaptive = 0) const { return sampledAt(judgedDepth(), samples, adaptive); }

    Setting sampledAt(const DepthChoice& depth, int samples, double adaptive = 0) const {
        return {samples, adaptive, depth.max_recursion, depth.cutoff, options_.bilinear};
    }

    double firstPixels() const { return std::max(leastScattered, scatteredPart * options_.crop.area()); }

    // More pixels, so many times the first look's.
    double look(double times) {
        const double count = times * firstPixels();
        const auto seed = static_cast<std::uint32_t>(2 + looks_.size());
        looks_.push_back(std::make_unique<Pilot>(
            renderer_, options_,
            scatteredPixels(options_.crop, static_cast<std::size_t>(std::min(count, options_.crop.area())), seed)));
        if (samples_ == 0) samples_ = guessSamples(*looks_.back());
        pilot_.add(looks_.back()->pixels(), activity(*looks_.back()),
                   static_cast<std::size_t>(times * (judgedPixels + fewSamplesPixels / samples_)));
        return times;
    }

    // How many samples it may take, from how far a pixel's centre is from the mean of its corners, as if all five were
    // independent. Rather too few, which shows, than too many, which are dear.
    int guessSamples(Pilot& look) const {
        const double one = look.error(sampled(1), corners()).rmse / std::sqrt(1.25);
        return stepFrom(std::floor(std::pow(one / target_, 1 / fastestFall)));
    }

    static int stepBelow(int samples) { return std::ranges::lower_bound(sampleSteps, samples)[-1]; }

    // The first step that is no less, or the last one.
    static int stepFrom(double samples) {
        for (const int step : sampleSteps)
            if (step >= samples) return step;
        return sampleLimit;
    }

    Setting corners() const { return sampled(64, 1); }  // adaptive 1: no others are taken

    // How much each pixel has going on: how far apart is what its centre, its corners, some samples and a coarse depth see.
    // Where the corners tell nothing but the samples do, adaptive will miss it all; the rest falls with the samples.
    std::vector<double> activity(Pilot& look) const {
        const auto &centre = look.take(sampled(1)).colors, &corner = look.take(corners()).colors;
        std::vector<double> activity(centre.size(), 0);
        const auto addDifference = [&](const std::vector<glm::dvec3>& colors) {
            for (std::size_t i = 0; i < activity.size(); ++i) activity[i] += squaredError(centre[i], colors[i]);
        };
        addDifference(corner);
        if (samples_ > 2) {
            const auto& some = look.take(sampled((samples_ + 1) / 2)).colors;
            for (std::size_t i = 0; i < activity.size(); ++i)
                if (activity[i] < flat) activity[i] += samples_ * samples_ * squaredError(corner[i], some[i]);
            addDifference(some);
        }
        const DepthChoice& coarse = depths_.coarsest();
        if (coarse.error > DepthSearch::enough * target_) addDifference(look.take(sampledAt(coarse, 1)).colors);
        for (double& each : activity) each = std::sqrt(each);
        return activity;
    }

    // Between the samples alone.
    ErrorEstimate sampleError(const Setting& setting) { return pilot_.error(setting); }

    bool isWithin(const ErrorEstimate& error, double errors) const {
        return upperLimit(error.rmse, error.standardError, errors) <= target_;
    }
    bool isLikely(const ErrorEstimate& error) const {
        return isWithin(error, likelyMargin) &&
               upperLimit(error.rmse, error.standardError, sureMargin) <= likelyExcess * target_;
    }
    bool areEnough(const Setting& setting) { return isWithin(sampleError(setting), margin); }

    // And what the depth leaves out, of which the pilot's pixels see the part that the judged depth does not leave out itself.
    ErrorEstimate measured(const Candidate& candidate) {
        const Setting& setting = candidate.setting;
        const DepthChoice& depth = depths_.of(setting);
        const bool isDeeper = depth.error < judgedDepth().error;
        ErrorEstimate error = sampleError(isDeeper ? sampled(setting.samples, setting.adaptive) : setting);
        const double shallow = isDeeper ? 0 : depths_.distance(depth, judgedDepth());
        error.rmse = std::sqrt(error.rmse * error.rmse + std::max(0.0, depth.error * depth.error - shallow * shallow));
        return error;
    }

    // The least number of samples that is enough without adaptive.
    void findSamples() {
        for (;;) {
            pilot_.sampleTruth(sampled(1), std::max(3, samples_ + 1));
            if (samples_ == sampleLimit || areEnough(sampled(samples_))) break;
            const double excess = sampleError(sampled(samples_)).rmse / target_;
            samples_ = stepFrom(std::max(samples_ + 1.0, samples_ * std::pow(excess, 1 / usualFall)));
        }
        while (samples_ > 1 && areEnough(sampled(stepBelow(samples_)))) samples_ = stepBelow(samples_);
    }

    // From what is too few samples even without adaptive to where they are dearer than what is enough.
    void collect() {
        candidates_.clear();
        int samples = samples_;
        while (samples > 1 && sampleError(sampled(samples)).rmse <= target_) samples = stepBelow(samples);
        for (double enough = pilot_.rays(sampled(samples_));; samples = stepFrom(samples + 1)) {
            if (samples <= samples_) addCandidates(sampled(samples));
            if (!collectAdaptive(samples, enough) || samples >= 1.5 * samples_ || samples == sampleLimit) break;
        }
        std::ranges::stable_sort(candidates_, {}, &Candidate::rays);
    }

    // From the coarsest on, until one is good enough or dearer than what is: finer ones are dearer. Then half way back. False
    // if all are dearer.
    bool collectAdaptive(int samples, double& enough) {
        if (samples < 3) return true;
        double coarser = 1;
        for (const double adaptive : adaptiveSteps) {
            const Setting setting = sampled(samples, adaptive);
            const double rays = pilot_.rays(setting);
            if (rays > smallStep * enough) return coarser < 1;
            addCandidates(setting);
            if (areEnough(setting)) {
                if (coarser < 1) addCandidates(sampled(samples, roundedMean(coarser, adaptive)));
                enough = std::min(enough, rays);
                return true;
            }
            coarser = adaptive;
        }
        return true;
    }

    // The setting with every depth that is worth having.
    void addCandidates(const Setting& setting) {
        const ErrorEstimate error = sampleError(setting);
        const double rays = pilot_.rays(setting) / judgedDepth().rays;
        for (const DepthChoice& depth : depths_.choices())
            candidates_.push_back({sampledAt(depth, setting.samples, setting.adaptive), rays * depth.rays, error.rmse,
                                   depth.error, error.standardError});
    }

    // The cheapest that is within the target by the margin; one that costs hardly more and is surely within it; or, where that
    // costs more than the promise allows, one that is likely within it.
    TargetChoice pick() {
        const Candidate *possible = nullptr, *likely = nullptr, *good = nullptr;
        for (const Candidate& candidate : candidates_) {
            if (good && candidate.rays > smallStep * good->rays) break;
            if (!good && likely && candidate.rays > promise * likely->rays - spent() / options_.crop.area()) break;
            if (!possible && candidate.error() - sureMargin * candidate.standardError() <= target_) possible = &candidate;
            if (candidate.error() > target_) continue;
            const ErrorEstimate error = measured(candidate);
            if (!likely && isLikely(error)) likely = &candidate;
            if (isWithin(error, sureMargin)) return result(candidate, possible);
            if (!good && isWithin(error, margin)) good = &candidate;
        }
        if (good || likely) return result(good ? *good : *likely, possible);
        const auto accuracy = [](const Candidate& c) { return std::pair(c.setting.adaptive, c.error()); };
        return result(*std::ranges::min_element(candidates_, {}, accuracy), nullptr);
    }

    TargetChoice result(const Candidate& candidate, const Candidate* cheaper) {
        const ErrorEstimate error = measured(candidate);
        TargetChoice choice;
        choice.setting = candidate.setting;
        choice.reached = error.rmse <= target_;
        choice.error = error.rmse;
        choice.standardError = error.standardError;
        choice.sampleError = candidate.sampleError;
        choice.depthError = candidate.depthError;
        choice.rays = candidate.rays;
        if (cheaper && cheaper->rays < candidate.rays) {
            choice.cheaper = cheaper->setting;
            choice.cheaperError = cheaper->error();
            choice.cheaperRays = cheaper->rays;
        }
        choice.pilotPixels = pilot_.pixelCount();
        choice.pilotRays = spent();
        return choice;
    }

    const Renderer& renderer_;
    const RenderOptions& options_;
    double target_;
    DepthSearch depths_;
    Setting judged_;  // its depth is where what lies between the samples is judged
    std::vector<std::unique_ptr<Pilot>> looks_;
    StratifiedPilot pilot_;
    int samples_ = 0;  // enough without adaptive; at first a guess
    std::vector<Candidate> candidates_;
};

}  // namespace

TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target) {
    return Search(renderer, options, target).choose();
}

}  // namespace raytracer
