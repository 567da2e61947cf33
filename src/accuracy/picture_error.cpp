#include "raytracer/accuracy/picture_error.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace raytracer {

namespace {

glm::dvec3 shown(const glm::dvec3& color) { return glm::clamp(color, 0.0, 1.0); }

}  // namespace

ColorSink::ColorSink(const PixelRectangle& crop)
    : crop_(crop),
      colors_(static_cast<std::size_t>(crop.width()) * static_cast<std::size_t>(crop.height())) {}

void ColorSink::write(int x, int y, std::span<const glm::dvec3> colors) {
    const auto place = static_cast<std::ptrdiff_t>(y - crop_.y0) * crop_.width() + (x - crop_.x0);
    std::copy(colors.begin(), colors.end(), colors_.begin() + place);
}

void copyTo(PixelSink& sink, const PixelRectangle& crop, std::span<const glm::dvec3> colors) {
    const auto width = static_cast<std::size_t>(crop.width());
    for (int y = crop.y0; y < crop.y1; ++y) {
        sink.write(crop.x0, y, colors.first(width));
        colors = colors.subspan(width);
    }
}

double squaredError(const glm::dvec3& color, const glm::dvec3& truth) {
    const glm::dvec3 difference = shown(color) - shown(truth);
    return glm::dot(difference, difference) / 3;
}

PictureError pictureError(std::span<const glm::dvec3> colors, std::span<const glm::dvec3> truth) {
    PictureError error;
    double sum = 0;  // of the pixels' mean squared errors
    std::size_t off = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const glm::dvec3 difference = glm::abs(shown(colors[i]) - shown(truth[i]));
        const double largest = std::max({difference.x, difference.y, difference.z});
        sum += squaredError(colors[i], truth[i]);
        error.maximum = std::max(error.maximum, largest);
        off += largest > 1.0 / 255;
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, colors.size()));
    error.rmse = std::sqrt(sum / count);
    error.psnr = -20 * std::log10(error.rmse);
    error.shareOff = static_cast<double>(off) / count;
    return error;
}

std::vector<double> squaredErrors(std::span<const glm::dvec3> colors, std::span<const glm::dvec3> truth,
                                  std::span<const glm::dvec3> otherTruth) {
    std::vector<double> errors;
    errors.reserve(colors.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const glm::dvec3 color = shown(colors[i]);
        errors.push_back(glm::dot(color - shown(truth[i]), color - shown(otherTruth[i])) / 3);
    }
    return errors;
}

MeanSquare meanOf(std::span<const double> squaredErrors) {
    double sum = 0, sumOfSquares = 0;
    for (const double pixel : squaredErrors) {
        sum += pixel;
        sumOfSquares += pixel * pixel;
    }
    return meanOf(sum, sumOfSquares, squaredErrors.size());
}

MeanSquare meanOf(double sum, double sumOfSquares, std::size_t pixels) {
    const auto count = static_cast<double>(std::max<std::size_t>(1, pixels));
    const double mean = sum / count;
    return {mean, std::max(0.0, sumOfSquares / count - mean * mean) / count};
}

ErrorEstimate rootOf(const MeanSquare& square) {
    if (square.mean <= 0) return {0, std::pow(square.variance, 0.25)};  // not distinguishable from 0
    return {std::sqrt(square.mean), std::sqrt(square.variance / square.mean) / 2};
}

}  // namespace raytracer
