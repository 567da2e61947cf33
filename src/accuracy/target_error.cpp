#include "raytracer/accuracy/target_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sample_search.h"

namespace raytracer {

namespace {

// The sampling error and the truncation error are nearly independent: pilots measure them apart, and their
// squares add up.
struct Candidate {
    Setting setting;
    double rays = 0;  // per pixel, predicted up to a common factor; 0 if it is already rendered
    ErrorEstimate samples, depth;
    ErrorEstimate error() const { return together(samples, depth); }
};

constexpr double adaptiveSteps[] = {0.3, 0.1, 0.03, 0.01};

// Of the pixels, if `adaptive` may help: the error that it misses lies in few pixels.
constexpr double adaptivePart = 1.0 / 48;
constexpr double leastRound = 0.25;  // of all pixels before: a smaller round adds little information

// The largest cost of the search and the picture, as a multiple of the best setting's cost.
constexpr double mostCost = 1.5;
// A round of pilots must keep the cost of all pilots below this share of the best setting's cost, or below
// this share of what a cheaper setting would save; and its own cost below the third share, of the saving.
constexpr double pilotShare = 0.12, savedShare = 0.15, roundShare = 0.25;
constexpr double checkShare = 0.09;  // in place of pilotShare, for a round that can only confirm the choice
// In place of pilotShare, for a choice that seems sure: few pixels may all have missed the same error.
constexpr double leastShare = 0.04;
constexpr double smallStep = 1.05;  // in rays: as good as equal

constexpr double reachedMargin = 1;   // in standard errors: an error above by less counts as reached
constexpr double likelyExcess = 1.5;  // of the target: the largest error of a setting that likely reaches it

class Search {
  public:
    Search(const Renderer& renderer, const RenderOptions& options, double target, PixelSink& sink,
           const ChoiceListener& report)
        : area_(options.crop.area()),
          target_(target),
          report_(report),
          depths_(renderer, options, target),
          samples_(renderer, options, target, depths_, sink) {}

    // Rounds of pilots with ever more pixels, until the choice is clear or another round would cost too much
    // of what it can save.
    TargetChoice choose() {
        double all = 1, pixels = 1, before = depths_.raysSpent();
        samples_.addPixels(1);
        const double more = adaptivePart * area_ / samples_.firstPixels() - 1;
        if (samples_.samples() > 2 && more > leastRound) {
            samples_.addPixels(more);
            pixels += more;
            all = pixels;
        }
        for (;;) {
            TargetChoice choice = round();
            const double each = (spent() - before) / pixels;  // rays of as many pixels as the first round's
            if (depths_.widen(leastRays(choice))) choice = round();
            while (depths_.halve(choice.setting)) choice = round();
            if (samples_.tryPicture()) choice = round();
            if (samples_.isRendered(choice.setting)) {
                choice.rendered = samples_.picture()->counts;
                return choice;
            }
            pixels = std::min(all, affordableRays(choice) / each);
            if (pixels < leastRound * all) return choice;
            before = spent();
            samples_.addPixels(pixels);
            all += pixels;
        }
    }

  private:
    TargetChoice round() {
        samples_.findSamples();
        collect();
        TargetChoice choice = pick();
        if (report_) report_(choice);
        return choice;
    }

    // The cost that the best setting may have, per pixel.
    static double leastRays(const TargetChoice& choice) {
        return choice.cheaper ? choice.cheaperRays : choice.rays;
    }

    // Rays that another round may cost: it may lead to a cheaper setting, or show that the chosen one does
    // not reach the target.
    double affordableRays(const TargetChoice& choice) const {
        const double best = leastRays(choice) * area_, chosen = choice.rays * area_;
        const double saved = chosen - best;
        const double saving =
            std::min(std::max(pilotShare * best, savedShare * saved) - spent(), roundShare * saved);
        const bool isSure = isWithin({choice.error, choice.standardError}, sureMargin);
        return std::max(saving, (isSure ? leastShare : checkShare) * best - spent());
    }

    double spent() const { return depths_.raysSpent() + samples_.raysSpent(); }

    bool isWithin(const ErrorEstimate& error, double errors) const {
        return raytracer::isWithin(error, errors, target_);
    }
    bool isPossible(const ErrorEstimate& error) const {
        return error.rmse - sureMargin * error.standardError <= target_;
    }
    // A standard error above the target says nothing.
    bool isReached(const ErrorEstimate& error) const {
        return error.standardError <= target_ && error.rmse - reachedMargin * error.standardError <= target_;
    }
    bool isLikely(const ErrorEstimate& error) const {
        return error.rmse <= target_ && raytracer::isWithin(error, sureMargin, likelyExcess * target_);
    }

    // The sampling error and the truncation error together. Of the latter, the sampling pilots already
    // measure the part down to their own depth.
    ErrorEstimate measured(const Candidate& candidate) {
        const Setting& setting = candidate.setting;
        const DepthChoice depth = depths_.of(setting);
        const bool isDeeper =
            depth.error < samples_.pilotDepth().error || (samples_.picture() && setting.samples == 1);
        const ErrorEstimate error =
            samples_.error(isDeeper ? samples_.sampled(setting.samples, setting.adaptive) : setting);
        const double shallow = isDeeper ? 0 : depths_.distance(depth, samples_.pilotDepth());
        const double unseen = std::sqrt(std::max(0.0, depth.error * depth.error - shallow * shallow));
        return together(error, {unseen, depth.error > 0 ? depth.standardError * unseen / depth.error : 0});
    }

