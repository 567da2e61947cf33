// A picture of one sample a pixel, and how far off it is. It knows where things change from one pixel to the
// next, so that few pixels, most of them from there, tell the error of all.
#pragma once

#include <functional>

#include "raytracer/accuracy/pilot.h"

namespace raytracer {

struct JudgedPicture {
    Setting setting;
    RenderCounts counts;  // of the picture
    ErrorEstimate error;  // between the samples: against the same depth
    std::size_t judgedPixels = 0;
    double judgingRays = 0;
    bool isWhole = false;  // if not, it was given up
};

enum class Judgement { Unclear, Enough, TooFar };

// Renders the crop into the sink and judges up to about so many of its pixels, each chosen with a probability
// in proportion to its size: how far it is from its neighbours, and a little that is the same for all. By
// quarters, each of blocks from all over the picture: after each one `judge` is asked; from Enough on no more
// are judged, at TooFar no more are rendered. Takes 10 bytes a pixel.
JudgedPicture renderJudged(const Renderer& renderer, const RenderOptions& options, const Setting& setting,
                           PixelSink& sink, double judgedPixels,
                           const std::function<Judgement(const ErrorEstimate&)>& judge);

}  // namespace raytracer
