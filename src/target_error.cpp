#include "raytracer/target_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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
    double error() const { return std::hypot(sampleError, depthError); }
};

constexpr double depthShare = 0.2;   // of the target: a depth that costs no more than this of it is deep enough
constexpr int sampleLimit = 16;       // the grid's last
constexpr int referenceFactor = 3;    // the reference's samples are so many times those that it judges, along an axis

// The pilot's pixels in the first round; each further one has as many as all before it.
constexpr double scatteredPart = 1.0 / 72, leastScattered = 1500;  // of the picture's pixels: looked at
constexpr double judgedPixels = 480;
constexpr double pilotShare = 0.4;  // of what the picture costs: no round is begun that would exceed it
constexpr double smallStep = 1.2;   // a setting dearer by no more than this is as good

// With some odds to spare, since only a picture in ten may be above; but for one sample, since the next step costs 4 times.
bool isWithin(const PictureError& error, int samples, double target) {
    return upperLimit(error.rmse, error.standardError, samples > 1 ? 1 : 0) <= target;
}

double areaOf(const PixelRectangle& crop) { return static_cast<double>(crop.width()) * crop.height(); }

// Of cutoffs the ones that leave an error of the target's order: on the scenes a cutoff's RMSE is 1/30 to 1/300 of it.
std::vector<double> cutoffsFor(double target) {
    std::vector<double> cutoffs;
    for (const double cutoff : gridCutoffs)
        if (cutoff >= 9 * target && cutoff <= 110 * target) cutoffs.push_back(cutoff);
    if (cutoffs.empty()) cutoffs.push_back(target > 0.01 ? std::end(gridCutoffs)[-1] : gridCutoffs[0]);
    return cutoffs;
}

// The grid's next smaller cutoff, put before the others; false if there is none.
bool addSmaller(std::vector<double>& cutoffs) {
    const auto* next = std::ranges::find(gridCutoffs, cutoffs.front());
    if (next == std::begin(gridCutoffs)) return false;
    cutoffs.insert(cutoffs.begin(), next[-1]);
    return true;
}

class Search {
  public:
    Search(const Renderer& renderer, const RenderOptions& options, double target)
        : renderer_(renderer), options_(options), target_(target),
          depthPilot_(renderer, options, scatteredPixels(options.crop, pixelsFor(1.0 / 400, 500), 1)) {}

