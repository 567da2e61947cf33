// How deep the recursion goes: ray trees of points all over the picture, each traced once, give the cost and
// the truncation error of every max_recursion and cutoff.
#pragma once

#include <vector>

#include "raytracer/accuracy/picture_error.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

// Pilot samples: pixels that are sampled, and points whose ray trees are traced, at first. More are drawn
// where that gains more than it costs, or where the target is small.
inline constexpr double fewestPilots = 250;
// An error of this many times the target is too large wherever it is; the target divided by it is negligible.
inline constexpr double errorMargin = 4;
// A squared error and so many standard errors must be within the target's: it is taken from a skew sample,
// and the first setting that seems to reach the target is chosen.
inline constexpr double standardErrors = 3;

struct DepthChoice {
    int max_recursion = 0;
    double cutoff = 0;         // 0 where it would have no effect
    double rays = 0;           // of a sample
    double squaredError = 0;   // the truncation error: mean square over the samples, against the deepest
    double standardError = 0;  // of squaredError
    bool isLimited = false;    // the rays beyond the deepest, too many to follow, are not in squaredError
};

class Depths {
  public:
    // Every max_recursion up to the deepest's, with each cutoff of at least the deepest's.
    Depths(const Setting& deepest, std::vector<double> cutoffs);

    // Traces more points with the depth of the deepest, and adds their rays to `spent`. Throws TooManyRays.
    void add(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
             RenderCounts& spent);

    DepthChoice measured(int max_recursion, double cutoff) const;
    std::vector<DepthChoice> all() const;

    const Setting& deepest() const { return deepest_; }

  private:
    struct Sums {
        double rays = 0;
        // Of the points that change with a larger max_recursion, and of those that do not any more: the sums
        // of squared errors, and of the squares of these.
        double squares = 0, fourths = 0, lastSquares = 0, lastFourths = 0;
    };
    void measure(const RayTrees& trees, std::size_t point, double cutoff, std::span<Sums> sums);

    Setting deepest_;
    std::vector<double> cutoffs_;
    std::vector<std::vector<Sums>> sums_;  // by cutoff, then by max_recursion
    double points_ = 0;
};

// Measured at these points, to the depth of the deepest, or half of it, and so on, where the rays are too
// many. These functions add the rays that they cast to `spent`.
Depths depthsAt(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
                Setting deepest, const std::vector<double>& cutoffs, RenderCounts& spent);

// The depth of at most `limit` that makes a picture of so many pixels with a target error cheapest.
DepthChoice chooseDepth(const Renderer& renderer, const RenderOptions& options, double target, double pixels,
                        RenderCounts& spent, int limit = mostRecursion);

}  // namespace raytracer
