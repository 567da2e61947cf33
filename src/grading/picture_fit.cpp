#include "picture_fit.h"

#include <algorithm>
#include <random>

namespace raytracer {

namespace {

const std::uint8_t* at(const ByteImage& image, std::size_t pixel) { return &image.pixels[3 * pixel]; }

// Some of them, the same on every machine.
std::vector<std::size_t> someOf(std::vector<std::size_t> all, std::size_t count) {
    std::mt19937 bits(1);
    count = std::min(count, all.size());
    for (std::size_t i = 0; i < count; ++i) std::swap(all[i], all[i + bits() % (all.size() - i)]);
    all.resize(count);
    std::ranges::sort(all);  // neighbours are faster
    return all;
}

// An equal pixel counts 1. One that is off by 1 is rounding, unless all are.
double likeness(const std::uint8_t* picture, const std::uint8_t* right, const Rgb& variant) {
    constexpr double offByOne = 0.8;
    const int off = largestDifference(picture, variant.data());
    if (off == 0) return 1;
    return off == 1 && largestDifference(picture, right) > 2 ? offByOne : 0;
}

}  // namespace

SplitPixels::SplitPixels(const ByteImage& picture, const ByteImage& right) {
    std::vector<std::size_t> offByOne;
    const std::size_t count = picture.pixels.size() / 3;
    for (std::size_t i = 0; i < count; ++i) {
        const int off = largestDifference(at(picture, i), at(right, i));
        differing += off != 0;
        (off == 0 ? rightPixels : off == 1 ? offByOne : wrongPixels).push_back(i);
    }
    constexpr double rounding = 0.05;  // of the pixels: above what float does
    if (static_cast<double>(offByOne.size()) < rounding * static_cast<double>(count)) return;
    wrongPixels.insert(wrongPixels.end(), offByOne.begin(), offByOne.end());
}

Sample::Sample(const SplitPixels& split, std::size_t wrong, std::size_t right, int width)
    : numbers(someOf(split.wrongPixels, wrong)), wrongCount(numbers.size()) {
    const auto rights = someOf(split.rightPixels, right);
    numbers.insert(numbers.end(), rights.begin(), rights.end());
    for (const std::size_t i : numbers) {
        const int number = static_cast<int>(i);
        pixels.push_back({number % width, number / width});
    }
    rightsOfWrong = static_cast<double>(split.rightPixels.size()) /
                    static_cast<double>(std::max<std::size_t>(1, split.wrongPixels.size()));
}

Fit fitOfSome(const ByteImage& picture, const ByteImage& right, Sample& sample, Variant& variant) {
    const auto bytes = variant.bytes(sample.pixels, sample.trees);
    double wrong = 0, explained = 0, rights = 0, contradicted = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (!bytes[i]) continue;
        const std::uint8_t* pixel = at(picture, sample.numbers[i]);
        (i < sample.wrongCount ? wrong : rights) += 1;
        if (i < sample.wrongCount) explained += likeness(pixel, at(right, sample.numbers[i]), *bytes[i]);
        else contradicted += largestDifference(pixel, bytes[i]->data()) > 1;
    }
    constexpr double leastKnown = 0.25;  // of the wrong pixels
    if (wrong < leastKnown * static_cast<double>(sample.wrongCount)) return {};
    const auto unknown =
        static_cast<std::size_t>(std::ranges::count_if(bytes, [](const auto& pixel) { return !pixel; }));
    return {explained / wrong, rights > 0 ? contradicted / rights * sample.rightsOfWrong : 0,
            bytes.size() - unknown, unknown};
}

Fit fitOfAll(const ByteImage& picture, const ByteImage& right, const SplitPixels& split, Variant& variant) {
    const ByteImage whole = variant.picture();
    double explained = 0, contradicted = 0;
    for (const std::size_t i : split.wrongPixels) {
        const std::uint8_t* made = at(whole, i);
        explained += likeness(at(picture, i), at(right, i), {made[0], made[1], made[2]});
    }
    for (const std::size_t i : split.rightPixels)
        contradicted += largestDifference(at(picture, i), at(whole, i)) > 1;
    std::uint64_t off = 0;
    for (std::size_t i = 0; i < whole.pixels.size() / 3; ++i)
        off += largestDifference(at(picture, i), at(whole, i)) != 0;
    const auto wrong = static_cast<double>(split.wrongPixels.size());
    return {explained / wrong, contradicted / wrong, whole.pixels.size() / 3, 0, off};
}

SplitPixels unexplainedBy(Variant& variant, const ByteImage& picture, const ByteImage& right,
                          const SplitPixels& split) {
    Sample dense(split, 4000, 0, picture.width);
    const auto bytes = variant.bytes(dense.pixels, dense.trees);
    SplitPixels left = split;
    left.wrongPixels.clear();
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t pixel = dense.numbers[i];
        if (bytes[i] && likeness(at(picture, pixel), at(right, pixel), *bytes[i]) < 1)
            left.wrongPixels.push_back(pixel);
    }
    return left;
}

}  // namespace raytracer
