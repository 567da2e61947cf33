// The error of a picture against a converged one: in linear light, clamped to [0, 1], before quantisation.
#pragma once

#include <span>

#include <glm/vec3.hpp>

namespace raytracer {

// Takes pixels' colours, the means of their unclamped samples, and clamps them here: as in a picture,
// clamping comes last.
struct PictureError {
    double rmse = 0;      // over all channels, of 1
    double psnr = 0;      // 20 log10(1 / rmse), decibels; infinite for equal pictures
    double maximum = 0;   // of any channel
    double shareOff = 0;  // the share of pixels with an error of more than 1/255 in some channel
};

PictureError pictureError(std::span<const glm::dvec3> colors, std::span<const glm::dvec3> truth);

// Of one pixel: the mean over the channels of the squared difference.
double squaredError(const glm::dvec3& color, const glm::dvec3& truth);

// The same against a truth of which two estimates are known, from other samples each: their own errors are as
// often above as below, so that the product of the differences from both has no bias.
double squaredError(const glm::dvec3& color, const glm::dvec3& one, const glm::dvec3& other);

}  // namespace raytracer
