// How deep the recursion goes: the ray trees of a few points, traced once, give the cost and the truncation
// error of every max_recursion and cutoff.
#pragma once

#include <map>

#include "raytracer/accuracy/picture_error.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

struct DepthChoice {
    int max_recursion = 0;
    double cutoff = 0;
    double rays = 0;   // of a sample
    double error = 0;  // the truncation error: RMSE of the points against the deepest
};

class Depths {
  public:
    // Traces the points with the depth of a setting.
    Depths(const Renderer& renderer, const RenderOptions& options, std::span<const glm::dvec2> points,
           const Setting& deepest);

    // At most that max_recursion, at least that cutoff.
    const DepthChoice& measured(int max_recursion, double cutoff);

    // The Pareto front of cost and error among the grid's depths, with each of these cutoffs, up to an error
    // of at most `enough`; the cheapest first.
    std::vector<DepthChoice> front(std::span<const double> cutoffs, double enough);

    double raysSpent() const { return spent_; }

  private:
    std::vector<DepthChoice> measure(double cutoff) const;

    int deepest_;
    RayTrees trees_;
    double spent_ = 0;               // rays
    double ofOneRay_ = 0;            // rays of the points whose tree is one ray: the same at every depth
    std::vector<std::size_t> deep_;  // the other points
    std::map<double, std::vector<DepthChoice>> measured_;  // by cutoff, then by max_recursion
};

}  // namespace raytracer
