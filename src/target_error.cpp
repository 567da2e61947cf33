#include "raytracer/target_error.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

constexpr double depthShare = 0.25;   // of the target: a depth that costs no more than this of it is deep enough
constexpr int sampleLimit = 16;       // the grid's last

// Whether the error of the pilot's pixels lets the picture's be expected to be in reach, with some odds to spare.
bool isWithin(const PictureError& error, double target) { return error.rmse + error.standardError / 2 <= 0.98 * target; }

// Pixels of the pilot: about a hundredth of the picture, which costs about a tenth to a quarter of the render it saves;
// but enough for a tenth of the error to be seen, and no more than for a twentieth.
std::size_t pilotSize(const PixelRectangle& crop) {
    const auto area = static_cast<std::size_t>(crop.width()) * static_cast<std::size_t>(crop.height());
    return std::min(area, std::clamp<std::size_t>(area / 90, 1500, 8000));
}

// Of cutoffs the ones that leave an error of the target's order: on the scenes a cutoff's RMSE is 1/30 to 1/300 of it.
std::vector<double> cutoffsFor(double target) {
    std::vector<double> cutoffs;
    for (const double cutoff : gridCutoffs)
        if (cutoff >= 9 * target && cutoff <= 110 * target) cutoffs.push_back(cutoff);
    if (cutoffs.empty()) cutoffs.push_back(target > 0.01 ? std::end(gridCutoffs)[-1] : gridCutoffs[0]);
    return cutoffs;
}

class Search {
  public:
    Search(const Renderer& renderer, const RenderOptions& options, double target)
        : target_(target),
          depthPilot_(renderer, options, scatteredPixels(options.crop, pilotSize(options.crop) / 3, 1)),
          pilot_(renderer, options, scatteredPixels(options.crop, pilotSize(options.crop), 0)) {}

    TargetChoice choose() {
        findDepths();
        findSamples();
        collect();
        return pick();
    }

  private:
    void findDepths() {
        const Setting deepest{.max_recursion = 32, .cutoff = std::min(0.1, 10 * target_)};
        depths_ = depthFront(depthPilot_, deepest, cutoffsFor(target_), depthShare * target_);
        fine_ = depths_.back();
        for (const DepthChoice& choice : depths_)
            if (choice.error <= depthShare * target_ && choice.rays < fine_.rays) fine_ = choice;
    }

    Setting sampled(int samples, double adaptive = 0) const {
        return {.samples = samples, .adaptive = adaptive, .max_recursion = fine_.max_recursion, .cutoff = fine_.cutoff};
    }

    // What the pilot's pixels say of a setting. Where it is as deep as the reference, that leaves out the same.
    PictureError measured(const Setting& setting) {
        PictureError error = pilot_.error(setting, reference_);
        if (setting.max_recursion == fine_.max_recursion && setting.cutoff == fine_.cutoff)
            error.rmse = std::hypot(error.rmse, fine_.error);
        return error;
    }

    // Whether so many samples are enough, as twice as many see it.
    bool areEnough(int samples) {
        reference_ = sampled(2 * samples);
        return isWithin(measured(sampled(samples)), target_);
    }

    // How many samples it may take, from how the error falls from one to two, seen by four.
    int guessSamples() {
        const double one = measured(sampled(1)).rmse, two = measured(sampled(2)).rmse;
        const double rate = std::clamp(std::log2(one / two), 0.8, 1.6);
        return static_cast<int>(std::lround(2 * std::pow(two / target_, 1 / rate)));
    }

    // The number of samples that is enough without adaptive, and the reference to see it: twice as many.
    void findSamples() {
        for (samples_ = 1; samples_ <= 2; ++samples_)
            if (areEnough(samples_)) return;
        const int guess = guessSamples();
        for (const int samples : gridSamples) {
            if (samples <= 2 || (samples < guess && samples < sampleLimit)) continue;
            samples_ = samples;
            if (areEnough(samples)) return;
        }
    }

    void collect() {
        for (auto samples = std::rbegin(gridSamples); samples != std::rend(gridSamples); ++samples) {
            if (*samples > samples_) continue;
            addCandidates(sampled(*samples));
            if (measured(sampled(*samples)).rmse > target_) break;
            collectAdaptive(*samples);
        }
        for (const int samples : gridSamples)
            if (samples > samples_ && 3 * samples <= 2 * reference_.samples) collectAdaptive(samples);
        std::ranges::stable_sort(candidates_, {}, &Candidate::rays);
    }

    // From the coarsest on, until one is good enough: finer ones are dearer.
    void collectAdaptive(int samples) {
        if (samples < 3) return;
        for (auto adaptive = std::rbegin(gridAdaptive); adaptive != std::rend(gridAdaptive); ++adaptive) {
            if (*adaptive == 0) return;
            addCandidates(sampled(samples, *adaptive));
            if (isWithin(measured(sampled(samples, *adaptive)), target_)) return;
        }
    }

    // The setting with every depth that is worth having.
    void addCandidates(const Setting& setting) {
        const double error = pilot_.error(setting, reference_).rmse, rays = pilot_.take(setting).rays / fine_.rays;
        for (const DepthChoice& depth : depths_) {
            Setting combined = setting;
            combined.max_recursion = depth.max_recursion;
            combined.cutoff = depth.cutoff;
            candidates_.push_back({combined, rays * depth.rays, error, depth.error});
        }
    }

    TargetChoice pick() {
        const Candidate* cheaper = nullptr;
        for (const Candidate& candidate : candidates_) {
            if (candidate.error() > 1.1 * target_) continue;
            if (isWithin(measured(candidate.setting), target_)) return result(candidate, cheaper);
            cheaper = &candidate;
        }
        return result(*std::ranges::min_element(candidates_, {}, &Candidate::error), nullptr);
    }

    TargetChoice result(const Candidate& candidate, const Candidate* cheaper) {
        const PictureError error = measured(candidate.setting);
        TargetChoice choice;
        choice.setting = candidate.setting;
        choice.reached = error.rmse <= target_;
        choice.error = error.rmse;
        choice.standardError = error.standardError;
        choice.sampleError = candidate.sampleError;
        choice.depthError = candidate.depthError;
        choice.rays = pilot_.take(candidate.setting).rays;
        if (cheaper) {
            choice.cheaper = cheaper->setting;
            choice.cheaperError = measured(cheaper->setting).rmse;
        }
        choice.pilotPixels = pilot_.pixelCount();
        choice.pilotRays = pilot_.raysSpent() + depthPilot_.raysSpent();
        return choice;
    }

    double target_;
    Pilot depthPilot_, pilot_;
    std::vector<DepthChoice> depths_;
    DepthChoice fine_;  // the cheapest that is deep enough not to matter
    int samples_ = 1;
    Setting reference_;
    std::vector<Candidate> candidates_;
};

}  // namespace

TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target) {
    return Search(renderer, options, target).choose();
}

}  // namespace raytracer
