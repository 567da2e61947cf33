// How many samples an error takes: what --target-error knows of what lies between them.
#pragma once

#include <optional>

#include "depth_search.h"
#include "raytracer/accuracy/judged_picture.h"
#include "raytracer/accuracy/stratified_pilot.h"
#include "target_statistics.h"

namespace raytracer {

class SampleSearch {
  public:
    // What lies between the samples is judged as deep as the depths' finest one at this time. All are kept by
    // reference.
    SampleSearch(const Renderer& renderer, const RenderOptions& options, double target, DepthSearch& depths,
                 PixelSink& sink);

    // Looks at more pixels, by so many times the number of the first look.
    void look(double times);
    double firstPixels() const;

    // The least number of samples (along an axis) that is enough without adaptive; at first a guess.
    void findSamples();
    int samples() const { return samples_; }

    // Between 1 sample and 2 x 2 lies a step of the rays by 4. Where one may be enough but is not sure to be,
    // renders the picture of one into the sink, until it is clearly too far off: that costs little more than
    // to be sure, and it may be the picture wanted. False if not.
    bool judgePicture();
    const std::optional<JudgedPicture>& picture() const { return picture_; }
    bool isRendered(const Setting& setting) const {
        return picture_ && picture_->isWhole && picture_->setting == setting;
    }

    // Between the samples alone, where the setting is as deep as the judged depth; and against that, where it
    // is not.
    ErrorEstimate error(const Setting& setting);
    ErrorEstimate errorOfFlat(const Setting& setting) { return pilot_.errorOfFlat(setting); }
    bool isEnough(const Setting& setting) { return isWithin(error(setting), margin, target_); }
    double rays(const Setting& setting) { return pilot_.rays(setting); }

    DepthChoice judgedDepth() const { return depths_.of(judged_); }
    Setting sampled(int samples, double adaptive = 0) const {
        return sampledAt(judgedDepth(), samples, adaptive);
    }
    Setting sampledAt(const DepthChoice& depth, int samples, double adaptive = 0) const;

    std::size_t pixelCount() const;
    double raysSpent() const;  // the picture's too

    static int stepFrom(double samples);  // the first step that is no less, or the last one
    static int stepBelow(int samples);
    static constexpr int sampleLimit = 16;

  private:
    int guessSamples(Pilot& look) const;
    std::vector<double> activity(Pilot& look) const;

    const Renderer& renderer_;
    const RenderOptions& options_;
    double target_;
    DepthSearch& depths_;
    PixelSink& sink_;
    Setting judged_;
    std::vector<std::unique_ptr<Pilot>> looks_;
    StratifiedPilot pilot_;
    std::optional<JudgedPicture> picture_;  // of one sample a pixel
    int samples_ = 0;
};

}  // namespace raytracer
