#include "raytracer/tracer/contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace raytracer {

namespace {

struct ColorRange {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-low};

    void add(const ColorRange& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

using ColorRanges = std::vector<ColorRange>;

// Adds a colour to the ranges of its pixel and of the neighbours in the row.
void add(const glm::dvec3& color, std::size_t x, ColorRanges& row) {
    const glm::dvec3 bounded = glm::clamp(color, -brightestInContrast, brightestInContrast);
    const std::size_t end = std::min(x + 2, row.size());
    for (std::size_t i = x == 0 ? 0 : x - 1; i < end; ++i) row[i].add({bounded, bounded});
}

}  // namespace

std::vector<double> contrasts(const PixelRectangle& place, std::span<const glm::dvec3> colors,
                              std::span<const ExtraSample> extra) {
    const auto width = static_cast<std::size_t>(place.width()),
               height = static_cast<std::size_t>(place.height());
    std::array<ColorRanges, 3> rows;  // row y is in rows[y % 3]
    const auto measureRow = [&](std::size_t y) {
        ColorRanges& row = rows[y % 3];
        row.assign(width, {});
        for (std::size_t x = 0; x < width; ++x) add(colors[y * width + x], x, row);
        const auto end = std::ranges::find_if(extra, [&](const ExtraSample& sample) {
            return sample.pixel().y > place.y0 + static_cast<int>(y);
        });
        for (const ExtraSample& sample : std::span(extra.begin(), end))
            add(sample.color, static_cast<std::size_t>(sample.pixel().x - place.x0), row);
        extra = {end, extra.end()};
    };
    std::vector<double> result;
    result.reserve(width * height);
    measureRow(0);
    for (std::size_t y = 0; y < height; ++y) {
        if (y + 1 < height) measureRow(y + 1);
        for (std::size_t x = 0; x < width; ++x) {
            ColorRange range = rows[y % 3][x];
            if (y > 0) range.add(rows[(y - 1) % 3][x]);
            if (y + 1 < height) range.add(rows[(y + 1) % 3][x]);
            const glm::dvec3 spread = range.high - range.low;
            result.push_back(std::max({spread.x, spread.y, spread.z}));
        }
    }
    return result;
}

double leastContrast(const ImageSize& picture) {
    return std::min(1.0, 16 / std::sqrt(static_cast<double>(picture.width) * picture.height));
}

}  // namespace raytracer
