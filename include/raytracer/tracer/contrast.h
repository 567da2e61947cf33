// How much neighbouring pixels differ, which bounds what a pixel may miss.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "raytracer/pictures/pixels.h"

namespace raytracer {

// For each pixel of an image, row by row: the largest difference, in any channel, between the colours of the
// 3 x 3 pixels around it, as far as they are in the image. Colours count as 16 at most. No contrast is less
// than `least`.
std::vector<double> contrasts(std::span<const glm::dvec3> colors, const ImageSize& size, double least);

// A neighbourhood that looks flat may hide something smaller than a pixel. With this as the least contrast,
// the least error of n samples is 2 / (n sqrt(pixels)): the RMSE of a picture with four pixels that are wrong
// in 1/n of their area.
double leastContrast(const ImageSize& picture);

}  // namespace raytracer
