// The error of a picture against a converged one: in linear light, clamped to [0, 1], before quantisation.
#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace raytracer {

struct PictureError {
    double rmse = 0;      // over all pixels and channels; 1 is the full range
    double psnr = 0;      // 20 log10(1 / rmse), decibels; infinite for equal pictures
    double maximum = 0;   // largest absolute error of any channel
    double shareOff = 0;  // fraction of pixels with an error of more than 1/255 in some channel
};

// Each pixel's colour is the mean of its unclamped samples. It is clamped here: as in a picture, clamping
// comes last.
PictureError pictureError(std::span<const glm::dvec3> colors, std::span<const glm::dvec3> truth);

// The squared error of one pixel: the mean of the channels' squared differences, after clamping.
double squaredError(const glm::dvec3& color, const glm::dvec3& truth);

// The same where the truth is known only by two independent estimates, each from samples of its own. Their
// errors are independent, so the product of the two differences has the expected value of a square: it is
// never too small on average, though it may be negative by chance. Where the pixel is not white, the truth's
// estimates are not clamped: of samples of 0 and 30, most means are too dark, a few far too bright. Where it
// is white they are, for more light changes nothing; so it is with black. A pixel of which all three are
// white counts, too: without such pixels, the rest would be negative on average.
double squaredError(const glm::dvec3& color, const glm::dvec3& one, const glm::dvec3& other);

}  // namespace raytracer
