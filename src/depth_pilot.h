// A few pixels, whose rays are followed once: what they would be and cost at every depth.
#pragma once

#include <compare>
#include <map>
#include <utility>

#include "raytracer/pilot.h"

namespace raytracer {

class DepthPilot {
  public:
    // As deep as a setting; one sample of each pixel.
    DepthPilot(const Renderer& renderer, const RenderOptions& options, std::span<const PixelPlace> pixels,
               const Setting& deepest);

    // No deeper than that, and no smaller cutoff.
    DepthChoice measured(int max_recursion, double cutoff);
    double distance(const DepthChoice& a, const DepthChoice& b);  // RMSE between them

    std::size_t pixelCount() const { return followed_.pixelCount(); }
    double raysSpent() const { return spent_; }  // for all pixels

  private:
    struct Depth {
        int max_recursion;
        double cutoff;
        auto operator<=>(const Depth&) const = default;
    };
    struct Compared {
        double rays;          // of the first, for each pixel
        ErrorEstimate error;  // between them
    };
    struct DeepPixel {
        std::size_t pixel;
        glm::dvec3 color;  // as deep as can be
    };
    const Compared& compared(const Depth& a, const Depth& b);

    Depth deepest_;
    FollowedRays followed_;
    double spent_ = 0, ofOneRay_ = 0;  // rays: in all; of the pixels that are the same at every depth
    std::vector<DeepPixel> deep_;      // the other pixels
    std::map<std::pair<Depth, Depth>, Compared> compared_;
};

}  // namespace raytracer
