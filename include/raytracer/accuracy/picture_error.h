// How far a picture is from a converged one: in linear light, clamped to what a picture can show, before
// quantisation.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "raytracer/pictures/pixels.h"

namespace raytracer {

// Keeps the colours as they come: linear, unclamped, in double.
class ColorSink final : public PixelSink {
  public:
    explicit ColorSink(const PixelRectangle& crop);
    void write(int x, int y, std::span<const glm::dvec3> colors) override;
    const std::vector<glm::dvec3>& colors() const& {
        return colors_;
    }  // row-major from the top left of the crop
    std::vector<glm::dvec3> colors() && { return std::move(colors_); }

  private:
    PixelRectangle crop_;
    std::vector<glm::dvec3> colors_;
};

// The rows of a picture, as if rendered into the sink.
void copyTo(PixelSink& sink, const PixelRectangle& crop, std::span<const glm::dvec3> colors);

// Of pixels' colours (the means of their unclamped samples): clamped here, so that clamping comes last, as in
// a picture.
struct PictureError {
    double rmse = 0;      // over all channels, of 1
    double psnr = 0;      // 20 log10(1 / rmse), decibels; infinite for equal pictures
    double maximum = 0;   // of any channel
    double shareOff = 0;  // of the pixels: some channel is off by more than 1/255
};

PictureError pictureError(std::span<const glm::dvec3> colors, std::span<const glm::dvec3> truth);

// One pixel's part of the mean square: the mean over the channels of the squared difference.
double squaredError(const glm::dvec3& color, const glm::dvec3& truth);

// Of each pixel. The truth may be given twice, as two estimates that err independently and are right on
// average: so is then the product of the differences to both as an estimate of the squared error, however
// noisy they are. It may be negative.
std::vector<double> squaredErrors(std::span<const glm::dvec3> colors, std::span<const glm::dvec3> truth,
                                  std::span<const glm::dvec3> otherTruth);

// Of pixels that are a random sample of a picture's: the mean of their squared errors, and the variance of
// that mean.
struct MeanSquare {
    double mean = 0, variance = 0;
};

MeanSquare meanOf(std::span<const double> squaredErrors);
MeanSquare meanOf(double sum, double sumOfSquares,
                  std::size_t pixels);  // the sums of those, and of their squares

// Of a picture, of which few pixels were seen.
struct ErrorEstimate {
    double rmse = 0, standardError = 0;
};

ErrorEstimate rootOf(const MeanSquare& square);

}  // namespace raytracer
