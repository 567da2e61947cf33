// A picture of one sample a pixel with an estimate of its error. The local contrast of the picture decides
// which few pixels the error is estimated from.
#pragma once

#include <functional>

#include "raytracer/accuracy/pilot.h"

namespace raytracer {

struct EstimatedPicture {
    Setting setting;
    RenderCounts counts;  // of the picture
    ErrorEstimate error;  // of the sampling: against many samples of the same depth
    std::size_t estimatedPixels = 0;
    double estimationRays = 0;
    bool isWhole = false;  // false: rejected before it was complete
};

enum class Decision { Continue, Accept, Reject };

// Renders the crop into the sink and estimates the error from about `pixels` of its pixels. A pixel is chosen
// with a probability proportional to its contrast with its neighbours plus a constant. The picture comes in
// four parts, each spread over the whole crop, and `decide` is called after each: Accept ends the estimating,
// Reject ends the rendering. Takes 10 bytes of memory a pixel.
EstimatedPicture renderEstimated(const Renderer& renderer, const RenderOptions& options,
                                 const Setting& setting, PixelSink& sink, double pixels,
                                 const std::function<Decision(const ErrorEstimate&)>& decide);

}  // namespace raytracer
