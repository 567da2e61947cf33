#include "raytracer/accuracy/estimated_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "raytracer/accuracy/stratified_pilot.h"
#include "raytracer/tracer/packet_order.h"

namespace raytracer {

namespace {

// The truth has n x n samples: it may be noisy, as long as its noise is the smaller part of the differences.
constexpr int truthSamples = 2;

constexpr int parts = 4;  // of the picture, each a quarter of its blocks, evenly spread
constexpr int blockWidth = 8, blockHeight = 16;

struct Part {
    std::vector<PixelRectangle> blocks;
    std::vector<PixelPlace> pixels;  // block by block
};

void findPart(const PixelRectangle& crop, int number, Part& part) {
    part.blocks.clear();
    part.pixels.clear();
    part.pixels.reserve(static_cast<std::size_t>(crop.area()) / parts);
    for (int row = 0, y = crop.y0; y < crop.y1; ++row, y += blockHeight)
        for (int x = crop.x0 + (number + 2 * row) % parts * blockWidth; x < crop.x1; x += parts * blockWidth)
            part.blocks.push_back(
                {x, y, std::min(x + blockWidth, crop.x1), std::min(y + blockHeight, crop.y1)});
    for (const PixelRectangle& block : part.blocks)
        forEachInPacketOrder(block, [&](int x, int y) { part.pixels.push_back({x, y}); });
}

void write(const Part& part, std::span<const glm::dvec3> colors, PixelSink& sink) {
    auto color = colors.begin();
    for (const PixelRectangle& block : part.blocks) {
        glm::dvec3 rows[blockHeight][blockWidth];
        forEachInPacketOrder(block, [&](int x, int y) { rows[y - block.y0][x - block.x0] = *color++; });
        for (int y = block.y0; y < block.y1; ++y)
            sink.write(block.x0, y, {rows[y - block.y0], static_cast<std::size_t>(block.width())});
    }
}

float squared(float x) { return x * x; }

// The local contrast of each pixel of a part: its distance, clamped as shown, from its four neighbours in the
// same block.
std::vector<float> contrastOf(const Part& part, std::span<const glm::dvec3> colors) {
    std::vector<float> contrast;
    contrast.reserve(colors.size());
    auto color = colors.begin();
    for (const PixelRectangle& block : part.blocks) {
        float shown[3][blockHeight][blockWidth];
        forEachInPacketOrder(block, [&](int x, int y) {
            for (int i = 0; i < 3; ++i)
                shown[i][y - block.y0][x - block.x0] =
                    std::min(std::max(static_cast<float>((*color)[i]), 0.0f), 1.0f);
            ++color;
        });
        // Squared distances from the left and the upper neighbour.
        float beside[blockHeight][blockWidth + 1] = {}, above[blockHeight + 1][blockWidth] = {};
        for (const auto& channel : shown) {
            for (int y = 0; y < block.height(); ++y)
                for (int x = 1; x < block.width(); ++x)
                    beside[y][x] += squared(channel[y][x] - channel[y][x - 1]);
            for (int y = 1; y < block.height(); ++y)
                for (int x = 0; x < block.width(); ++x)
                    above[y][x] += squared(channel[y][x] - channel[y - 1][x]);
        }
        forEachInPacketOrder(block, [&](int x, int y) {
            x -= block.x0;
            y -= block.y0;
            contrast.push_back(std::sqrt(beside[y][x] + beside[y][x + 1] + above[y][x] + above[y + 1][x]));
        });
    }
    return contrast;
}

double sumOf(std::span<const float> values) { return std::reduce(values.begin(), values.end(), 0.0); }

// A pixel of a part, and the weight of its squared error in the part's mean.
struct Chosen {
    std::size_t pixel;
    double weight;
};

// Systematic sampling with probability proportional to size (Madow 1949), the size being the contrast plus a
// constant: in equal steps through the part. A pixel of high contrast may be chosen more than once.
std::vector<Chosen> choose(std::span<const float> contrast, double count) {
    constexpr std::size_t group = 16;  // pixels, skipped together: in most groups none is chosen
    const auto all = static_cast<double>(contrast.size());
    const double sumOfContrast = sumOf(contrast), even = evenContrast(sumOfContrast, all),
                 total = sumOfContrast + even * all, step = total / count;
    std::vector<Chosen> chosen;
    double sum = 0, next = step / 2;
    for (std::size_t begin = 0, end = 0; begin < contrast.size(); begin = end) {
        end = std::min(begin + group, contrast.size());
        double size = sum;
        sum += sumOf(contrast.subspan(begin, end - begin)) + even * static_cast<double>(end - begin);
        for (std::size_t i = begin; next < sum && i < end; ++i) {
            const double own = static_cast<double>(contrast[i]) + even;
            for (size += own; size > next; next += step) chosen.push_back({i, total / (own * all)});
        }
    }
    return chosen;
}

}  // namespace

EstimatedPicture renderEstimated(const Renderer& renderer, const RenderOptions& options,
                                 const Setting& setting, PixelSink& sink, double pixels,
                                 const std::function<Decision(const ErrorEstimate&)>& decide) {
    const PixelRectangle& crop = options.crop;
    EstimatedPicture picture{setting, {}, {}};
    std::vector<double> estimates;  // of the mean square, one a chosen pixel (Hansen and Hurwitz 1943)
    Decision decision = Decision::Continue;
    Part part;
    std::vector<glm::dvec3> colors;  // of the part
    for (int number = 0; number < parts; ++number) {
        findPart(crop, number, part);
        colors.resize(part.pixels.size());
        picture.counts += renderer.renderPixels(withSetting(options, setting), part.pixels, colors);
        write(part, colors, sink);
        if (decision == Decision::Accept) continue;

        const double share = static_cast<double>(colors.size()) / crop.area();
        const std::vector<Chosen> chosen = choose(contrastOf(part, colors), share * pixels);
        std::vector<PixelPlace> places;
        std::vector<glm::dvec3> chosenColors;
        for (const auto& [pixel, weight] : chosen) {
            places.push_back(part.pixels[pixel]);
            chosenColors.push_back(colors[pixel]);
        }
        Pilot pilot(renderer, options, places);
        pilot.sampleTruth(setting, truthSamples);
        const std::vector<double> errors = pilot.squaredErrors(chosenColors);
        for (std::size_t i = 0; i < errors.size(); ++i) estimates.push_back(chosen[i].weight * errors[i]);
        picture.error = rootOf(meanOf(estimates));
        picture.estimatedPixels += chosen.size();
        picture.estimationRays += pilot.raysSpent();
        decision = decide(picture.error);
        if (decision == Decision::Reject) return picture;
    }
    picture.isWhole = true;
    return picture;
}

}  // namespace raytracer
