#include "picture_fit.h"

#include <algorithm>
#include <map>
#include <random>
#include <utility>

namespace raytracer {

namespace {

const std::uint8_t* at(const ByteImage& image, std::size_t pixel) { return &image.pixels[3 * pixel]; }

// A random choice of `count` elements, the same on every machine: the first ones of a shuffle, of which only
// the moved elements are kept.
std::vector<std::size_t> someOf(std::span<const std::size_t> all, std::size_t count) {
    std::mt19937 bits(1);
    std::map<std::size_t, std::size_t> moved;  // by their new places
    const auto elementAt = [&](std::size_t place) {
        const auto found = moved.find(place);
        return found == moved.end() ? all[place] : found->second;
    };
    std::vector<std::size_t> some;
    for (std::size_t i = 0; i < std::min(count, all.size()); ++i) {
        const std::size_t place = i + bits() % (all.size() - i);
        some.push_back(elementAt(place));
        moved[place] = elementAt(i);
    }
    std::ranges::sort(some);  // neighbouring pixels are faster
    return some;
}

// A pixel of a picture, and its difference from the most similar of several colours.
class Likest {
  public:
    Likest(const std::uint8_t* picture, const std::uint8_t* right) : picture_(picture), right_(right) {}

    void add(const std::uint8_t* color) { off_ = std::min(off_, largestDifference(picture_, color)); }
    bool isKnown() const { return off_ <= 255; }
    bool isEqual() const { return off_ == 0; }
    bool isOff() const { return off_ > 1; }

    // 1 for an equal pixel. A difference of 1 is taken for
    // rounding, unless the right picture is as near (within 2).
    double likeness() const {
        constexpr double offByOne = 0.8;
        if (off_ == 0) return 1;
        return off_ == 1 && largestDifference(picture_, right_) > 2 ? offByOne : 0;
    }

  private:
    const std::uint8_t *picture_, *right_;
    int off_ = 256;
};

}  // namespace

// Counts first: lists that grow would hold twice as much.
SplitPixels::SplitPixels(const ByteImage& picture, const ByteImage& right) {
    const std::size_t count = picture.pixels.size() / 3;
    const auto offAt = [&](std::size_t i) { return largestDifference(at(picture, i), at(right, i)); };
    std::size_t offByOne = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const int off = offAt(i);
        differing += off != 0;
        offByOne += off == 1;
    }
    constexpr double rounding = 0.05;  // share of the pixels: more than float arithmetic causes
    const bool isRounded = static_cast<double>(offByOne) < rounding * static_cast<double>(count);
    rightPixels.reserve(count - differing);
    wrongPixels.reserve(isRounded ? differing - offByOne : differing);
    for (std::size_t i = 0; i < count; ++i) {
        const int off = offAt(i);
        if (off == 0) rightPixels.push_back(i);
        if (off > 1) wrongPixels.push_back(i);
    }
    for (std::size_t i = 0; i < count && !isRounded; ++i)
        if (offAt(i) == 1) wrongPixels.push_back(i);
}

Sample::Sample(const SplitPixels& split, std::size_t wrong, std::size_t right, int width)
    : Sample(split.wrongPixels, split.rightPixels, wrong, right, width) {}

Sample::Sample(std::span<const std::size_t> wrongPixels, std::span<const std::size_t> rightPixels,
               std::size_t wrong, std::size_t right, int width)
    : numbers(someOf(wrongPixels, wrong)), wrongCount(numbers.size()) {
    const auto rights = someOf(rightPixels, right);
    numbers.insert(numbers.end(), rights.begin(), rights.end());
    for (const std::size_t i : numbers) {
        const int number = static_cast<int>(i);
        pixels.push_back({number % width, number / width});
    }
    rightsOfWrong = static_cast<double>(rightPixels.size()) /
                    static_cast<double>(std::max<std::size_t>(1, wrongPixels.size()));
}

Fit fitOfSome(const ByteImage& picture, const ByteImage& right, Sample& sample, Variant& variant,
              bool anyRounding) {
    std::vector<std::vector<std::optional<Rgb>>> takes;
    takes.push_back(variant.bytes(sample.pixels, sample.trees));
    if (anyRounding && variant.isPicture())
        for (Variant& other : variant.otherRoundings())
            takes.push_back(other.bytes(sample.pixels, sample.trees));
    double wrong = 0, explained = 0, rights = 0, contradicted = 0;
    for (std::size_t i = 0; i < sample.pixels.size(); ++i) {
        const std::size_t number = sample.numbers[i];
        Likest likest(at(picture, number), at(right, number));
        for (const auto& bytes : takes)
            if (bytes[i]) likest.add(bytes[i]->data());
        if (!likest.isKnown()) continue;
        (i < sample.wrongCount ? wrong : rights) += 1;
        if (i < sample.wrongCount) explained += likest.likeness();
        else contradicted += likest.isOff();
    }
    constexpr double leastKnown = 0.25;  // share of the wrong pixels
    if (wrong < leastKnown * static_cast<double>(sample.wrongCount)) return {};
    const auto known = static_cast<std::size_t>(wrong + rights);
    return {explained / wrong, rights > 0 ? contradicted / rights * sample.rightsOfWrong : 0, known,
            sample.pixels.size() - known};
}

Fit fitOfAll(const ByteImage& picture, const ByteImage& right, const SplitPixels& split, Variant& variant) {
    std::vector<ByteImage> takes;
    const auto take = [&](Variant& one) {
        if (auto made = one.pictureIfAny()) takes.push_back(std::move(*made));
    };
    take(variant);
    if (takes.empty()) return {};
    if (takes.front().pixels != picture.pixels) std::ranges::for_each(variant.otherRoundings(), take);
    const auto likestOf = [&](std::size_t pixel) {
        Likest likest(at(picture, pixel), at(right, pixel));
        for (const ByteImage& made : takes) likest.add(at(made, pixel));
        return likest;
    };
    const std::size_t pixels = picture.pixels.size() / 3;
    std::uint64_t differing = 0, off = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        differing += largestDifference(at(picture, i), at(takes.front(), i)) > 0;
        off += !likestOf(i).isEqual();
    }
    double explained = 0, contradicted = 0;
    for (const std::size_t i : split.wrongPixels) explained += likestOf(i).likeness();
    for (const std::size_t i : split.rightPixels) contradicted += likestOf(i).isOff();
    const auto wrong = static_cast<double>(split.wrongPixels.size());
    return {explained / wrong, contradicted / wrong, pixels, 0, off, differing - off};
}

std::vector<std::size_t> unexplainedBy(Variant& variant, const ByteImage& picture, const ByteImage& right,
                                       const SplitPixels& split) {
    Sample dense(split, 4000, 0, picture.width);
    const auto bytes = variant.bytes(dense.pixels, dense.trees);
    std::vector<std::size_t> left;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const std::size_t pixel = dense.numbers[i];
        Likest likest(at(picture, pixel), at(right, pixel));
        if (bytes[i]) likest.add(bytes[i]->data());
        if (likest.likeness() < 1) left.push_back(pixel);
    }
    return left;
}

}  // namespace raytracer
