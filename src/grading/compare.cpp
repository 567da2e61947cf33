#include "raytracer/grading/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <tuple>

#include "raytracer/pictures/picture.h"
#include "raytracer/util/error.h"
#include "raytracer/util/memory.h"

namespace raytracer {

namespace {

double sampleDifference(std::uint8_t a, std::uint8_t b) { return std::abs(int{a} - int{b}); }

double sampleDifference(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
    const double difference = std::abs(static_cast<double>(a) - static_cast<double>(b));
    return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

// The sums over all samples, and the worst pixel.
struct Totals {
    double sum = 0, sumOfSquares = 0;  // for bytes these are integers, exact up to 2^53
    double worstMaximum = 0, worstSum = 0;
    std::size_t worstPixel = 0;

    void add(const double (&difference)[3], std::size_t pixel) {
        const double pixelSum = difference[0] + difference[1] + difference[2];
        const double pixelMaximum = std::max({difference[0], difference[1], difference[2]});
        sum += pixelSum;
        for (const double d : difference) sumOfSquares += d * d;
        if (std::tie(pixelMaximum, pixelSum) <= std::tie(worstMaximum, worstSum)) return;
        worstMaximum = pixelMaximum;
        worstSum = pixelSum;
        worstPixel = pixel;
    }
};

template <class Image>
Totals totalsOf(const Image& a, const Image& b) {
    Totals totals;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        double difference[3];
        for (std::size_t c = 0; c < 3; ++c)
            difference[c] = sampleDifference(a.pixels[i + c], b.pixels[i + c]);
        totals.add(difference, i / 3);
    }
    return totals;
}

void countDifferences(Comparison& comparison, const ByteImage& a, const ByteImage& b, const NanPlaces& nans) {
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        const bool isNan = !nans.empty() && nans[i / 3] == NanAt::OneOnly;
        const int difference = isNan ? 255 : largestDifference(&a.pixels[i], &b.pixels[i]);
        ++comparison.pixelsByDifference[static_cast<std::size_t>(difference)];
    }
}

void requireMemoryToCompare(const ImageSize& size, std::size_t bytesOfPixel) {
    requireMemory({}, "the comparison of " + pixelsInWords(size.width, size.height),
                  static_cast<double>(bytesOfPixel * size.area()));
}

// Compares two pictures. samplesA and samplesB are their samples; a and b are the same pictures as bytes.
template <class Image>
Comparison compareAs(const Image& samplesA, const Image& samplesB, const ByteImage& a, const ByteImage& b,
                     double peak, const NanPlaces& nans = {}) {
    requireMemoryToCompare(a, 6);  // both once more, in planes
    const Totals totals = totalsOf(samplesA, samplesB);
    const double samples = static_cast<double>(samplesA.pixels.size());
    Comparison result;
    static_cast<ImageSize&>(result) = a;
    result.peak = peak;
    result.mean = totals.sum / samples;
    result.rmse = std::sqrt(totals.sumOfSquares / samples);
    result.psnr = 20 * std::log10(peak / result.rmse);
    result.maximum = totals.worstMaximum;
    result.worstX = static_cast<int>(totals.worstPixel % static_cast<std::size_t>(a.width));
    result.worstY = static_cast<int>(totals.worstPixel / static_cast<std::size_t>(a.width));
    countDifferences(result, a, b, nans);
    result.score = neighbourhoodScore(a, b, nans);
    result.speckle = speckleCount(a, b);
    return result;
}

ByteImage quantised(const Picture& picture) {
    auto bytes = unsetImage<ByteImage>(sizeOf(picture));
    const auto* const floats = std::get_if<FloatImage>(&picture);
    const auto quantise = [](float channel) { return toByte(static_cast<double>(channel)); };
    if (floats) std::ranges::transform(floats->pixels, bytes.pixels.begin(), quantise);
    else std::ranges::copy(std::get<ByteImage>(picture).pixels, bytes.pixels.begin());
    return bytes;
}

bool isNan(const Picture& picture, std::size_t sample) {
    const auto* const floats = std::get_if<FloatImage>(&picture);
    return floats && std::isnan(floats->pixels[sample]);
}

bool hasNan(const Picture& picture) {
    const auto* const floats = std::get_if<FloatImage>(&picture);
    return floats && std::ranges::any_of(floats->pixels, [](float sample) { return std::isnan(sample); });
}

NanPlaces nanPlaces(const Picture& a, const Picture& b) {
    NanPlaces places;
    if (!hasNan(a) && !hasNan(b)) return places;
    places.resize(sizeOf(a).area());
    for (std::size_t i = 0; i < 3 * places.size(); ++i)
        if (const bool inA = isNan(a, i), inB = isNan(b, i); inA || inB)
            places[i / 3] = std::max(places[i / 3], inA && inB ? NanAt::SameInBoth : NanAt::OneOnly);
    return places;
}

}  // namespace

