#include "raytracer/accuracy/judged_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "raytracer/accuracy/stratified_pilot.h"
#include "raytracer/tracer/packet_order.h"

namespace raytracer {

namespace {

constexpr int truthSamples =
    2;  // n x n: the truth may be noisy, as long as it is not the larger part of the differences

constexpr int parts = 4;  // of the picture: each a quarter of its blocks, evenly spread
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

// How far each of a part's pixels is, as shown, from those beside, above and below it in its block.
std::vector<float> changesOf(const Part& part, std::span<const glm::dvec3> colors) {
    std::vector<float> changes;
    changes.reserve(colors.size());
    auto color = colors.begin();
    for (const PixelRectangle& block : part.blocks) {
        float shown[3][blockHeight][blockWidth];
        forEachInPacketOrder(block, [&](int x, int y) {
            for (int i = 0; i < 3; ++i)
                shown[i][y - block.y0][x - block.x0] =
                    std::min(std::max(static_cast<float>((*color)[i]), 0.0f), 1.0f);
            ++color;
        });
        float beside[blockHeight][blockWidth + 1] = {},
                                               above[blockHeight + 1][blockWidth] = {};  // squared distances
        for (const auto& channel : shown) {
            for (int y = 0; y < block.height(); ++y)
                for (int x = 1; x < block.width(); ++x)
                    beside[y][x] += squared(channel[y][x] - channel[y][x - 1]);
            for (int y = 1; y < block.height(); ++y)
                for (int x = 0; x < block.width(); ++x)
                    above[y][x] += squared(channel[y][x] - channel[y - 1][x]);
        }
        forEachInPacketOrder(block, [&](int x, int y) {
            x -= block.x0, y -= block.y0;
            changes.push_back(std::sqrt(beside[y][x] + beside[y][x + 1] + above[y][x] + above[y + 1][x]));
        });
    }
    return changes;
}

double sumOf(std::span<const float> values) { return std::reduce(values.begin(), values.end(), 0.0); }

// A pixel of a part, and what its squared error counts for in the part's mean.
struct Chosen {
    std::size_t pixel;
    double weight;
};

// In steps of equal size through the part (systematic sampling with probability proportional to size; Madow
// 1949): a large pixel may be chosen more than once.
std::vector<Chosen> choose(std::span<const float> changes, double count) {
    constexpr std::size_t group = 16;  // of so many pixels most have none chosen
    const auto all = static_cast<double>(changes.size());
    const double changed = sumOf(changes), even = evenSize(changed, all), total = changed + even * all,
                 step = total / count;
    std::vector<Chosen> chosen;
    double sum = 0, next = step / 2;
    for (std::size_t begin = 0, end = 0; begin < changes.size(); begin = end) {
        end = std::min(begin + group, changes.size());
        double size = sum;
        sum += sumOf(changes.subspan(begin, end - begin)) + even * static_cast<double>(end - begin);
        for (std::size_t i = begin; next < sum && i < end; ++i) {
            const double own = static_cast<double>(changes[i]) + even;
            for (size += own; size > next; next += step) chosen.push_back({i, total / (own * all)});
        }
    }
    return chosen;
}

}  // namespace

JudgedPicture renderJudged(const Renderer& renderer, const RenderOptions& options, const Setting& setting,
                           PixelSink& sink, double judgedPixels,
                           const std::function<Judgement(const ErrorEstimate&)>& judge) {
    const PixelRectangle& crop = options.crop;
    JudgedPicture picture{setting, {}, {}};
    std::vector<double> estimates;  // Hansen and Hurwitz 1943: the mean of what each one tells of the whole
    Judgement judgement = Judgement::Unclear;
    Part part;
    std::vector<glm::dvec3> colors;  // its
    for (int number = 0; number < parts; ++number) {
        findPart(crop, number, part);
        colors.resize(part.pixels.size());
        picture.counts += renderer.renderPixels(withSetting(options, setting), part.pixels, colors);
        write(part, colors, sink);
        if (judgement == Judgement::Enough) continue;

        const double share = static_cast<double>(colors.size()) / crop.area();
        const std::vector<Chosen> chosen = choose(changesOf(part, colors), share * judgedPixels);
        std::vector<PixelPlace> places;
        std::vector<glm::dvec3> judged;
        for (const auto& [pixel, weight] : chosen)
            places.push_back(part.pixels[pixel]), judged.push_back(colors[pixel]);
        Pilot pilot(renderer, options, places);
        pilot.sampleTruth(setting, truthSamples);
        const std::vector<double> errors = pilot.squaredErrors(judged);
        for (std::size_t i = 0; i < errors.size(); ++i) estimates.push_back(chosen[i].weight * errors[i]);
        picture.error = rootOf(meanOf(estimates));
        picture.judgedPixels += chosen.size();
        picture.judgingRays += pilot.raysSpent();
        judgement = judge(picture.error);
        if (judgement == Judgement::TooFar) return picture;
    }
    picture.isWhole = true;
    return picture;
}

}  // namespace raytracer
