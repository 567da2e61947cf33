// How many samples --target-error takes, by their sampling error.
#pragma once

#include <optional>

#include "depth_search.h"
#include "raytracer/accuracy/estimated_picture.h"
#include "raytracer/accuracy/stratified_pilot.h"
#include "target_statistics.h"

namespace raytracer {

class SampleSearch {
  public:
    // The sampling error is estimated at the depth that is now the finest of `depths`. Keeps references to
    // all arguments.
    SampleSearch(const Renderer& renderer, const RenderOptions& options, double target, DepthSearch& depths,
                 PixelSink& sink);

    // Adds pilot pixels: `times` the number of the first call, which is firstPixels().
    void addPixels(double times);
    double firstPixels() const;

    // Finds the smallest number of samples, along an axis, that reaches the target without `adaptive`.
    void findSamples();
    int samples() const { return samples_; }

    // If one sample may reach the target but is not sure to, renders that picture into the sink, until its
    // error is clearly above the target. The next step, 2 x 2 samples, has four times the rays; the picture
    // costs little more than a sure estimate, and it may be the one to choose. Returns false if nothing is
    // rendered.
    bool tryPicture();
    const std::optional<EstimatedPicture>& picture() const { return picture_; }
    bool isRendered(const Setting& setting) const {
        return picture_ && picture_->isWhole && picture_->setting == setting;
    }

    // Of a setting with the pilot's depth, the sampling error; of one with a smaller depth, also its
    // truncation error against the pilot's depth.
    ErrorEstimate error(const Setting& setting);
    ErrorEstimate errorOfFlat(const Setting& setting) { return pilot_.errorOfFlat(setting); }
    bool isEnough(const Setting& setting) { return isWithin(error(setting), margin, target_); }
    double rays(const Setting& setting) { return pilot_.rays(setting); }

    DepthChoice pilotDepth() const { return depths_.of(deep_); }
    Setting sampled(int samples, double adaptive = 0) const {
        return sampledAt(pilotDepth(), samples, adaptive);
    }
    Setting sampledAt(const DepthChoice& depth, int samples, double adaptive = 0) const;

    std::size_t pixelCount() const;
    double raysSpent() const;  // with the picture's

    static int stepFrom(double samples);  // the first step that is at least this, or the last one
    static int stepBelow(int samples);
    static constexpr int sampleLimit = 16;

  private:
    int guessSamples(Pilot& pilot) const;
    std::vector<double> localContrast(Pilot& pilot) const;

    const Renderer& renderer_;
    const RenderOptions& options_;
    double target_;
    DepthSearch& depths_;
    PixelSink& sink_;
    Setting deep_;                                     // one sample at the pilot's depth
    std::vector<std::unique_ptr<Pilot>> firstPhases_;  // of the stratified pilot's samples
    StratifiedPilot pilot_;
    std::optional<EstimatedPicture> picture_;  // of one sample a pixel
    int samples_ = 0;
};

}  // namespace raytracer
