#include "raytracer/accuracy/picture_error.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raytracer/tracer/render_options.h"

namespace raytracer {

namespace {

glm::dvec3 clamped(const glm::dvec3& color) { return glm::clamp(color, 0.0, 1.0); }

}  // namespace

double squaredError(const glm::dvec3& color, const glm::dvec3& truth) {
    const glm::dvec3 off = clamped(color) - clamped(truth);
    return glm::dot(off, off) / 3;
}

double squaredError(const glm::dvec3& color, const glm::dvec3& one, const glm::dvec3& other) {
    constexpr double most = mostSamples;  // so that powers of the result are finite
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const double shown = std::clamp(color[i], 0.0, 1.0);
        const auto off = [&, low = color[i] <= 0 ? 0 : -most, high = color[i] >= 1 ? 1 : most](double truth) {
            return shown - std::clamp(truth, low, high);
        };
        sum += off(one[i]) * off(other[i]);
    }
    return sum / 3;
}

PictureError pictureError(std::span<const glm::dvec3> colors, std::span<const glm::dvec3> truth) {
    PictureError error;
    double sum = 0;  // of the pixels' mean squared errors
    std::size_t off = 0;
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const glm::dvec3 difference = glm::abs(clamped(colors[i]) - clamped(truth[i]));
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

}  // namespace raytracer
