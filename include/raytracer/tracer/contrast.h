// How much neighbouring pixels differ, which bounds what a pixel may miss.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raytracer/pictures/pixels.h"

namespace raytracer {

// A colour that is brighter counts as this bright, in contrasts. Else the pixels around a light of 1e300
// would take the most samples.
inline constexpr double brightestInContrast = 16;

// A sample that shows something small, which the pixel's own samples may miss. It is for the contrast alone:
// at such points on purpose, samples would make a pixel's mean wrong.
struct ExtraSample {
    glm::dvec2 point;  // in the whole picture, in pixels
    glm::dvec3 color{0};

    PixelPlace pixel() const { return {static_cast<int>(point.x), static_cast<int>(point.y)}; }
};

// For each pixel of a place in the picture, row by row: the largest difference, in any channel, between the
// colours of the 3 x 3 pixels around it, as far as they are in the place.
// `extra`: the extra samples in the place, row by row.
std::vector<double> contrasts(const PixelRectangle& place, std::span<const glm::dvec3> colors,
                              std::span<const ExtraSample> extra);

// A neighbourhood that looks flat may hide something smaller than a pixel. With this as the least contrast,
// the least error of n samples is 4 / (n sqrt(pixels)): the RMSE of a picture with 16 pixels that are wrong
// in 1/n of their area.
double leastContrast(const ImageSize& picture);

}  // namespace raytracer
