// The error of a picture from few of its pixels, most of them where the error is.
//
// A cheap look at many pixels says how much each has going on in it (its activity: edges, textures), and orders them into
// strata; a dear look at a few pixels of each stratum gives the error of all. Two-phase sampling for stratification: Neyman
// 1938; Cochran, Sampling Techniques, 3rd edition, 12.2. The strata have equal sums of activity and get equal numbers of
// pixels, which is close to the best allocation where errors spread in proportion to activity (Cochran, 5A.7).
#pragma once

#include "raytracer/pilot.h"

namespace raytracer {

class StratifiedPilot {
  public:
    // About `count` of the pixels, a random sample of the picture; all of a stratum that has no more than its part.
    // `activity` is of each pixel, in any unit.
    StratifiedPilot(const Renderer& renderer, const RenderOptions& options, std::span<const PixelPlace> pixels,
                    std::span<const double> activity, std::size_t count);

    // Of the whole picture with a setting, taking another one for the truth.
    PictureError error(const Setting& setting, const Setting& truth);

    double rays(const Setting& setting);  // for each pixel of the whole picture

    std::size_t pixelCount() const;
    double raysSpent() const;

  private:
    struct Stratum {
        double share;  // of the picture's pixels
        std::unique_ptr<Pilot> pilot;
    };
    std::vector<Stratum> strata_;
    double looked_;  // pixels of the first look
};

}  // namespace raytracer
