#include "raytracer/accuracy/pilot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "raytracer/tracer/packet_order.h"
#include "raytracer/tracer/sample_grid.h"

namespace raytracer {

namespace {

// A hash of 32 bits: the finaliser of MurmurHash3 (Appleby), over the sum of odd multiples of the inputs.
std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
    std::uint32_t h = x * 0x9e3779b1u + y * 0x85ebca77u + seed * 0xc2b2ae3du + 1;
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return h ^ h >> 16;
}

constexpr int placesOfCell = 16;  // possible places of a jittered sample in its cell, along an axis

// Whether all samples of a pixel are taken.
bool isActive(const ColorSpread<double>& corners, const Setting& setting) {
    return setting.adaptive == 0 || corners.largest() > setting.adaptive;
}

// A pseudo-random pixel of a cell.
PixelPlace pixelIn(const PixelRectangle& cell, std::uint32_t random) {
    const auto width = static_cast<std::uint32_t>(cell.width()),
               height = static_cast<std::uint32_t>(cell.height());
    return {cell.x0 + static_cast<int>(random % width), cell.y0 + static_cast<int>(random / width % height)};
}

}  // namespace

std::vector<PixelPlace> scatteredPixels(const PixelRectangle& crop, std::size_t count, std::uint32_t seed) {
    const double edge = std::max(1.0, std::sqrt(crop.area() / static_cast<double>(count)));
    const int columns = static_cast<int>(std::ceil(crop.width() / edge)),
              rows = static_cast<int>(std::ceil(crop.height() / edge));
    std::vector<PixelPlace> pixels;
    forEachInPacketOrder({0, 0, columns, rows}, [&](int column, int row) {
        const PixelRectangle cell{
            crop.x0 + crop.width() * column / columns, crop.y0 + crop.height() * row / rows,
            crop.x0 + crop.width() * (column + 1) / columns, crop.y0 + crop.height() * (row + 1) / rows};
        pixels.push_back(
            pixelIn(cell, hash(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row), seed)));
    });
    return pixels;
}

struct Pilot::Grid {
    struct Pixel {
        glm::dvec3 corners{0}, others{0};  // sums of samples
        ColorSpread<double> spread;        // of the corners
        bool isWhole = false;              // `others` is complete

        void addCorner(const glm::dvec3& color) {
            corners += color;
            spread.add(color);
        }
    };
    Setting setting;
    std::vector<Pixel> pixels;
    double cornerRays = 0, otherRays = 0;  // of all pixels; of whole pixels

    SampleGrid rule() const { return {setting.samples}; }
    double samples() const { return rule().count(); }
    double corners() const { return rule().cornerCount(); }
};

Pilot::Pilot(const Renderer& renderer, const RenderOptions& options, std::vector<PixelPlace> pixels)
    : renderer_(renderer), options_(options), pixels_(std::move(pixels)) {}

Pilot::~Pilot() = default;

const std::vector<glm::dvec3>& Pilot::colors(const Setting& setting) {
    for (const auto& picture : pictures_)
        if (picture->setting == setting) return picture->colors;
    Grid& grid = gridOf(setting);
    std::vector<std::size_t> lacking;
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        if (isActive(grid.pixels[i].spread, setting) && !grid.pixels[i].isWhole) lacking.push_back(i);
    addSamples(grid, lacking, false, true);
    auto picture = std::make_unique<Picture>(Picture{setting, {}});
    for (const Grid::Pixel& pixel : grid.pixels)
        picture->colors.push_back(isActive(pixel.spread, setting)
                                      ? (pixel.corners + pixel.others) / grid.samples()
                                      : pixel.corners / grid.corners());
    pictures_.push_back(std::move(picture));
    return pictures_.back()->colors;
}

double Pilot::rays(const Setting& setting) {
    const Grid& grid = gridOf(setting);
    double active = 0, whole = 0;  // pixels
    for (const Grid::Pixel& pixel : grid.pixels) {
        active += isActive(pixel.spread, setting);
        whole += pixel.isWhole;
    }
    const auto count = static_cast<double>(pixels_.size());
    const double others =
        whole > 0 ? grid.otherRays / whole : grid.cornerRays / count * (grid.samples() - grid.corners()) / 4;
    return (grid.cornerRays + active * others) / count;
}

