// How much neighbouring pixels differ: what a pixel may miss.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "raytracer/pictures/pixels.h"

namespace raytracer {

// Of each pixel of an image, row by row: how far the colours of the 3 x 3 pixels around it, as far as the
// image goes, are apart, as a picture shows them (clamped to [0, 1]), in the channel in which that is most;
// but not less than `least`.
std::vector<double> contrasts(std::span<const glm::dvec3> colors, const ImageSize& size, double least);

// A neighbourhood that looks flat may hide something smaller than a pixel: with this contrast, the least
// error of n samples, 2 / (n sqrt(pixels)), is the RMSE of a picture that is wrong in 1/n of four pixels.
double leastContrast(const ImageSize& picture);

}  // namespace raytracer
