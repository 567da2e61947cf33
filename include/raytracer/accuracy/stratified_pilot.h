// The error of a picture from few of its pixels, most of them where the error is.
//
// A cheap look at many pixels says how much each has going on in it (its activity: edges, textures), and
// orders them into strata; a dear look at a few pixels of each stratum gives the error of all. Two-phase
// sampling for stratification: Neyman 1938; Cochran, Sampling Techniques, 3rd edition, 12.2. The strata have
// equal sums of activity and get equal numbers of pixels, which is close to the best allocation where errors
// spread in proportion to activity (Cochran, 5A.7).
#pragma once

#include "raytracer/accuracy/pilot.h"

namespace raytracer {

// What is added to the activity of each pixel: a tenth of all sizes is the same for all, since what looks
// flat may not be.
double evenSize(double total, double count);

class StratifiedPilot {
  public:
    StratifiedPilot(const Renderer& renderer, const RenderOptions& options)
        : renderer_(renderer), options_(options) {}

    // About `count` of the pixels, a random sample of the picture; all of a stratum that has no more than its
    // part. `activity` is of each pixel, in any unit. What is added later is another, independent sample.
    void add(std::span<const PixelPlace> pixels, std::span<const double> activity, std::size_t count);

    // Of the whole picture with a setting, taking another one for the truth.
    ErrorEstimate error(const Setting& setting, const Setting& truth);

    // Of all pixels; see pilot.h.
    void sampleTruth(const Setting& depth, int n);
    ErrorEstimate error(const Setting& setting);  // against that truth
    ErrorEstimate errorOfShallow(const Setting& setting, const Setting& deep);
    ErrorEstimate errorOfFlat(const Setting& setting);

    double rays(const Setting& setting);  // for each pixel of the whole picture

    std::size_t pixelCount() const;
    double raysSpent() const;

  private:
    struct Stratum {
        double share;  // of the picture's pixels
        std::unique_ptr<Pilot> pilot;
    };
    struct Sample {
        std::vector<Stratum> strata;
        double looked;  // pixels of the first look
    };
    template <class SquaredError>
    ErrorEstimate estimate(SquaredError squaredError);
    double part(const Sample& sample) const;  // of all pixels looked at

    const Renderer& renderer_;
    const RenderOptions& options_;
    std::vector<Sample> samples_;
};

}  // namespace raytracer
