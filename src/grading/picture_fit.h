// Compares pixels of a picture with those that a mistake makes.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "raytracer/grading/diagnosis.h"
#include "raytracer/pictures/image.h"
#include "variant.h"

namespace raytracer {

// The pixels of a picture that are wrong, and those that are right, as numbers in reading order. If the
// pixels that differ by only 1 are few, they are taken for rounding, and are neither.
struct SplitPixels {
    SplitPixels(const ByteImage& picture, const ByteImage& right);

    std::size_t differing = 0;
    std::vector<std::size_t> wrongPixels, rightPixels;
};

// A sample of pixels to compare variants with.
struct Sample {
    // Chooses at most `wrong` wrong pixels and `right` right
    // ones, the same on every machine. `width` is the picture's.
    Sample(const SplitPixels& split, std::size_t wrong, std::size_t right, int width);
    Sample(std::span<const std::size_t> wrongPixels, std::span<const std::size_t> rightPixels,
           std::size_t wrong, std::size_t right, int width);

    std::vector<std::size_t> numbers;
    std::size_t wrongCount;  // the first ones are wrong
    double rightsOfWrong;    // right pixels per wrong one in the whole picture
    Pixels pixels;
    Trees trees;  // of the scene without a mistake; see Variant::bytes
};

// The fit measured on the sample. With `anyRounding`, a pixel
// may also be as in one of the variant's other roundings.
Fit fitOfSome(const ByteImage& picture, const ByteImage& right, Sample& sample, Variant& variant,
              bool anyRounding = false);

// The fit measured on all pixels, with any rounding.
Fit fitOfAll(const ByteImage& picture, const ByteImage& right, const SplitPixels& split, Variant& variant);

// Some of the wrong pixels that the variant does not explain, or for which its bytes are not known.
std::vector<std::size_t> unexplainedBy(Variant& variant, const ByteImage& picture, const ByteImage& right,
                                       const SplitPixels& split);

}  // namespace raytracer