Pilot::Grid& Pilot::gridOf(Setting setting) {
    const bool isWhole = setting.adaptive == 0;
    setting.adaptive = 0;
    for (const auto& grid : grids_)
        if (grid->setting == setting) return *grid;
    grids_.push_back(std::make_unique<Grid>(Grid{setting, std::vector<Grid::Pixel>(pixels_.size())}));
    std::vector<std::size_t> all(pixels_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    addSamples(*grids_.back(), all, true, isWhole);
    return *grids_.back();
}

void Pilot::addSamples(Grid& grid, std::span<const std::size_t> pixels, bool corners, bool others) {
    const SampleGrid rule = grid.rule();
    std::vector<PixelPlace> places;
    for (const std::size_t pixel : pixels) {
        const PixelPlace first{rule.n * pixels_[pixel].x, rule.n * pixels_[pixel].y};
        const auto add = [&](int i, int j) { places.push_back({first.x + i, first.y + j}); };
        if (corners) rule.forEachCorner(add);
        if (others) rule.forEachOther(add);
    }
    const double before = spent_;
    const std::vector<glm::dvec3> colors = samples(grid.setting, rule.n, places);
    auto color = colors.begin();
    for (const std::size_t pixel : pixels) {
        Grid::Pixel& sums = grid.pixels[pixel];
        if (corners) rule.forEachCorner([&](int, int) { sums.addCorner(*color++); });
        if (others) rule.forEachOther([&](int, int) { sums.others += *color++; });
        sums.isWhole |= others;
    }
    const double rays = spent_ - before;
    const double cornerPart = !corners ? 0 : others ? grid.corners() / grid.samples() : 1;
    grid.cornerRays += cornerPart * rays;
    grid.otherRays += (1 - cornerPart) * rays;
}

// A sample is the centre of a pixel of a picture `scale` times as large.
std::vector<glm::dvec3> Pilot::samples(Setting setting, int scale, std::span<const PixelPlace> places) {
    setting.samples = 1;
    RenderOptions options = withSetting(options_, setting);
    options.size = {scale * options_.size.width, scale * options_.size.height};
    std::vector<glm::dvec3> colors(places.size());
    spent_ += rayCount(renderer_.renderPixels(options, places, colors));
    return colors;
}

PictureError Pilot::error(const Setting& setting, const Setting& truth) {
    return pictureError(colors(setting), colors(truth));
}

MeanSquare Pilot::squaredError(const Setting& setting, const Setting& truth) {
    const auto& colors = this->colors(truth);
    return meanOf(raytracer::squaredErrors(this->colors(setting), colors, colors));
}

std::vector<double> Pilot::squaredErrors(std::span<const glm::dvec3> colors) const {
    return raytracer::squaredErrors(colors, truths_[0], truths_[1]);
}

MeanSquare Pilot::squaredError(const Setting& setting) { return meanOf(squaredErrors(colors(setting))); }

MeanSquare Pilot::squaredErrorOfShallow(const Setting& setting, const Setting& deep) {
    const auto someOf = [&](Setting depth) -> const auto& {
        depth.samples = std::min(depth.samples, 2);
        depth.adaptive = 0;
        return colors(depth);
    };
    const auto &with = someOf(deep), &without = someOf(setting);
    std::vector<glm::dvec3> colors = this->colors(deep);
    for (std::size_t i = 0; i < colors.size(); ++i) colors[i] += without[i] - with[i];
    return meanOf(squaredErrors(colors));
}

MeanSquare Pilot::squaredErrorOfFlat(const Setting& setting) {
    const Grid& grid = gridOf(setting);
    std::vector<glm::dvec3> colors = truths_[0];
    for (std::size_t i = 0; i < colors.size(); ++i)
        if (!isActive(grid.pixels[i].spread, setting)) colors[i] = grid.pixels[i].corners / grid.corners();
    return meanOf(squaredErrors(colors));
}

void Pilot::sampleTruth(const Setting& depth, int n) {
    if (truthSamples_ >= n * n) return;
    n = static_cast<int>(std::ceil(std::sqrt(n * n - truthSamples_)));  // the samples still missing
    const int cells = n * n, scale = n * placesOfCell;
    std::vector<PixelPlace> places;  // of both estimates in turn, so that neighbours share packets
    for (const PixelPlace& pixel : pixels_)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const int x = scale * pixel.x + placesOfCell * i, y = scale * pixel.y + placesOfCell * j;
                for (int twin = 0; twin < 2; ++twin) {
                    const auto seed = static_cast<std::uint32_t>(2 * truthSamples_ + twin);
                    places.push_back(
                        pixelIn({x, y, x + placesOfCell, y + placesOfCell},
                                hash(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), seed)));
                }
            }
    const std::vector<glm::dvec3> colors = samples(depth, scale, places);
    auto color = colors.begin();
    for (auto& truth : truths_) truth.resize(pixels_.size(), glm::dvec3(0));
    for (std::size_t pixel = 0; pixel < pixels_.size(); ++pixel) {
        for (auto& truth : truths_) truth[pixel] *= truthSamples_;
        for (int i = 0; i < cells; ++i)
            for (auto& truth : truths_) truth[pixel] += *color++;
        for (auto& truth : truths_) truth[pixel] /= truthSamples_ + cells;
    }
    truthSamples_ += cells;
}

std::vector<DepthChoice> depthFront(const MeasureDepth& measure, int deepest, std::span<const double> cutoffs,
                                    double enough) {
    std::vector<DepthChoice> choices;
    // Per cutoff the error at the depth before; 0 if that was deep enough, or deeper than it helps. 2 is more
    // than any error.
    std::vector<double> before(cutoffs.size(), 2);
    for (const int depth : gridDepths) {
        if (depth > deepest) break;
        for (std::size_t i = 0; i < cutoffs.size(); ++i) {
            if (before[i] == 0 || (depth == 0 && i > 0)) continue;
            choices.push_back(measure(depth, cutoffs[i]));
            const double error = choices.back().error;
            before[i] = error <= enough || (depth > 1 && error > 0.99 * before[i]) ? 0 : error;
        }
    }
    std::vector<CostAndError> points;
    for (const DepthChoice& choice : choices) points.push_back({choice.rays, choice.error});
    std::vector<DepthChoice> front;
    for (const std::size_t i : paretoFront(points)) front.push_back(choices[i]);
    return front;
}

}  // namespace raytracer
