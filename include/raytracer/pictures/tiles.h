// The tiles of a picture: the units of work that threads, or several machines, share.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raytracer/pictures/pixels.h"

namespace raytracer {

// Pixels: small enough to share out evenly, large enough to keep rays coherent.
inline constexpr int tileEdge = 32;

// One of `count` parts of a picture.
struct PicturePart {
    int number = 1, count = 1;  // 1 <= number <= count <= mostParts
};
inline constexpr int mostParts = 1 << 20;

std::string inWords(const PicturePart& part);  // "3 of 7"

// Assigns tiles to parts. Neighbouring tiles belong to different parts, and each part's tiles are spread
// evenly over the picture, so that all parts take about the same time.
class PartLattice {
  public:
    explicit PartLattice(int count);
    int partOf(const PixelRectangle& tile) const;  // 1 to count

  private:
    int count_, shift_;
};

// The tiles of a rectangle, row by row. Tiles begin at multiples of tileEdge in the whole picture; those at
// the rectangle's edges are clipped to it.
std::vector<PixelRectangle> tilesOf(const PixelRectangle& rectangle, const PicturePart& part = {});

// The number of pixels that each of `count` parts has in a rectangle; element 0 is unused.
std::vector<std::uint64_t> pixelsOfParts(const PixelRectangle& rectangle, int count);

// The tile with a ring of neighbouring pixels, as far as they are in the picture.
PixelRectangle withRing(const PixelRectangle& tile, const ImageSize& size);

// Divides the rectangle, from the top, into bands of whole rows of tiles. A band has at most this many
// pixels, but at least one row of tiles.
std::vector<PixelRectangle> bandsOf(const PixelRectangle& rectangle, double pixels);

}  // namespace raytracer
