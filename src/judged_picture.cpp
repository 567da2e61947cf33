#include "raytracer/judged_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "raytracer/stratified_pilot.h"

namespace raytracer {

namespace {

constexpr int truthSamples = 2;  // n x n: the truth may be noisy, as long as it is not the larger part of the differences

// A row of the picture as shown, three floats a pixel.
void show(std::span<const glm::dvec3> colors, std::vector<float>& row) {
    row.resize(3 * colors.size());
    float* channel = row.data();
    for (const glm::dvec3& color : colors)
        for (int i = 0; i < 3; ++i) *channel++ = static_cast<float>(color[i]);
    for (float& value : row) value = std::min(std::max(value, 0.0f), 1.0f);
}

// Squared, of as many pixels from others.
void findDistances(const float* a, const float* b, std::span<float> distances) {
    for (std::size_t i = 0; i < distances.size(); ++i) {
        const float red = a[3 * i] - b[3 * i], green = a[3 * i + 1] - b[3 * i + 1], blue = a[3 * i + 2] - b[3 * i + 2];
        distances[i] = red * red + green * green + blue * blue;
    }
}

void add(std::span<const float> values, float* sums) {
    for (std::size_t i = 0; i < values.size(); ++i) sums[i] += values[i];
}

// How far each pixel is from the next ones, in both directions.
std::vector<float> changes(std::span<const glm::dvec3> colors, const PixelRectangle& crop) {
    const auto width = static_cast<std::size_t>(crop.width()), count = colors.size();
    std::vector<float> sums(count, 0.0f), distances(width);
    std::vector<float> shown, above;
    for (std::size_t row = 0; row < count; row += width, std::swap(shown, above)) {
        show(colors.subspan(row, width), shown);
        const std::span<float> beside = std::span(distances).first(width - 1);
        findDistances(shown.data() + 3, shown.data(), beside);
        add(beside, &sums[row]);
        add(beside, &sums[row] + 1);
        if (row == 0) continue;
        findDistances(shown.data(), above.data(), distances);
        add(distances, &sums[row - width]);
        add(distances, &sums[row]);
    }
    for (float& sum : sums) sum = std::sqrt(sum);
    return sums;
}

// Pixels, their colours, and what each one's squared error counts for in the mean.
struct Chosen {
    std::vector<PixelPlace> pixels;
    std::vector<glm::dvec3> colors;
    std::vector<double> weights;
};

double sumOf(std::span<const float> values) { return std::reduce(values.begin(), values.end(), 0.0); }

constexpr std::size_t block = 16;              // of so many pixels most have none chosen
constexpr std::size_t parts[] = {0, 2, 1, 3};  // in which they are judged: of every four the first, then the third, ...

// In steps of equal size through the picture, row by row (systematic sampling with probability proportional to size; Madow
// 1949): a large pixel may be chosen more than once.
std::vector<Chosen> choose(std::span<const glm::dvec3> colors, std::span<const float> changes, const PixelRectangle& crop,
                           double count) {
    const double all = crop.area(), changed = sumOf(changes);
    const double even = evenSize(changed, all), total = changed + even * all, step = total / count;
    const auto width = static_cast<std::size_t>(crop.width());
    std::vector<Chosen> chosen(std::size(parts));
    double sum = 0, next = step / 2;
    std::size_t number = 0;
    for (std::size_t begin = 0, end = 0; begin < changes.size(); begin = end) {
        end = std::min(begin + block, changes.size());
        double size = sum;
        sum += sumOf(changes.subspan(begin, end - begin)) + even * static_cast<double>(end - begin);
        for (std::size_t i = begin; next < sum && i < end; ++i) {
            const double own = static_cast<double>(changes[i]) + even;
            for (size += own; size > next; next += step) {
                Chosen& part = chosen[number++ % chosen.size()];
                part.pixels.push_back({crop.x0 + static_cast<int>(i % width), crop.y0 + static_cast<int>(i / width)});
                part.colors.push_back(colors[i]);
                part.weights.push_back(total / (own * all));
            }
        }
    }
    return chosen;
}

}  // namespace

JudgedPicture renderJudged(const Renderer& renderer, const RenderOptions& options, const Setting& setting, double judgedPixels,
                           const std::function<bool(const ErrorEstimate&)>& isClear) {
    JudgedPicture picture{setting, {}, {}, {}, 0, 0};
    ColorSink sink(options.crop);
    picture.counts = renderer.render(withSetting(options, setting), sink);
    picture.colors = std::move(sink).colors();
    const std::vector<Chosen> chosen =
        choose(picture.colors, changes(picture.colors, options.crop), options.crop, judgedPixels);
    std::vector<double> estimates;  // Hansen and Hurwitz 1943: the mean of what each one tells of the whole
    for (const std::size_t part : parts) {
        const auto& [pixels, colors, weights] = chosen[part];
        Pilot pilot(renderer, options, pixels);
        pilot.sampleTruth(setting, truthSamples);
        const std::vector<double> errors = pilot.squaredErrors(colors);
        for (std::size_t i = 0; i < errors.size(); ++i) estimates.push_back(weights[i] * errors[i]);
        picture.error = rootOf(meanOf(estimates));
        picture.judgedPixels += pixels.size();
        picture.judgingRays += pilot.raysSpent();
        if (isClear(picture.error)) break;
    }
    return picture;
}

}  // namespace raytracer
