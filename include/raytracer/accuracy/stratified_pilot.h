// Estimates the error of a picture from few of its pixels, most of them where the error is large.
//
// Two-phase sampling for stratification: Neyman 1938; Cochran, Sampling Techniques, 3rd edition, 12.2. The
// first phase measures the local contrast of many pixels cheaply and sorts them into strata by it. The second
// measures the error of a few pixels of each stratum. All strata have the same sum of contrast and the same
// number of pixels in the second phase: close to the optimal allocation if the spread of the errors is
// proportional to the contrast (Cochran, 5A.7).
#pragma once

#include "raytracer/accuracy/pilot.h"

namespace raytracer {

// What is added to the contrast of each of `count` pixels, `total` being the sum of their contrasts: a tenth
// of the sum of both. A pixel without measured contrast may have an error all the same.
double evenContrast(double total, double count);

class StratifiedPilot {
  public:
    StratifiedPilot(const Renderer& renderer, const RenderOptions& options)
        : renderer_(renderer), options_(options) {}

    // Adds a sample: `pixels` are the first phase, a random sample of the picture, with the local contrast of
    // each, in any unit. About `count` of them become the second phase. A later sample must be independent.
    void add(std::span<const PixelPlace> pixels, std::span<const double> contrast, std::size_t count);

    // Of the whole picture with a setting, with another one as the truth.
    ErrorEstimate error(const Setting& setting, const Setting& truth);

    // As in pilot.h; the errors are against the sampled truth.
    void sampleTruth(const Setting& depth, int n);
    ErrorEstimate error(const Setting& setting);
    ErrorEstimate errorOfShallow(const Setting& setting, const Setting& deep);
    ErrorEstimate errorOfFlat(const Setting& setting);

    double rays(const Setting& setting);  // per pixel of the whole picture

    std::size_t pixelCount() const;
    double raysSpent() const;

  private:
    struct Stratum {
        double share;  // of the picture's pixels
        std::unique_ptr<Pilot> pilot;
    };
    struct Sample {
        std::vector<Stratum> strata;
        double pixels;  // of the first phase
    };
    template <class SquaredError>
    ErrorEstimate estimate(SquaredError squaredError);
    double part(const Sample& sample) const;  // of the first phase's pixels of all samples

    const Renderer& renderer_;
    const RenderOptions& options_;
    std::vector<Sample> samples_;
};

}  // namespace raytracer