std::uint64_t Comparison::pixelsOver(int tolerance) const {
    const auto first = pixelsByDifference.begin() + std::clamp(tolerance + 1, 0, 256);
    return std::accumulate(first, pixelsByDifference.end(), std::uint64_t{0});
}

Picture readPicture(const std::string& path) {
    const FileBytes file(path);
    if (isPfm(file)) return readPfm(file);
    return readImage(file);
}

ImageSize sizeOf(const Picture& picture) {
    return std::visit([](const ImageSize& size) { return size; }, picture);
}

ByteImage toBytes(const Picture& picture, const Picture& other) {
    ByteImage bytes = quantised(picture);
    if (std::holds_alternative<ByteImage>(picture)) return bytes;
    const ByteImage others = quantised(other);
    for (std::size_t i = 0; i < bytes.pixels.size(); ++i)
        if (isNan(picture, i) && !isNan(other, i)) bytes.pixels[i] = others.pixels[i] < 128 ? 255 : 0;
    return bytes;
}

void requireSameSize(const ImageSize& a, const ImageSize& b) {
    if (a != b) throw Error("the pictures' sizes differ: " + inWords(a) + " and " + inWords(b));
}

Comparison compareImages(const ByteImage& a, const ByteImage& b) {
    requireSameSize(a, b);
    return compareAs(a, b, a, b, 255);
}

Comparison compareImages(const Picture& a, const Picture& b) {
    requireSameSize(sizeOf(a), sizeOf(b));
    requireMemoryToCompare(sizeOf(a), 13);  // the bytes of both, where NaN is, and compareAs
    const ByteImage bytesA = toBytes(a, b), bytesB = toBytes(b, a);
    const NanPlaces nans = nanPlaces(a, b);
    const auto* floatsA = std::get_if<FloatImage>(&a);
    const auto* floatsB = std::get_if<FloatImage>(&b);
    if (floatsA && floatsB) return compareAs(*floatsA, *floatsB, bytesA, bytesB, 1, nans);
    return compareAs(bytesA, bytesB, bytesA, bytesB, 255, nans);
}

ByteImage amplifiedDifference(const ByteImage& a, const ByteImage& b) {
    requireSameSize(a, b);
    // 64 can be told from black on any screen. With 8 per level, 255 is reached at a difference of 24.
    constexpr int base = 64, gain = 8;
    const auto amplified = [](int channelA, int channelB) {
        const int difference = std::abs(channelA - channelB);
        return static_cast<std::uint8_t>(difference ? std::min(255, base + gain * difference) : 0);
    };
    auto result = unsetImage<ByteImage>(a);
    std::ranges::transform(a.pixels, b.pixels, result.pixels.begin(), amplified);
    return result;
}

bool within(const Comparison& comparison, const Thresholds& thresholds) {
    if (thresholds.minScore && comparison.score < *thresholds.minScore) return false;
    const bool scoreAlone = thresholds.minScore && !thresholds.maxPixels && !thresholds.tolerance;
    return scoreAlone ||
           comparison.pixelsOver(thresholds.tolerance.value_or(0)) <= thresholds.maxPixels.value_or(0);
}

}  // namespace raytracer
