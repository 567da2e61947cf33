#include "raytracer/tracer/contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace raytracer {

namespace {

// A colour that is brighter counts as this bright. Else the pixels around a light of 1e300 would take the
// most samples.
constexpr double brightest = 16;

struct ColorRange {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-low};

    void add(const ColorRange& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

// Finds, for each pixel of a row, the range of its own colour and its neighbours' in the row.
void measureRow(std::span<const glm::dvec3> colors, std::span<ColorRange> ranges) {
    std::ranges::fill(ranges, ColorRange());
    for (std::size_t x = 0; x < colors.size(); ++x) {
        const glm::dvec3 bounded = glm::clamp(colors[x], -brightest, brightest);
        const std::size_t end = std::min(x + 2, colors.size());
        for (std::size_t i = x == 0 ? 0 : x - 1; i < end; ++i) ranges[i].add({bounded, bounded});
    }
}

}  // namespace

std::vector<double> contrasts(std::span<const glm::dvec3> colors, const ImageSize& size, double least) {
    const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    std::array<std::vector<ColorRange>, 3> rows;  // row y is in rows[y % 3]
    for (auto& row : rows) row.resize(width);
    std::vector<double> result;
    result.reserve(width * height);
    measureRow(colors.first(width), rows[0]);
    for (std::size_t y = 0; y < height; ++y) {
        if (y + 1 < height) measureRow(colors.subspan((y + 1) * width, width), rows[(y + 1) % 3]);
        for (std::size_t x = 0; x < width; ++x) {
            ColorRange range = rows[y % 3][x];
            if (y > 0) range.add(rows[(y - 1) % 3][x]);
            if (y + 1 < height) range.add(rows[(y + 1) % 3][x]);
            const glm::dvec3 spread = range.high - range.low;
            result.push_back(std::max({spread.x, spread.y, spread.z, least}));
        }
    }
    return result;
}

double leastContrast(const ImageSize& picture) {
    return std::min(1.0, 8 / std::sqrt(static_cast<double>(picture.width) * picture.height));
}

}  // namespace raytracer
