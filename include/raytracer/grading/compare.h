// How much two pictures of the same size differ: as numbers, as the course's score, and as a picture.
//
// Counts, score and speckle are of bytes, so that they mean the same for PNG and PFM: a float picture is
// clamped and quantised for them as it would be in a PNG. Mean, RMSE, PSNR and maximum are of the samples as
// they are in the file: bytes (0 to 255), or linear floats that may lie outside of [0, 1]. A PNG and a PFM
// are compared as bytes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "raytracer/pictures/image.h"

namespace raytracer {

using Picture = std::variant<ByteImage, FloatImage>;

// Floats from a name that ends in .pfm, else bytes. Throws ImageError, which here says the file's name too.
Picture readPicture(const std::string& path);
ByteImage toBytes(const Picture& picture);

struct Comparison {
    int width = 0, height = 0;

    // [d]: the pixels whose most different channel differs by d of 255.
    std::array<std::uint64_t, 256> pixelsByDifference{};

    // Over all samples. Equal samples differ by 0, two NaN too; a NaN and a number by infinity.
    double peak = 255;  // what PSNR compares with: 255 for bytes, 1 for floats
    double mean = 0, rmse = 0;
    double psnr = 0;  // 20 log10(peak / rmse), in decibels; infinite for equal pictures
    double maximum = 0;

    // Where the maximum is: of several such pixels the one with the largest sum over its channels, of those
    // the first in reading order; (0, 0) for equal pictures.
    int worstX = 0, worstY = 0;

    int score = 100;            // the autograder's, 0 to 100: see neighbourhoodScore
    std::uint64_t speckle = 0;  // see speckleCount

    std::uint64_t pixelsOver(int tolerance) const;  // differ by more than `tolerance` of 255 in some channel
};

// Throw ImageError where the sizes differ.
Comparison compareImages(const ByteImage& a, const ByteImage& b);
Comparison compareImages(const FloatImage& a, const FloatImage& b);
Comparison compareImages(const Picture& a, const Picture& b);

// The score of the course's autograder, which forgives edges that are off by a pixel: a pixel of A is as far
// from B as the nearest colour, by the sum of absolute differences over its channels, in its 3 x 3
// neighbourhood in B (the part that is inside of the picture), and the same from B to A. The larger of the
// two distances is the pixel's. Then max(0, 100 - 1000 mean / 255), the mean being over all channels of all
// pixels, rounded as Python does (half to even).
//
// The autograder's rule that a later neighbour replaces an earlier one only if strictly smaller decides which
// of several equally distant neighbours lends its channels to the autograder's difference picture. Their sums
// are equal, and "larger" is by the sum, so that it never changes the score. (Had it taken the larger channel
// by channel, it would.)
int neighbourhoodScore(const ByteImage& a, const ByteImage& b);

// What that score can't see: pixels that stand alone in one picture and not in the other. A pixel stands
// alone where it differs from every one of its neighbours (8, fewer at the border) by more than 8 of 255 in
// some channel.
std::uint64_t speckleCount(const ByteImage& a, const ByteImage& b);

// Where, and roughly how much: a channel that is equal is black, one that differs by d is 64 + 8 d (at most
// 255).
ByteImage amplifiedDifference(const ByteImage& a, const ByteImage& b);

// What counts as the same picture. Without any of them: no pixel may differ.
struct Thresholds {
    std::optional<std::uint64_t> maxPixels;  // that differ by more than the tolerance; unless said 0,
    std::optional<int>
        tolerance;  // of 255; unless said 0; but where only a score is asked for, pixels are not
    std::optional<int> minScore;
};
bool within(const Comparison& comparison, const Thresholds& thresholds);

}  // namespace raytracer
