#include "raytracer/target_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

constexpr int sampleLimit = 16;       // the grid's last
constexpr int referenceFactor = 3;    // the reference's samples are so many times those that it judges, along an axis

// The pilot's pixels in the first round; each further one has as many as all before it.
constexpr double scatteredPart = 1.0 / 72, leastScattered = 1500;  // of the picture's pixels: looked at
constexpr double judgedPixels = 480;
constexpr double promise = 1.5;     // times the best setting's cost is the most that all may cost, the pilot included
constexpr double leastRound = 0.25;  // of all pixels before: fewer would tell little more
constexpr double pilotShare = 0.4;  // of what the best may cost: no round is begun that would exceed it
constexpr double smallStep = 1.2;   // a setting dearer by no more than this is as good

// With some odds to spare, since only a picture in ten may be above, and the cheapest that seems to do is likely to seem better
// than it is: 1.25 standard errors (one leaves 8 of 77 above, Notes.txt).
bool isWithin(const PictureError& error, double target) { return upperLimit(error.rmse, error.standardError, 1.25) <= target; }

double areaOf(const PixelRectangle& crop) { return static_cast<double>(crop.width()) * crop.height(); }

class Search {
  public:
    Search(const Renderer& renderer, const RenderOptions& options, double target)
        : renderer_(renderer), options_(options), target_(target),
          depths_(renderer, options, target) {}

    // In rounds of ever more pixels, until the choice is clear or more would cost too much of what it can save.
    TargetChoice choose() {
        for (double pixels = 1, all = 1;; all += pixels) {
            const double before = spent();
            look(pixels);
            TargetChoice choice = round();
            const double each = (spent() - before) / pixels;  // rays, for as many pixels as the first round has
            if (depths_.widen(choice.rays)) choice = round();
            pixels = std::min(all, (budget(choice) - spent()) / each);
            if (isClear(choice) || pixels < leastRound * all) return choice;
        }
    }

  private:
    struct Look {
        std::unique_ptr<Pilot> pilot;
        std::size_t judged;  // so many of its pixels are
    };

    TargetChoice round() {
        findSamples();
        collect();
        return pick();
    }

    // Whether more pixels would hardly choose otherwise.
    bool isClear(const TargetChoice& choice) const {
        return upperLimit(choice.error, choice.standardError, 2) <= target_ && !mayBeBeaten(choice);
    }

    bool mayBeBeaten(const TargetChoice& choice) const {
        return choice.cheaper && choice.rays > smallStep * choice.cheaperRays &&
               choice.cheaperError - 2 * choice.cheaperStandardError <= target_;
    }

    // Rays for all pilots. What the best may cost is the least that may do; where it is not much less than what was chosen,
    // that will be rendered, so that the rest of the promise is what there is to spend.
    double budget(const TargetChoice& choice) const {
        const double best = choice.cheaper ? choice.cheaperRays : choice.rays;
        const double extra = mayBeBeaten(choice) ? 0 : std::max(0.0, choice.rays - best);
        return (pilotShare * best - extra) * areaOf(options_.crop);
    }

    double spent() const {
        double spent = depths_.raysSpent() + spent_;
        for (const Look& look : looks_) spent += look.pilot->raysSpent();
        return spent + (pilot_ ? pilot_->raysSpent() : 0);
    }

    // A part of the picture's pixels; but no fewer than tell anything.
    std::size_t pixelsFor(double part, double least) const {
        return static_cast<std::size_t>(std::min(areaOf(options_.crop), std::max(least, part * areaOf(options_.crop))));
    }

    Setting sampled(int samples, double adaptive = 0) const { return sampledAt(depths_.fine(), samples, adaptive); }

    Setting sampledAt(const DepthChoice& depth, int samples, double adaptive = 0) const {
        return {samples, adaptive, depth.max_recursion, depth.cutoff, options_.bilinear};
    }

    // More pixels, so many times the first round's.
    void look(double times) {
        const auto seed = static_cast<std::uint32_t>(2 + looks_.size());
        auto pixels = scatteredPixels(options_.crop, pixelsFor(times * scatteredPart, times * leastScattered), seed);
        looks_.push_back({std::make_unique<Pilot>(renderer_, options_, std::move(pixels)),
                          static_cast<std::size_t>(times * judgedPixels)});
    }

    // How much each pixel has going on: how far apart is what its centre, its corners, half of the samples and a coarse
    // depth see.
    std::vector<double> activity(Pilot& look, int samples) const {
        const auto& centre = look.take(sampled(1)).colors;
        std::vector<double> activity(centre.size(), 0);
        const auto addDifference = [&](const Setting& setting) {
            const auto& colors = look.take(setting).colors;
            for (std::size_t i = 0; i < activity.size(); ++i) activity[i] += squaredError(centre[i], colors[i]);
        };
        addDifference(sampled(64, 1));  // adaptive 1: the corners alone
        if (samples > 2) addDifference(sampled((samples + 1) / 2));
        const DepthChoice& coarse = depths_.coarsest();
        if (coarse.error > DepthSearch::enough * target_) addDifference(sampledAt(coarse, 1));
        return activity;
    }

