#include "raytracer/accuracy/target_error.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sample_search.h"

namespace raytracer {

namespace {

// The error has two parts, which a pilot can measure apart since they hardly know of each other: of what rays
// bring that are not followed (depth), and of what lies between the samples. Their squares add up.
struct Candidate {
    Setting setting;
    double rays =
        0;  // for each pixel, predicted up to a factor that is the same for all; 0 if it is rendered already
    ErrorEstimate samples, depth;
    ErrorEstimate error() const { return together(samples, depth); }
};

constexpr double adaptiveSteps[] = {0.3, 0.1, 0.03, 0.01};

constexpr double adaptivePart =
    1.0 / 48;                       // of the pixels, where adaptive may help: what it misses is in few pixels
constexpr double leastLook = 0.25;  // of all pixels before: fewer would tell little more

// What the best setting may cost, times this, is the most that all may cost, the pilot included.
constexpr double promise = 1.5;
// No look is begun after which all pilots together would have cost more than such a part of what the best
// setting costs, or of what a cheaper one would save; nor for more than that part of what it would save
// itself.
constexpr double pilotShare = 0.12, savedShare = 0.15, hope = 0.25;
constexpr double checkShare = 0.09;  // for a look that would only make sure, instead of pilotShare
constexpr double leastShare =
    0.04;  // even where all seems to be sure: few pixels may all have missed the same thing
constexpr double smallStep = 1.05;  // a setting dearer by no more than this is as good

constexpr double reachedMargin = 1;  // standard errors: above by no more than this is not said to be above
constexpr double likelyExcess =
    1.5;  // of the target: what is only likely within it may well be above, but not far

class Search {
  public:
    Search(const Renderer& renderer, const RenderOptions& options, double target, PixelSink& sink,
           const ChoiceSoFar& tell)
        : area_(options.crop.area()),
          target_(target),
          tell_(tell),
          depths_(renderer, options, target),
          samples_(renderer, options, target, depths_, sink) {}

    // In looks at ever more pixels, until the choice is clear or more would cost too much of what it can
    // save.
    TargetChoice choose() {
        double all = 1, pixels = 1, before = depths_.raysSpent();
        samples_.look(1);
        const double more = adaptivePart * area_ / samples_.firstPixels() - 1;
        if (samples_.samples() > 2 && more > leastLook) {
            samples_.look(more);
            all = pixels += more;
        }
        for (;;) {
            TargetChoice choice = round();
            const double each =
                (spent() - before) / pixels;  // rays, for as many pixels as the first look has
            if (depths_.widen(leastRays(choice))) choice = round();
            while (depths_.halve(choice.setting)) choice = round();
            if (samples_.judgePicture()) choice = round();
            if (samples_.isRendered(choice.setting)) {
                choice.rendered = samples_.picture()->counts;
                return choice;
            }
            pixels = std::min(all, worthwhile(choice) / each);
            if (pixels < leastLook * all) return choice;
            before = spent();
            samples_.look(pixels);
            all += pixels;
        }
    }

  private:
    TargetChoice round() {
        samples_.findSamples();
        collect();
        TargetChoice choice = pick();
        if (tell_) tell_(choice);
        return choice;
    }

    // What the best setting may cost.
    static double leastRays(const TargetChoice& choice) {
        return choice.cheaper ? choice.cheaperRays : choice.rays;
    }

    // Rays that may be spent on more pixels: they may lead to a cheaper setting (and to a part of what seems
    // to be possible), or show that this one will not do.
    double worthwhile(const TargetChoice& choice) const {
        const double best = leastRays(choice) * area_, chosen = choice.rays * area_;
        const double saved = chosen - best;
        const double saving =
            std::min(std::max(pilotShare * best, savedShare * saved) - spent(), hope * saved);
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
    bool isReached(
        const ErrorEstimate& error) const {  // with a standard error above the target nothing is known
        return error.standardError <= target_ && error.rmse - reachedMargin * error.standardError <= target_;
    }
    bool isLikely(const ErrorEstimate& error) const {
        return error.rmse <= target_ && raytracer::isWithin(error, sureMargin, likelyExcess * target_);
    }

    // And what the depth leaves out, of which the pilot's pixels see the part that the judged depth does not
    // leave out itself.
    ErrorEstimate measured(const Candidate& candidate) {
        const Setting& setting = candidate.setting;
        const DepthChoice depth = depths_.of(setting);
        const bool isDeeper =
            depth.error < samples_.judgedDepth().error || (samples_.picture() && setting.samples == 1);
        const ErrorEstimate error =
            samples_.error(isDeeper ? samples_.sampled(setting.samples, setting.adaptive) : setting);
        const double shallow = isDeeper ? 0 : depths_.distance(depth, samples_.judgedDepth());
        const double unseen = std::sqrt(std::max(0.0, depth.error * depth.error - shallow * shallow));
        return together(error, {unseen, depth.error > 0 ? depth.standardError * unseen / depth.error : 0});
    }

    // From what is too few samples even without adaptive to where they are dearer than what is enough.
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

    // From the coarsest on, until one is good enough or dearer than what is: finer ones are dearer. Then half
    // way back. Where the flat pixels alone are too far off, no others are rendered. False if all are dearer.
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

    // The setting with every depth that is worth having.
    void addCandidates(const Setting& setting) {
        const ErrorEstimate error = samples_.error(setting);
        const double rays = samples_.rays(setting) / samples_.judgedDepth().rays;
        for (const DepthChoice& depth : depths_.choices()) {
            const Setting deep = samples_.sampledAt(depth, setting.samples, setting.adaptive);
            const double deepRays = samples_.isRendered(deep) ? 0 : rays * depth.rays;
            candidates_.push_back({deep, deepRays, error, {depth.error, depth.standardError}});
        }
    }

    // The cheapest that is within the target by the margin; one that costs hardly more and is surely within
    // it; or, where that costs more than the promise allows, one that is likely within it.
    TargetChoice pick() {
        const Candidate *possible = nullptr, *likely = nullptr, *good = nullptr;
        for (const Candidate& candidate : candidates_) {
            if (good && candidate.rays > smallStep * good->rays) break;
            if (!good && likely && candidate.rays > promise * likely->rays - spent() / area_) break;
            const bool isThere = candidate.rays == 0;
            if (!possible && !isThere && isPossible(candidate.error())) possible = &candidate;
            if (!isThere && candidate.error().rmse > target_) continue;
            const ErrorEstimate error = measured(candidate);
            if (!likely && (isThere ? isReached(error) : isLikely(error))) likely = &candidate;
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
    const ChoiceSoFar& tell_;
    DepthSearch depths_;
    SampleSearch samples_;
    std::vector<Candidate> candidates_;
};

}  // namespace

TargetChoice chooseSetting(const Renderer& renderer, const RenderOptions& options, double target,
                           PixelSink& sink, const ChoiceSoFar& tell) {
    return Search(renderer, options, target, sink, tell).choose();
}

}  // namespace raytracer
