// A few pixels, whose rays are followed once: what they would be and cost at every depth.
#pragma once

#include <map>
#include <utility>

#include "raytracer/accuracy/pilot.h"

namespace raytracer {

class DepthPilot {
  public:
    // As deep as a setting; one sample of each pixel.
    DepthPilot(const Renderer& renderer, const RenderOptions& options, std::span<const PixelPlace> pixels,
               const Setting& deepest);

    // No deeper than that, and no smaller cutoff.
    const DepthChoice& measured(int max_recursion, double cutoff);
    double distance(const DepthChoice& a, const DepthChoice& b);  // RMSE between them

    std::size_t pixelCount() const { return trees_.pixelCount(); }
    double raysSpent() const { return spent_; }  // for all pixels

  private:
    using Depth = std::pair<int, double>;  // max_recursion and cutoff
    std::vector<DepthChoice> measure(double cutoff) const;

    int deepest_;
    RayTrees trees_;
    double spent_ = 0, ofOneRay_ = 0;  // rays: in all; of the pixels that are the same at every depth
    std::vector<std::size_t> deep_;    // the other pixels
    std::map<double, std::vector<DepthChoice>> measured_;  // by cutoff: each max_recursion
    std::map<std::pair<Depth, Depth>, double> distances_;
};

}  // namespace raytracer