    // In rounds of ever more pixels, until the choice is clear or more would cost too much of what it can save.
    TargetChoice choose() {
        findDepths();
        for (double pixels = 1, next;; pixels = next) {
            const double before = spent();
            look(pixels);
            const TargetChoice choice = round();
            next = static_cast<double>(1 << (looks_.size() - 1));
            const double again = (spent() - before) / pixels * next;
            if (isClear(choice) || spent() + again > pilotShare * atStake(choice) * areaOf(options_.crop)) return choice;
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

    // The rays a pixel of what may be the best choice.
    double atStake(const TargetChoice& choice) const { return mayBeBeaten(choice) ? choice.cheaperRays : choice.rays; }

    double spent() const {
        double spent = depthPilot_.raysSpent() + spent_;
        for (const Look& look : looks_) spent += look.pilot->raysSpent();
        return spent + (pilot_ ? pilot_->raysSpent() : 0);
    }

    // A part of the picture's pixels; but no fewer than tell anything.
    std::size_t pixelsFor(double part, double least) const {
        return static_cast<std::size_t>(std::min(areaOf(options_.crop), std::max(least, part * areaOf(options_.crop))));
    }

    void findDepths() {
        const Setting deepest{.max_recursion = 32, .cutoff = std::min(0.1, 3 * target_), .bilinear = options_.bilinear};
        std::vector<double> cutoffs = cutoffsFor(target_);
        do depths_ = depthFront(depthPilot_, deepest, cutoffs, depthShare * target_);
        while (depths_.back().error > depthShare * target_ && addSmaller(cutoffs));
        fine_ = depths_.back();
        for (const DepthChoice& choice : depths_)
            if (choice.error <= depthShare * target_ && choice.rays < fine_.rays) fine_ = choice;
    }

    Setting sampled(int samples, double adaptive = 0) const { return sampledAt(fine_, samples, adaptive); }

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
        const DepthChoice& coarse = coarsestDepth();
        if (coarse.error > depthShare * target_) addDifference(sampledAt(coarse, 1));
        return activity;
    }

    const DepthChoice& coarsestDepth() const {
        for (const DepthChoice& depth : depths_)
            if (depth.error < target_) return depth;
        return depths_.back();
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

    // What the pilot's pixels say of a setting, and what the reference leaves out itself.
    PictureError measured(const Setting& setting, const DepthChoice& depth) {
        PictureError error = pilot_->error(setting, reference_);
        const double seen = seenPart(setting.samples, reference_.samples);
        const double shallow = depthPilot_.error(sampledAt(depth, 1), sampled(1)).rmse;  // seen already
        error.rmse = std::sqrt(std::pow(error.rmse / seen, 2) + std::max(0.0, depth.error * depth.error - shallow * shallow));
        error.standardError /= seen;
        return error;
    }
    PictureError measured(const Setting& setting) { return measured(setting, fine_); }

    bool areEnough(int samples) { return isWithin(measured(sampled(samples)), samples, target_); }

    // How many samples it may take, from how the error falls from one to two.
    int guessSamples() {
        const double one = measured(sampled(1)).rmse, two = measured(sampled(2)).rmse;
        const double rate = std::clamp(std::log2(one / two), 0.8, 1.6);
        return static_cast<int>(std::lround(2 * std::pow(two / target_, 1 / rate)));
    }

    // The number of samples that is enough without adaptive, and the pilot to judge it.
    void findSamples() {
        if (samples_ <= 2) {
            focus(2);
            for (samples_ = 1; samples_ <= 2; ++samples_)
                if (areEnough(samples_)) return;
            samples_ = guessSamples();
        }
        for (const int samples : gridSamples) {
            if (samples <= 2 || (samples < samples_ && samples < sampleLimit)) continue;
            samples_ = samples;
            focus(samples);
            if (areEnough(samples)) return;
        }
    }

    void collect() {
        candidates_.clear();
        for (auto samples = std::rbegin(gridSamples); samples != std::rend(gridSamples); ++samples) {
            if (*samples > samples_) continue;
            addCandidates(sampled(*samples));
            if (measured(sampled(*samples)).rmse > target_) break;
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
            if (isWithin(measured(sampled(samples, *adaptive)), samples, target_)) return;
        }
    }

    // The setting with every depth that is worth having.
    void addCandidates(const Setting& setting) {
        const double error = pilot_->error(setting, reference_).rmse / seenPart(setting.samples, reference_.samples);
        const double rays = pilot_->rays(setting) / fine_.rays;
        for (const DepthChoice& depth : depths_)
            candidates_.push_back({sampledAt(depth, setting.samples, setting.adaptive), rays * depth.rays, error, depth.error});
    }

    const DepthChoice& depthOf(const Setting& setting) const {
        return *std::ranges::find_if(depths_, [&](const DepthChoice& depth) {
            return depth.max_recursion == setting.max_recursion && depth.cutoff == setting.cutoff;
        });
    }

    TargetChoice pick() {
        const Candidate* cheaper = nullptr;
        for (const Candidate& candidate : candidates_) {
            if (candidate.error() > 1.05 * target_) continue;
            const PictureError error = measured(candidate.setting, depthOf(candidate.setting));
            if (isWithin(error, candidate.setting.samples, target_)) return result(candidate, cheaper);
            cheaper = &candidate;
        }
        return result(*std::ranges::min_element(candidates_, {}, &Candidate::error), nullptr);
    }

    TargetChoice result(const Candidate& candidate, const Candidate* cheaper) {
        const PictureError error = measured(candidate.setting, depthOf(candidate.setting));
        TargetChoice choice;
        choice.setting = candidate.setting;
        choice.reached = error.rmse <= target_;
        choice.error = error.rmse;
        choice.standardError = error.standardError;
        choice.sampleError = candidate.sampleError;
        choice.depthError = candidate.depthError;
        choice.rays = pilot_->rays(candidate.setting);
        if (cheaper) {
            choice.cheaper = cheaper->setting;
            const PictureError missed = measured(cheaper->setting, depthOf(cheaper->setting));
            choice.cheaperError = missed.rmse;
            choice.cheaperStandardError = missed.standardError;
            choice.cheaperRays = pilot_->rays(cheaper->setting);
        }
        choice.pilotPixels = pilot_->pixelCount();
        choice.pilotRays = spent();
        return choice;
    }

    const Renderer& renderer_;
    const RenderOptions& options_;
    double target_;
    Pilot depthPilot_;
    std::vector<DepthChoice> depths_;
    DepthChoice fine_;  // the cheapest that is deep enough not to matter
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
