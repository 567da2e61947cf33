#include "raytracer/pilot.h"

#include <algorithm>
#include <cmath>

namespace raytracer {

namespace {

// A hash of 32 bits: the finaliser of MurmurHash3 (Appleby), over the sum of odd multiples of the inputs.
std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t h = x * 0x9e3779b1u + y * 0x85ebca77u + seed * 0xc2b2ae3du + 1;
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return h ^ h >> 16;
}

constexpr int placesOfCell = 16;  // along an axis, where a sample of the truth may lie in its cell

// One pixel of a cell.
PixelPlace pixelIn(const PixelRectangle& cell, std::uint32_t random) {
    const auto width = static_cast<std::uint32_t>(cell.width()), height = static_cast<std::uint32_t>(cell.height());
    return {cell.x0 + static_cast<int>(random % width), cell.y0 + static_cast<int>(random / width % height)};
}

}  // namespace

std::vector<PixelPlace> scatteredPixels(const PixelRectangle& crop, std::size_t count, std::uint32_t seed) {
    const double edge = std::max(1.0, std::sqrt(crop.area() / static_cast<double>(count)));
    const int columns = static_cast<int>(std::ceil(crop.width() / edge)), rows = static_cast<int>(std::ceil(crop.height() / edge));
    std::vector<PixelPlace> pixels;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const PixelRectangle cell{crop.x0 + crop.width() * column / columns, crop.y0 + crop.height() * row / rows,
                                      crop.x0 + crop.width() * (column + 1) / columns,
                                      crop.y0 + crop.height() * (row + 1) / rows};
            pixels.push_back(pixelIn(cell, hash(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), seed)));
        }
    return pixels;
}

Pilot::Pilot(const Renderer& renderer, const RenderOptions& options, std::vector<PixelPlace> pixels)
    : renderer_(renderer), options_(options), pixels_(std::move(pixels)) {}

const Pilot::Shot& Pilot::take(const Setting& setting) {
    for (const auto& shot : shots_)
        if (shot->setting == setting) return *shot;
    auto shot = std::make_unique<Shot>(Shot{setting, std::vector<glm::dvec3>(pixels_.size())});
    const double rays = rayCount(renderer_.renderPixels(withSetting(options_, setting), pixels_, shot->colors));
    shot->rays = rays / static_cast<double>(pixels_.size());
    spent_ += rays;
    shots_.push_back(std::move(shot));
    return *shots_.back();
}

PictureError Pilot::error(const Setting& setting, const Setting& truth) {
    return pictureError(take(setting).colors, take(truth).colors);
}

MeanSquare Pilot::squaredError(const Setting& setting, const Setting& truth) {
    const auto& colors = take(truth).colors;
    return meanSquare(take(setting).colors, colors, colors);
}

MeanSquare Pilot::squaredError(const Setting& setting) { return meanSquare(take(setting).colors, truths_[0], truths_[1]); }

// A sample is the centre of a pixel of a picture that is so many times as large.
void Pilot::sampleTruth(const Setting& depth, int n) {
    if (truthSamples_ >= n * n) return;
    const auto cells = static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    const int scale = n * placesOfCell;
    Setting setting = depth;
    setting.samples = 1;
    RenderOptions options = withSetting(options_, setting);
    options.size = {scale * options_.size.width, scale * options_.size.height};
    std::vector<PixelPlace> places(pixels_.size() * cells);
    std::vector<glm::dvec3> colors(places.size());
    for (std::uint32_t twin = 0; twin < 2; ++twin) {
        auto place = places.begin();
        for (const PixelPlace& pixel : pixels_)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const int x = scale * pixel.x + placesOfCell * i, y = scale * pixel.y + placesOfCell * j;
                    *place++ = pixelIn({x, y, x + placesOfCell, y + placesOfCell},
                                       hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), twin));
                }
        spent_ += rayCount(renderer_.renderPixels(options, places, colors));
        truths_[twin].resize(pixels_.size(), glm::dvec3(0));
        auto color = colors.begin();
        for (glm::dvec3& truth : truths_[twin]) {
            truth *= truthSamples_;
            for (std::size_t i = 0; i < cells; ++i) truth += *color++;
            truth /= truthSamples_ + n * n;
        }
    }
    truthSamples_ += n * n;
}

std::vector<DepthChoice> depthFront(Pilot& pilot, const Setting& deepest, std::span<const double> cutoffs, double enough) {
    std::vector<DepthChoice> choices;
    const auto tryOut = [&](int depth, double cutoff) {
        Setting setting = deepest;
        setting.max_recursion = depth;
        setting.cutoff = cutoff;
        choices.push_back({depth, cutoff, pilot.take(setting).rays, pilot.error(setting, deepest).rmse});
        return choices.back().error;
    };
    double closest = 1;
    std::vector<double> before(cutoffs.size(), 2);  // the errors one step less deep; 0: deeper is no closer
    for (const int depth : gridDepths) {
        if (depth > deepest.max_recursion || closest <= enough) break;
        for (std::size_t i = 0; i < cutoffs.size(); ++i) {
            if (before[i] == 0 || (depth == 0 && i > 0)) continue;
            const double error = tryOut(depth, cutoffs[i]);
            closest = std::min(closest, error);
            before[i] = depth > 1 && error > 0.99 * before[i] ? 0 : error;
        }
    }
    std::vector<CostAndError> points;
    for (const DepthChoice& choice : choices) points.push_back({choice.rays, choice.error});
    std::vector<DepthChoice> front;
    for (const std::size_t i : paretoFront(points)) front.push_back(choices[i]);
    return front;
}

}  // namespace raytracer
