// Chooses how deep the recursion goes. Ray trees of points all over the picture give the cost and the
// truncation error of every max_recursion and cutoff. More of them, in the pixels where the choice has left
// rays out, confirm it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "raytracer/accuracy/picture_error.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

// The number of pilot pixels that are sampled at first, and of points whose ray trees are traced at first.
// More follow where they gain more than they cost, or where the target is small.
inline constexpr double fewestPilots = 250;
// An error of this many times the target is too large in any pixel. An error of the target divided by it is
// negligible.
inline constexpr double errorMargin = 4;
// The estimated squared error plus this many of its standard errors must be at most the target's square. The
// margin is large since the distribution is skewed, and since the search takes the first setting that seems
// to reach the target.
inline constexpr double standardErrors = 3;

struct DepthChoice {
    int max_recursion = 0;
    double cutoff = 0;         // 0 where it would have no effect
    double rays = 0;           // mean number per sample
    double squaredError = 0;   // truncation error against the deepest: mean square over the samples
    double standardError = 0;  // of squaredError
    bool isLimited = false;    // squaredError leaves out rays beyond the deepest: too many to trace

    bool isSameAs(const DepthChoice& other) const {
        return max_recursion == other.max_recursion && cutoff == other.cutoff;
    }
    // What the depth leaves for the samples, of the square of the target. Above 0 where samples can reach it.
    double leftOf(double target) const {
        return target * target - squaredError - standardErrors * standardError;
    }
};

class Depths {
  public:
    // Traces these points with the deepest setting, and measures every max_recursion up to its, with each of
    // the cutoffs. None of them may be smaller than deepest.cutoff. Where the deepest setting casts too many
    // rays, its max_recursion is halved until it does not. Adds the rays that it casts to `spent`.
    // `weights`: of the points' squared errors; empty: 1.
    Depths(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
           const Setting& deepest, std::vector<double> cutoffs, RenderCounts& spent,
           std::span<const double> weights = {});

    DepthChoice measured(int max_recursion, double cutoff) const;
    std::vector<DepthChoice> all() const;

    const Setting& deepest() const { return deepest_; }

  private:
    struct Sums {
        double rays = 0;
        // Sums over points of the squared error and of its square. The `last` ones are of the points whose
        // colour no larger max_recursion changes: they count for each larger one too.
        double squares = 0, fourths = 0, lastSquares = 0, lastFourths = 0;
    };
    // Throws TooManyRays.
    void trace(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
               RenderCounts& spent, std::span<const double> weights);
    void measure(const RayTrees& trees, std::size_t point, double weight, double cutoff,
                 std::span<Sums> sums);

    Setting deepest_;
    std::vector<double> cutoffs_;
    std::vector<std::vector<Sums>> sums_;  // by cutoff, then by max_recursion
    double points_;
};

// Searches the depth and the cutoff with which a picture reaches the target error at the least cost. Adds the
// rays that it casts to `spent`.
class DepthSearch {
  public:
    // Traces ray trees at points all over a picture of this many pixels. The depth is at most `limit`.
    DepthSearch(const Renderer& renderer, const RenderOptions& options, double target, double pixels,
                RenderCounts& spent, int limit = mostRecursion);

    const DepthChoice& choice() const { return choice_; }

    // The choice, or a deeper one if that misses the target. leftOut: FirstSamples::leftOut with the choice.
    // What the choice misses may be in few pixels, but only in pixels with rays that it left out: more trees
    // are traced there, so many that one is expected in any part that makes an RMSE of the target.
    DepthChoice confirmed(std::span<const float> leftOut);

  private:
    void measure(double pixels, int limit);

    const Renderer& renderer_;
    const RenderOptions& options_;
    double target_;
    RenderCounts& spent_;
    std::optional<Depths> depths_;  // of Pass::Color
    DepthChoice choice_;
};

}  // namespace raytracer
