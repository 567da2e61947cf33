// The ray trees of a few pixels, traced once, give the cost and the truncation error of every depth.
#pragma once

#include <map>
#include <utility>

#include "raytracer/accuracy/pilot.h"

namespace raytracer {

class DepthPilot {
  public:
    // Traces one sample of each pixel with the depth of a setting.
    DepthPilot(const Renderer& renderer, const RenderOptions& options, std::span<const PixelPlace> pixels,
               const Setting& deepest);

    // At most that max_recursion, at least that cutoff.
    const DepthChoice& measured(int max_recursion, double cutoff);
    double distance(const DepthChoice& a, const DepthChoice& b);  // RMSE between their pictures

    std::size_t pixelCount() const { return trees_.pixelCount(); }
    double raysSpent() const { return spent_; }

  private:
    using Depth = std::pair<int, double>;  // max_recursion and cutoff
    std::vector<DepthChoice> measure(double cutoff) const;

    int deepest_;
    RayTrees trees_;
    double spent_ = 0;               // rays
    double ofOneRay_ = 0;            // rays of the pixels whose tree is one ray: the same at every depth
    std::vector<std::size_t> deep_;  // the other pixels
    std::map<double, std::vector<DepthChoice>> measured_;  // by cutoff, then by max_recursion
    std::map<std::pair<Depth, Depth>, double> distances_;
};

}  // namespace raytracer
