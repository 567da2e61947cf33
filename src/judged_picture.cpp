#include "raytracer/judged_picture.h"

#include <cmath>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raytracer/stratified_pilot.h"

namespace raytracer {

namespace {

constexpr int truthSamples = 2;   // n x n: the truth may be noisy, as long as it is not the larger part of the differences

// How far each pixel is from the next ones, in both directions.
std::vector<double> changes(std::span<const glm::dvec3> colors, const PixelRectangle& crop) {
    const auto width = static_cast<std::size_t>(crop.width()), count = colors.size();
    std::vector<double> sums(count, 0);
    std::vector<glm::dvec3> above(width), shown(width);
    for (std::size_t row = 0; row < count; row += width, shown.swap(above))
        for (std::size_t x = 0, i = row; x < width; ++x, ++i) {
            shown[x] = glm::clamp(colors[i], 0.0, 1.0);
            const auto compare = [&](const glm::dvec3& other, std::size_t at) {
                const glm::dvec3 difference = shown[x] - other;
                const double squared = glm::dot(difference, difference);
                sums[i] += squared, sums[at] += squared;
            };
            if (x > 0) compare(shown[x - 1], i - 1);
            if (row > 0) compare(above[x], i - width);
        }
    for (double& sum : sums) sum = std::sqrt(sum);
    return sums;
}

// Pixels, their colours, and what each one's squared error counts for in the mean.
struct Chosen {
    std::vector<PixelPlace> pixels;
    std::vector<glm::dvec3> colors;
    std::vector<double> weights;
};

// In steps of equal size through the picture, row by row (systematic sampling with probability proportional to size; Madow
// 1949): a large pixel may be chosen more than once.
Chosen choose(std::span<const glm::dvec3> colors, std::span<const double> sizes, const PixelRectangle& crop, double count) {
    const double total = std::accumulate(sizes.begin(), sizes.end(), 0.0), step = total / count;
    const auto width = static_cast<std::size_t>(crop.width());
    const double all = static_cast<double>(sizes.size());
    Chosen chosen;
    double sum = 0, next = step / 2;
    for (std::size_t i = 0; i < sizes.size(); ++i)
        for (sum += sizes[i]; sum > next; next += step) {
            chosen.pixels.push_back({crop.x0 + static_cast<int>(i % width), crop.y0 + static_cast<int>(i / width)});
            chosen.colors.push_back(colors[i]);
            chosen.weights.push_back(total / (sizes[i] * all));
        }
    return chosen;
}

}  // namespace

JudgedPicture renderJudged(const Renderer& renderer, const RenderOptions& options, const Setting& setting,
                           double judgedPixels) {
    JudgedPicture picture{setting, {}, {}, {}, 0, 0};
    ColorSink sink(options.crop);
    picture.counts = renderer.render(withSetting(options, setting), sink);
    picture.colors = std::move(sink).colors();
    std::vector<double> sizes = changes(picture.colors, options.crop);
    const double even = evenSize(sizes);
    for (double& size : sizes) size += even;
    const Chosen chosen = choose(picture.colors, sizes, options.crop, judgedPixels);
    Pilot pilot(renderer, options, chosen.pixels);
    pilot.sampleTruth(setting, truthSamples);
    // Hansen and Hurwitz 1943: the mean of what each one tells of the whole.
    std::vector<double> estimates = pilot.squaredErrors(chosen.colors);
    for (std::size_t i = 0; i < estimates.size(); ++i) estimates[i] *= chosen.weights[i];
    picture.error = rootOf(meanOf(estimates));
    picture.judgedPixels = chosen.pixels.size();
    picture.judgingRays = pilot.raysSpent();
    return picture;
}

}  // namespace raytracer
