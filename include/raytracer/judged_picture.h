// A whole picture of one sample a pixel, and how far off it is. It knows where things change from one pixel to the next, so
// that few pixels, most of them from there, tell the error of all.
#pragma once

#include <functional>

#include "raytracer/pilot.h"

namespace raytracer {

struct JudgedPicture {
    Setting setting;
    std::vector<glm::dvec3> colors;  // of the crop, row-major from the top left; linear, unclamped
    RenderCounts counts;             // of the picture
    ErrorEstimate error;             // between the samples: against the same depth
    std::size_t judgedPixels = 0;
    double judgingRays = 0;
};

// Renders the crop and judges up to about so many of its pixels, each chosen with a probability in proportion to its size:
// how far it is from its neighbours, and a little that is the same for all. No more of them than make the error clear; asked
// after each quarter. Takes 24 bytes a pixel.
JudgedPicture renderJudged(const Renderer& renderer, const RenderOptions& options, const Setting& setting, double judgedPixels,
                           const std::function<bool(const ErrorEstimate&)>& isClear);

}  // namespace raytracer