    // From too few samples even without `adaptive` up to where more samples cost more than what is enough.
    void collect() {
        candidates_.clear();
        const int most = samples_.samples();
        int samples = most;
        while (samples > 1 && samples_.error(samples_.sampled(samples)).rmse <= target_)
            samples = samples_.stepBelow(samples);
        for (double enough = samples_.rays(samples_.sampled(most));;
             samples = samples_.stepFrom(samples + 1)) {
            if (samples <= most) addCandidates(samples_.sampled(samples));
            if (!collectAdaptive(samples, enough) || samples >= 1.5 * most ||
                samples == SampleSearch::sampleLimit)
                break;
        }
        std::ranges::stable_sort(candidates_, {}, &Candidate::rays);
    }

    // The coarsest tolerance first, until one reaches the target or costs more than what does: finer ones
    // cost more. Then half way back. If the flat pixels alone have too large an error, no others are
    // rendered. Returns false if all cost more.
    bool collectAdaptive(int samples, double& enough) {
        if (samples < 3) return true;
        double coarser = 1;
        for (const double adaptive : adaptiveSteps) {
            const Setting setting = samples_.sampled(samples, adaptive);
            if (isPossible(samples_.errorOfFlat(setting))) {
                const double rays = samples_.rays(setting);
                if (rays > smallStep * enough) return coarser < 1;
                addCandidates(setting);
                if (samples_.isEnough(setting)) {
                    if (coarser < 1) addCandidates(samples_.sampled(samples, roundedMean(coarser, adaptive)));
                    enough = std::min(enough, rays);
                    return true;
                }
            }
            coarser = adaptive;
        }
        return true;
    }

    // The setting with every depth of the search.
    void addCandidates(const Setting& setting) {
        const ErrorEstimate error = samples_.error(setting);
        const double rays = samples_.rays(setting) / samples_.pilotDepth().rays;
        for (const DepthChoice& depth : depths_.choices()) {
            const Setting deep = samples_.sampledAt(depth, setting.samples, setting.adaptive);
            const double deepRays = samples_.isRendered(deep) ? 0 : rays * depth.rays;
            candidates_.push_back({deep, deepRays, error, {depth.error, depth.standardError}});
        }
    }

    // The cheapest that is within the target by the margin, or one that costs hardly more and is surely
    // within it. If that costs more than mostCost allows, one that is likely within the target.
    TargetChoice pick() {
        const Candidate *possible = nullptr, *likely = nullptr, *good = nullptr;
        for (const Candidate& candidate : candidates_) {
            if (good && candidate.rays > smallStep * good->rays) break;
            if (!good && likely && candidate.rays > mostCost * likely->rays - spent() / area_) break;
            const bool isRendered = candidate.rays == 0;
            if (!possible && !isRendered && isPossible(candidate.error())) possible = &candidate;
            if (!isRendered && candidate.error().rmse > target_) continue;
            const ErrorEstimate error = measured(candidate);
            if (!likely && (isRendered ? isReached(error) : isLikely(error))) likely = &candidate;
            if (isWithin(error, sureMargin)) return result(candidate, possible);
            if (!good && isWithin(error, margin)) good = &candidate;
        }
        if (good || likely) return result(good ? *good : *likely, possible);
        const auto accuracy = [](const Candidate& c) {
            return std::pair(c.setting.adaptive, c.error().rmse);
        };
        return result(*std::ranges::min_element(candidates_, {}, accuracy), nullptr);
    }

    TargetChoice result(const Candidate& candidate, const Candidate* cheaper) {
        const ErrorEstimate error = measured(candidate);
        TargetChoice choice;
        choice.setting = candidate.setting;
        choice.reached = isReached(error);
        choice.error = error.rmse;
        choice.standardError = error.standardError;
        choice.sampleError = candidate.samples.rmse;
        choice.depthError = candidate.depth.rmse;
        const double rendered =
            samples_.isRendered(choice.setting) ? rayCount(samples_.picture()->counts) : 0;
        choice.rays = rendered > 0 ? rendered / area_ : candidate.rays;
        if (cheaper && cheaper->rays < candidate.rays) {
            choice.cheaper = cheaper->setting;
            choice.cheaperError = cheaper->error().rmse;
            choice.cheaperRays = cheaper->rays;
        }
        choice.pilotPixels = samples_.pixelCount();
        choice.pilotRays = spent() - rendered;
        return choice;
    }

    double area_, target_;
    const ChoiceListener& report_;
    DepthSearch depths_;
    SampleSearch samples_;
    std::vector<Candidate> candidates_;
};

}  // namespace

TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target,
                           PixelSink& sink, const ChoiceListener& report) {
    return Search(renderer, options, target, sink, report).choose();
}

}  // namespace raytracer
