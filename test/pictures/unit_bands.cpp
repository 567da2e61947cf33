#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

#include "../support/test_folder.h"
#include "raytracer/pictures/assemble.h"
#include "raytracer/pictures/picture_writer.h"
#include "raytracer/util/error.h"

using namespace raytracer;

namespace {

constexpr WriterLimits small{.ofStb = 0, .ofBand = 200 * 64};

// A pixel's channels tell its place in the whole picture.
template <class Image>
Image placesIn(const PixelRectangle& place) {
    Image image{place.size(), {}};
    for (int y = place.y0; y < place.y1; ++y)
        for (int x = place.x0; x < place.x1; ++x)
            for (const int channel : {x, y, x * y / 100})
                image.pixels.push_back(static_cast<unsigned char>(channel));
    return image;
}

template <class Image>
void writeBands(PictureWriter<Image>& writer) {
    for (const PixelRectangle& band : writer.bands()) writer.write(placesIn<Image>(band));
    writer.finish();
}

std::vector<std::string> writeParts(const TestFolder& folder, const PartHead& of, int count) {
    std::vector<std::string> paths;
    for (int number = count; number > 0; --number) {
        PartHead head = of;
        head.part = {number, count};
        paths.push_back(folder.file("part" + std::to_string(number)));
        OutputFile file(paths.back());
        if (head.isFloat) writeBands(*partWriter<FloatImage>(file, head, small));
        else writeBands(*partWriter<ByteImage>(file, head, small));
    }
    return paths;
}

}  // namespace

TEST_CASE("Tiles cover a rectangle once, each in one part") {
    for (const PixelRectangle& rectangle :
         {PixelRectangle{0, 0, 1, 1}, {0, 0, 64, 64}, {31, 7, 300, 233}, {40, 40, 50, 41}})
        for (const int count : {1, 2, 7, 16, 64, 1000}) {
            double area = 0;
            for (int number = 1; number <= count; ++number)
                for (const PixelRectangle& tile : tilesOf(rectangle, {number, count})) area += tile.area();
            CHECK(area == rectangle.area());
        }
}

// The time of a part: a picture of 2000 px has 3969 tiles.
TEST_CASE("Parts have about the same number of tiles, in each quarter of the picture, too") {
    for (const PixelRectangle& rectangle :
         {PixelRectangle{0, 0, 2000, 2000}, {0, 0, 992, 992}, {992, 992, 2000, 2000}})
        for (int count = 2; count <= 64; ++count) {
            std::vector<double> tiles;
            for (int number = 1; number <= count; ++number)
                tiles.push_back(static_cast<double>(tilesOf(rectangle, {number, count}).size()));
            const double mean = std::accumulate(tiles.begin(), tiles.end(), 0.0) / count;
            CHECK(std::ranges::max(tiles) <= mean + 4);
            CHECK(std::ranges::min(tiles) >= mean - 4);
        }
}

TEST_CASE("Bands cover a rectangle from the top, in whole tiles") {
    const PixelRectangle rectangle{5, 40, 205, 300};
    const std::vector<PixelRectangle> bands = bandsOf(rectangle, 200 * 70);
    REQUIRE(bands.size() == 5);
    CHECK(bands[0].y0 == 40);
    CHECK(bands[0].y1 == 96);
    CHECK(bands[1].y1 == 160);
    CHECK(bands[4].y1 == 300);
    CHECK(bandsOf(rectangle, 0).front().y1 == 64);
}

TEST_CASE("A PNG that is written in bands comes back") {
    const TestFolder folder;
    const PixelRectangle crop{3, 9, 203, 300};
    OutputFile file(folder.file("a.png"));
    const auto writer = pngWriter(file, crop, 2, small);
    CHECK(writer->bands().size() == 5);
    writeBands(*writer);
    const ByteImage read = readImage(folder.file("a.png"));
    CHECK(read.width == 200);
    CHECK((read.pixels == placesIn<ByteImage>(crop).pixels));
    CHECK(folder.fileCount() == 1);
}

TEST_CASE("A PFM that is written in bands comes back") {
    const TestFolder folder;
    const PixelRectangle crop{3, 9, 203, 300};
    OutputFile file(folder.file("a.pfm"));
    const auto writer = pfmWriter(file, crop, small);
    CHECK(writer->bands().size() == 5);
    writeBands(*writer);
    CHECK((readPfm(folder.file("a.pfm")).pixels == placesIn<FloatImage>(crop).pixels));
}

TEST_CASE("Parts make the picture, whatever their bands and those of the picture are") {
    const TestFolder folder;
    PartHead head{"1", "scene", "--options", {400, 400}, {3, 9, 203, 300}, false, true, {}};
    for (const bool isFloat : {false, true}) {
        head.isFloat = isFloat;
        const PartFiles parts(writeParts(folder, head, 5), 2);
        CHECK(parts.faults().empty());
        for (const PixelRectangle& band : bandsOf(head.crop, 200 * 96)) {
            if (isFloat) CHECK((parts.read<FloatImage>(band).pixels == placesIn<FloatImage>(band).pixels));
            else CHECK((parts.read<ByteImage>(band).pixels == placesIn<ByteImage>(band).pixels));
        }
    }
}

TEST_CASE("A part is that of a head, or not") {
    const TestFolder folder;
    PartHead head{"1", "scene", "--options", {400, 400}, {3, 9, 203, 300}, false, true, {}};
    const std::string path = writeParts(folder, head, 1).front();
    CHECK(isPart(path, head));
    head.options = "--others";
    CHECK_FALSE(isPart(path, head));
    CHECK_FALSE(isPart(folder.file("none"), head));
}
