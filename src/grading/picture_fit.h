// Pixels of a picture, held against those that a mistake makes.
#pragma once

#include <cstddef>
#include <vector>

#include "raytracer/grading/diagnosis.h"
#include "raytracer/pictures/image.h"
#include "variant.h"

namespace raytracer {

// The pixels of a picture that are wrong, and those that are right: numbers in reading order. Where few
// differ by 1 only, that is rounding, and neither.
struct SplitPixels {
    SplitPixels(const ByteImage& picture, const ByteImage& right);

    std::size_t differing = 0;
    std::vector<std::size_t> wrongPixels, rightPixels;
};

// Pixels to hold variants against.
struct Sample {
    // Some wrong pixels and some right ones, the same on every machine; `width` is the picture's.
    Sample(const SplitPixels& split, std::size_t wrong, std::size_t right, int width);

    std::vector<std::size_t> numbers;
    std::size_t wrongCount;  // the first ones
    double rightsOfWrong;    // in the whole picture
    Pixels pixels;
    Trees trees;  // of the scene without a mistake; see Variant::bytes
};

// By the pixels of the sample. With `anyRounding`, a pixel may be as one of the variant's other roundings.
Fit fitOfSome(const ByteImage& picture, const ByteImage& right, Sample& sample, Variant& variant,
              bool anyRounding = false);

// By all pixels, with any rounding.
Fit fitOfAll(const ByteImage& picture, const ByteImage& right, const SplitPixels& split, Variant& variant);

// Of some wrong pixels, those that the variant does not explain, or does not tell of.
SplitPixels unexplainedBy(Variant& variant, const ByteImage& picture, const ByteImage& right,
                          const SplitPixels& split);

}  // namespace raytracer
