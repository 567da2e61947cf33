// Compares two pictures of the same size: as numbers, by the course's score, and as a picture.
//
// Counts, score and speckle are computed from bytes: a float picture is clamped and quantised first, as for a
// PNG; a NaN differs from any number by as much as there is. Mean, RMSE, PSNR and maximum are computed from
// the file's samples: bytes (0 to 255), or linear floats, which may lie outside [0, 1]. A PNG and a PFM are
// compared as bytes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "raytracer/pictures/image.h"

namespace raytracer {

using Picture = std::variant<ByteImage, FloatImage>;

// Reads a PFM as floats, any other picture as bytes. Throws Error.
Picture readPicture(const std::string& path);
ImageSize sizeOf(const Picture& picture);

// The picture's bytes, for a comparison with `other`, which has the same size. A NaN has no byte: it gets the
// one that is farthest from other's, or 0 if that is NaN, too.
ByteImage toBytes(const Picture& picture, const Picture& other);

// Where pictures have a NaN, pixel by pixel; empty if neither has any. In the same channels of both it is
// right.
enum class NanAt : std::uint8_t { Neither, SameInBoth, OneOnly };
using NanPlaces = std::vector<NanAt>;

struct Comparison : ImageSize {
    // Element d: the number of pixels whose largest channel difference is d of 255.
    std::array<std::uint64_t, 256> pixelsByDifference{};

    // These are over all samples. Two NaN differ by 0, a NaN and a number by infinity.
    double peak = 255;  // for PSNR: 255 for bytes, 1 for floats
    double mean = 0, rmse = 0;
    double psnr = 0;  // 20 log10(peak / rmse), in decibels; infinite for equal pictures
    double maximum = 0;

    // The pixel with the maximum. Of several, the one with the largest sum over its channels; of several
    // such, the first in reading order. (0, 0) for equal pictures.
    int worstX = 0, worstY = 0;

    int score = 100;            // neighbourhoodScore
    std::uint64_t speckle = 0;  // speckleCount

    // The number of pixels that differ by more than `tolerance` of 255 in some channel.
    std::uint64_t pixelsOver(int tolerance) const;
};

// These throw Error if the sizes differ.
void requireSameSize(const ImageSize& a, const ImageSize& b);
Comparison compareImages(const ByteImage& a, const ByteImage& b);
Comparison compareImages(const Picture& a, const Picture& b);

// The score of the course's autograder, from 0 to 100. It forgives edges that are off by one pixel.
//
// The distance of a pixel of A from B is the smallest sum of absolute channel differences to a pixel of the
// same 3 x 3 neighbourhood in B, inside the picture. A pixel's distance is the larger of that from A to B and
// that from B to A. The score is max(0, 100 - 1000 mean / 255), with the mean over all channels of all
// pixels, rounded half to even as in Python.
//
// Which of several equally distant neighbours the autograder chooses affects only its difference picture:
// their sums are equal, and the larger distance is chosen by the sum.
//
// A pixel with a NaN is nobody's neighbour: it is as far as can be from a number, and its distance from
// another NaN is that at its own place.
int neighbourhoodScore(const ByteImage& a, const ByteImage& b, const NanPlaces& nans = {});

// The number of pixels that are isolated in one picture but not in the other. A few of them do not lower the
// score. A pixel is isolated if it differs from each of its 8 neighbours (fewer at the border) by more than 8
// of 255 in some channel.
std::uint64_t speckleCount(const ByteImage& a, const ByteImage& b);

// A picture of the differences: equal channels are 0, channels that differ by d are 64 + 8 d, at most 255.
ByteImage amplifiedDifference(const ByteImage& a, const ByteImage& b);

// Decides what counts as the same picture. Without any threshold no pixel may differ. With minScore alone,
// differing pixels are not counted.
struct Thresholds {
    std::optional<std::uint64_t> maxPixels;  // may differ by more than the tolerance; 0 if not given
    std::optional<int> tolerance;            // of 255; 0 if not given
    std::optional<int> minScore;
};
bool within(const Comparison& comparison, const Thresholds& thresholds);

}  // namespace raytracer
