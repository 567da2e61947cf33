// Pilot pixels of --target-error, and what they tell of the whole picture.
#pragma once

#include <cstdint>
#include <span>

#include "raytracer/pictures/pixels.h"
#include "raytracer/tracer/pixel_estimate.h"

namespace raytracer {

// A pilot pixel: its own samples, and two estimates of the truth from other samples.
struct PilotPixel {
    PixelPlace place;
    double contrast = 0;
    double draws = 0;          // how often it was drawn
    double weight = 0;         // a draw's squared error times this estimates the picture's
    std::uint32_t others = 0;  // the sequence of truth[0]; no two pixels share one: independent errors
    PixelEstimate own{}, truth[2]{};
};

// The picture's mean squared error, as estimated, and how much larger it may be.
struct SquaredError {
    double mean = 0;
    double margin = 0;
};

// The margin is `standardErrors` standard errors, and more if the draws are few and their distribution is
// skewed (Johnson, Modified t tests and confidence intervals for asymmetrical populations, JASA 73, 1978).
SquaredError squaredErrorOf(std::span<const PilotPixel> pilots, double draws);

struct Samples {
    double ofPilots = 0;   // their own, and the truths'
    double ofPicture = 0;  // estimated
};

Samples samplesOf(std::span<const PilotPixel> pilots, double draws, double pixels);

// Whether more pilot pixels are a better use of rays than more samples in the picture. Twice as many pilot
// pixels shrink the margin by a factor of sqrt(2). The picture's squared error falls as samples^-3/2.
bool isBetterToDraw(const SquaredError& error, const Samples& samples);

}  // namespace raytracer
