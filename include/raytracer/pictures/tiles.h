// The tiles of a picture: what threads, and several machines, share out.
#pragma once

#include <string>
#include <vector>

#include "raytracer/pictures/pixels.h"

namespace raytracer {

// Pixels: few enough to share out evenly, enough to keep rays coherent.
inline constexpr int tileEdge = 32;

// One of `count` parts of a picture.
struct PicturePart {
    int number = 1, count = 1;  // 1 <= number <= count <= mostParts
};
inline constexpr int mostParts = 1 << 20;

std::string inWords(const PicturePart& part);  // "3 of 7"

// Which part has a tile. Neighbours belong to different parts, and each part's tiles lie evenly all over the
// picture, so that all parts take about the same time.
class PartLattice {
  public:
    explicit PartLattice(int count);
    int partOf(const PixelRectangle& tile) const;  // 1 to count

  private:
    int count_, shift_;
};

// Row by row. Tiles lie at multiples of tileEdge of the whole picture; the rectangle cuts those at its edges.
std::vector<PixelRectangle> tilesOf(const PixelRectangle& rectangle);
std::vector<PixelRectangle> tilesOf(const PixelRectangle& rectangle, const PicturePart& part);

// The rectangle from the top in bands of whole tiles, each of at most so many pixels, but one row of tiles.
std::vector<PixelRectangle> bandsOf(const PixelRectangle& rectangle, double pixels);

}  // namespace raytracer
