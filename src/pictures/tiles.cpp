#include "raytracer/pictures/tiles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raytracer {
namespace {

int tileEnd(int pixel) { return (pixel + tileEdge - 1) / tileEdge; }

}  // namespace

std::string inWords(const PicturePart& part) {
    return std::to_string(part.number) + " of " + std::to_string(part.count);
}

// A rank-1 lattice: each row of tiles is shifted against the one above by about count / golden ratio, the
// ratio that fractions approximate worst. The shift and the count have no common divisor, so that a column
// has all parts too.
PartLattice::PartLattice(int count) : count_(count) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    shift_ = std::max(1, static_cast<int>(std::lround(golden * count)));
    while (std::gcd(shift_, count_) > 1) ++shift_;
}

int PartLattice::partOf(const PixelRectangle& tile) const {
    const auto row = static_cast<long long>(tile.y0 / tileEdge);
    return static_cast<int>((tile.x0 / tileEdge + row * shift_) % count_) + 1;
}

std::vector<PixelRectangle> tilesOf(const PixelRectangle& rectangle, const PicturePart& part) {
    std::vector<PixelRectangle> tiles;
    const PartLattice lattice(part.count);
    for (int y = rectangle.y0 / tileEdge; y < tileEnd(rectangle.y1); ++y)
        for (int x = rectangle.x0 / tileEdge; x < tileEnd(rectangle.x1); ++x) {
            const PixelRectangle tile{
                std::max(x * tileEdge, rectangle.x0), std::max(y * tileEdge, rectangle.y0),
                std::min((x + 1) * tileEdge, rectangle.x1), std::min((y + 1) * tileEdge, rectangle.y1)};
            if (lattice.partOf(tile) == part.number) tiles.push_back(tile);
        }
    return tiles;
}

std::vector<std::uint64_t> pixelsOfParts(const PixelRectangle& rectangle, int count) {
    const PartLattice lattice(count);
    std::vector<std::uint64_t> pixels(static_cast<std::size_t>(count) + 1);
    for (const PixelRectangle& band : bandsOf(rectangle, 0))
        for (const PixelRectangle& tile : tilesOf(band))
            pixels[static_cast<std::size_t>(lattice.partOf(tile))] += static_cast<std::uint64_t>(tile.area());
    return pixels;
}

PixelRectangle withRing(const PixelRectangle& tile, const ImageSize& size) {
    return {std::max(tile.x0 - 1, 0), std::max(tile.y0 - 1, 0), std::min(tile.x1 + 1, size.width),
            std::min(tile.y1 + 1, size.height)};
}

std::vector<PixelRectangle> bandsOf(const PixelRectangle& rectangle, double pixels) {
    const int rows = std::max(1, static_cast<int>(std::min(pixels / rectangle.width(), 1e9) / tileEdge));
    std::vector<PixelRectangle> bands;
    for (int y = rectangle.y0; y < rectangle.y1; y = bands.back().y1)
        bands.push_back(
            {rectangle.x0, y, rectangle.x1,
             static_cast<int>(std::min<long long>((y / tileEdge + 1LL * rows) * tileEdge, rectangle.y1))});
    return bands;
}

}  // namespace raytracer