    // Prepares to judge so many samples, by all pixels looked at so far.
    void focus(int samples) {
        if (!pilot_ || reference_ != sampled(referenceFactor * samples)) {
            if (pilot_) spent_ += pilot_->raysSpent();
            pilot_ = std::make_unique<StratifiedPilot>(renderer_, options_);
            reference_ = sampled(referenceFactor * samples);
            focused_ = 0;
        }
        for (; focused_ < looks_.size(); ++focused_) {
            const Look& look = looks_[focused_];
            pilot_->add(look.pilot->pixels(), activity(*look.pilot, samples), look.judged);
        }
    }

    // Between the samples alone.
    PictureError sampleError(const Setting& setting) {
        PictureError error = pilot_->error(setting, reference_);
        const double seen = seenPart(setting.samples, reference_.samples);
        error.rmse /= seen;
        error.standardError /= seen;
        return error;
    }
    bool areEnough(const Setting& setting) { return isWithin(sampleError(setting), target_); }

    // And what the depth leaves out, of which the pilot's pixels see the part that the reference does not leave out itself.
    PictureError measured(const Candidate& candidate) {
        const Setting& setting = candidate.setting;
        const DepthChoice &depth = depths_.of(setting), &fine = depths_.fine();
        const bool isDeeper = depth.error < fine.error;
        PictureError error = sampleError(isDeeper ? sampled(setting.samples, setting.adaptive) : setting);
        const double shallow = isDeeper ? 0 : depths_.distance(depth, fine);
        error.rmse = std::sqrt(error.rmse * error.rmse + std::max(0.0, depth.error * depth.error - shallow * shallow));
        return error;
    }

    // How many samples it may take, from how the error falls from one to two.
    int guessSamples() {
        const double one = sampleError(sampled(1)).rmse, two = sampleError(sampled(2)).rmse;
        const double rate = std::clamp(std::log2(one / two), 0.8, 1.6);
        return static_cast<int>(std::lround(2 * std::pow(two / target_, 1 / rate)));
    }

    // The number of samples that is enough without adaptive, and the pilot to judge it.
    void findSamples() {
        if (samples_ <= 2) {
            focus(2);
            for (samples_ = 1; samples_ <= 2; ++samples_)
                if (areEnough(sampled(samples_))) return;
            samples_ = guessSamples();
        }
        for (const int samples : gridSamples) {
            if (samples <= 2 || (samples < samples_ && samples < sampleLimit)) continue;
            samples_ = samples;
            focus(samples);
            if (areEnough(sampled(samples))) return;
        }
    }

    void collect() {
        candidates_.clear();
        for (auto samples = std::rbegin(gridSamples); samples != std::rend(gridSamples); ++samples) {
            if (*samples > samples_) continue;
            addCandidates(sampled(*samples));
            if (sampleError(sampled(*samples)).rmse > target_) break;
            collectAdaptive(*samples);
        }
        for (const int samples : gridSamples)
            if (samples > samples_ && 2 * samples <= reference_.samples) collectAdaptive(samples);
        std::ranges::stable_sort(candidates_, {}, &Candidate::rays);
    }

    // From the coarsest on, until one is good enough: finer ones are dearer.
    void collectAdaptive(int samples) {
        if (samples < 3) return;
        for (auto adaptive = std::rbegin(gridAdaptive); adaptive != std::rend(gridAdaptive); ++adaptive) {
            if (*adaptive == 0) return;
            addCandidates(sampled(samples, *adaptive));
            if (areEnough(sampled(samples, *adaptive))) return;
        }
    }

    // The setting with every depth that is worth having.
    void addCandidates(const Setting& setting) {
        const PictureError error = sampleError(setting);
        const double rays = pilot_->rays(setting) / depths_.fine().rays;
        for (const DepthChoice& depth : depths_.choices())
            candidates_.push_back({sampledAt(depth, setting.samples, setting.adaptive), rays * depth.rays, error.rmse,
                                   depth.error, error.standardError});
    }

    // The cheapest that is within the target surely; or, where that costs more than the promise allows, likely.
    TargetChoice pick() {
        const Candidate *possible = nullptr, *likely = nullptr;
        for (const Candidate& candidate : candidates_) {
            if (!possible && candidate.error() - 2 * candidate.standardError() <= target_) possible = &candidate;
            if (candidate.error() > 1.05 * target_) continue;
            const PictureError error = measured(candidate);
            if (!likely && error.rmse <= target_) likely = &candidate;
            if (!isWithin(error, target_)) continue;
            return result(candidate.rays > promise * likely->rays ? *likely : candidate, possible);
        }
        return result(likely ? *likely : *std::ranges::min_element(candidates_, {}, &Candidate::error), nullptr);
    }

    TargetChoice result(const Candidate& candidate, const Candidate* cheaper) {
        const PictureError error = measured(candidate);
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
            choice.cheaperStandardError = cheaper->standardError();
            choice.cheaperRays = cheaper->rays;
        }
        choice.pilotPixels = pilot_->pixelCount();
        choice.pilotRays = spent();
        return choice;
    }

    const Renderer& renderer_;
    const RenderOptions& options_;
    double target_;
    DepthSearch depths_;
    std::vector<Look> looks_;
    std::unique_ptr<StratifiedPilot> pilot_;
    std::size_t focused_ = 0;  // looks that are in the pilot
    Setting reference_;
    int samples_ = 1;
    std::vector<Candidate> candidates_;
    double spent_ = 0;  // rays, by pilots that are gone
};

}  // namespace

TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target) {
    return Search(renderer, options, target).choose();
}

}  // namespace raytracer
