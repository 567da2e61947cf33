#include "raytracer/pilot.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

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
    shots_.push_back(setting.adaptive > 0 && setting.samples > 2 ? adapt(setting) : render(setting));
    return *shots_.back();
}

std::unique_ptr<Pilot::Shot> Pilot::render(const Setting& setting) {
    auto shot = std::make_unique<Shot>(Shot{setting, std::vector<glm::dvec3>(pixels_.size())});
    const double rays = rayCount(renderer_.renderPixels(withSetting(options_, setting), pixels_, shot->colors));
    shot->rays = rays / static_cast<double>(pixels_.size());
    spent_ += rays;
    return shot;
}

std::unique_ptr<Pilot::Shot> Pilot::adapt(const Setting& setting) {
    Setting all = setting;
    all.adaptive = 0;
    const Corners& corners = this->corners(all);
    auto shot = std::make_unique<Shot>(Shot{setting, corners.means, corners.rays});
    const auto isActive = [&](double spread) { return spread > setting.adaptive; };
    const auto active = static_cast<double>(std::ranges::count_if(corners.spreads, isActive));
    if (active == 0) return shot;
    const Shot& whole = take(all);
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        if (isActive(corners.spreads[i])) shot->colors[i] = whole.colors[i];
    shot->rays += active / static_cast<double>(pixels_.size()) * (whole.rays - corners.rays);
    return shot;
}

const Pilot::Corners& Pilot::corners(const Setting& setting) {
    for (const auto& corners : corners_)
        if (corners->setting == setting) return *corners;
    std::vector<PixelPlace> places;
    const int n = setting.samples;
    for (const PixelPlace& pixel : pixels_)
        for (const int j : {0, n - 1})
            for (const int i : {0, n - 1}) places.push_back({n * pixel.x + i, n * pixel.y + j});
    auto corners = std::make_unique<Corners>(Corners{setting, {}, {}, 0});
    const double before = spent_;
    const std::vector<glm::dvec3> colors = samples(setting, n, places);
    corners->rays = (spent_ - before) / static_cast<double>(pixels_.size());
    for (std::size_t i = 0; i < colors.size(); i += 4) {
        glm::dvec3 sum(0), low(1), high(0);
        for (const glm::dvec3& color : std::span(colors).subspan(i, 4)) {
            sum += color;
            low = glm::min(low, color);
            high = glm::max(high, color);
        }
        const glm::dvec3 spread = glm::clamp(high, 0.0, 1.0) - glm::clamp(low, 0.0, 1.0);
        corners->means.push_back(sum / 4.0);
        corners->spreads.push_back(std::max({spread.x, spread.y, spread.z}));
    }
    corners_.push_back(std::move(corners));
    return *corners_.back();
}

// A sample is the centre of a pixel of a picture that is so many times as large.
std::vector<glm::dvec3> Pilot::samples(Setting setting, int scale, std::span<const PixelPlace> places) {
    setting.samples = 1;
    RenderOptions options = withSetting(options_, setting);
    options.size = {scale * options_.size.width, scale * options_.size.height};
    std::vector<glm::dvec3> colors(places.size());
    spent_ += rayCount(renderer_.renderPixels(options, places, colors));
    return colors;
}

PictureError Pilot::error(const Setting& setting, const Setting& truth) {
    return pictureError(take(setting).colors, take(truth).colors);
}

MeanSquare Pilot::squaredError(const Setting& setting, const Setting& truth) {
    const auto& colors = take(truth).colors;
    return meanSquare(take(setting).colors, colors, colors);
}

MeanSquare Pilot::squaredError(const Setting& setting) { return meanSquare(take(setting).colors, truths_[0], truths_[1]); }

void Pilot::sampleTruth(const Setting& depth, int n) {
    if (truthSamples_ >= n * n) return;
    const int cells = n * n, scale = n * placesOfCell;
    std::vector<PixelPlace> places(pixels_.size() * static_cast<std::size_t>(cells));
    for (std::uint32_t twin = 0; twin < 2; ++twin) {
        auto place = places.begin();
        for (const PixelPlace& pixel : pixels_)
            for (int j = 0; j < n; ++j)
                for (int i = 0; i < n; ++i) {
                    const int x = scale * pixel.x + placesOfCell * i, y = scale * pixel.y + placesOfCell * j;
                    *place++ = pixelIn({x, y, x + placesOfCell, y + placesOfCell},
                                       hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), twin));
                }
        const std::vector<glm::dvec3> colors = samples(depth, scale, places);
        truths_[twin].resize(pixels_.size(), glm::dvec3(0));
        auto color = colors.begin();
        for (glm::dvec3& truth : truths_[twin]) {
            truth *= truthSamples_;
            for (int i = 0; i < cells; ++i) truth += *color++;
            truth /= truthSamples_ + cells;
        }
    }
    truthSamples_ += cells;
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
