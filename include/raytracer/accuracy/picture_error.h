// The error of a picture against a converged one: in linear light, clamped to [0, 1], before quantisation.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "raytracer/pictures/pixels.h"

namespace raytracer {

// Keeps the colours: linear, unclamped, in double; row-major from the top left of the crop.
class ColorSink final : public PixelSink {
  public:
    explicit ColorSink(const PixelRectangle& crop);
    void write(int x, int y, std::span<const glm::dvec3> colors) override;
    const std::vector<glm::dvec3>& colors() const& { return colors_; }
    std::vector<glm::dvec3> colors() && { return std::move(colors_); }

  private:
    PixelRectangle crop_;
    std::vector<glm::dvec3> colors_;
};

// Writes the rows of a picture into the sink, as a render does.
void copyTo(PixelSink& sink, const PixelRectangle& crop, std::span<const glm::dvec3> colors);

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

}  // namespace raytracer
