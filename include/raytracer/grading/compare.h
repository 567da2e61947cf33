// The difference of two pictures of the same size: as numbers, as the course's score, and as a picture.
//
// Counts, score and speckle are of bytes: a float picture is clamped and quantised first, as for a PNG. Mean,
// RMSE, PSNR and maximum are of the file's samples: bytes (0 to 255), or linear floats, which may lie outside
// of [0, 1]. A PNG and a PFM are compared as bytes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "raytracer/pictures/image.h"

namespace raytracer {

using Picture = std::variant<ByteImage, FloatImage>;

// Of a PFM floats, else bytes. Throws Error.
Picture readPicture(const std::string& path);
ByteImage toBytes(const Picture& picture);

struct Comparison {
    int width = 0, height = 0;

    // [d]: the number of pixels whose most different channel differs by d of 255.
    std::array<std::uint64_t, 256> pixelsByDifference{};

    // Over all samples. Equal samples and two NaN differ by 0, a NaN and a number by infinity.
    double peak = 255;  // of PSNR: 255 for bytes, 1 for floats
    double mean = 0, rmse = 0;
    double psnr = 0;  // 20 log10(peak / rmse), in decibels; infinite for equal pictures
    double maximum = 0;

    // The pixel of the maximum: of several, the one with the largest sum over its channels, then the first in
    // reading order. (0, 0) for equal pictures.
    int worstX = 0, worstY = 0;

    int score = 100;            // neighbourhoodScore
    std::uint64_t speckle = 0;  // speckleCount

    // The number of pixels that differ by more than `tolerance` of 255 in some channel.
    std::uint64_t pixelsOver(int tolerance) const;
};

// Throw Error if the sizes differ.
void requireSameSize(const ImageSize& a, const ImageSize& b);
Comparison compareImages(const ByteImage& a, const ByteImage& b);
Comparison compareImages(const FloatImage& a, const FloatImage& b);
Comparison compareImages(const Picture& a, const Picture& b);

// The score of the course's autograder, 0 to 100, which forgives edges that are off by a pixel. The distance
// of a pixel of A from B is the smallest sum of absolute channel differences to a pixel of its 3 x 3
// neighbourhood in B, inside of the picture. A pixel's distance is the larger of that from A to B and that
// from B to A. The score is max(0, 100 - 1000 mean / 255), with the mean over all channels of all pixels,
// rounded half to even as in Python.
//
// The autograder's choice among equally distant neighbours affects only its difference picture: their sums
// are equal, and the larger distance is chosen by the sum.
int neighbourhoodScore(const ByteImage& a, const ByteImage& b);

// The number of pixels that are isolated in one picture and not in the other; a few do not lower the score. A
// pixel is isolated if it differs from each of its neighbours (8, fewer at the border) by more than 8 of 255
// in some channel.
std::uint64_t speckleCount(const ByteImage& a, const ByteImage& b);

// Channels that are equal are 0; those that differ by d are 64 + 8 d, at most 255.
ByteImage amplifiedDifference(const ByteImage& a, const ByteImage& b);

// What counts as the same picture. Without any threshold no pixel may differ. With minScore alone, pixels are
// not counted.
struct Thresholds {
    std::optional<std::uint64_t> maxPixels;  // that may differ by more than the tolerance; 0 if not given
    std::optional<int> tolerance;            // of 255; 0 if not given
    std::optional<int> minScore;
};
bool within(const Comparison& comparison, const Thresholds& thresholds);

}  // namespace raytracer
