#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "raytracer/grading/compare.h"

using namespace raytracer;

namespace {

ByteImage flat(int width, int height, int value) {
    const auto count = static_cast<std::size_t>(3 * width * height);
    return {width, height, LargeVector<std::uint8_t>(count, static_cast<std::uint8_t>(value))};
}

FloatImage flatFloats(int width, int height, float value) {
    return {width, height, LargeVector<float>(static_cast<std::size_t>(3 * width * height), value)};
}

ByteImage with(ByteImage image, int x, int y, int r, int g, int b) {
    std::uint8_t* pixel = &image.pixels[static_cast<std::size_t>(3 * (y * image.width + x))];
    pixel[0] = static_cast<std::uint8_t>(r);
    pixel[1] = static_cast<std::uint8_t>(g);
    pixel[2] = static_cast<std::uint8_t>(b);
    return image;
}

}  // namespace

TEST_CASE("compare: equal pictures") {
    const ByteImage image = with(flat(5, 4, 7), 2, 2, 200, 0, 0);
    const Comparison c = compareImages(image, image);
    CHECK(c.width == 5);
    CHECK(c.height == 4);
    CHECK(c.pixelsOver(0) == 0);
    CHECK(c.pixelsOver(-1) == 20);
    CHECK(c.mean == 0);
    CHECK(c.rmse == 0);
    CHECK(c.psnr == std::numeric_limits<double>::infinity());
    CHECK(c.maximum == 0);
    CHECK(c.score == 100);
    CHECK(c.speckle == 0);
    CHECK(c.worstX == 0);
    CHECK(c.worstY == 0);
}

TEST_CASE("compare: pixels are counted by their most different channel") {
    const ByteImage a = flat(4, 4, 100);
    const ByteImage b = with(with(with(a, 0, 0, 101, 100, 100), 1, 0, 100, 92, 99), 2, 0, 100, 100, 109);
    const Comparison c = compareImages(a, b);
    CHECK(c.pixelsOver(0) == 3);
    CHECK(c.pixelsOver(1) == 2);
    CHECK(c.pixelsOver(7) == 2);
    CHECK(c.pixelsOver(8) == 1);
    CHECK(c.pixelsOver(9) == 0);
    CHECK(c.pixelsOver(255) == 0);
}

TEST_CASE("compare: mean, RMSE, PSNR and maximum are over all samples") {
    const ByteImage a = flat(2, 2, 0);
    const ByteImage b = with(with(a, 1, 0, 3, 0, 4), 0, 1, 0, 12, 0);
    const Comparison c = compareImages(a, b);
    CHECK(c.mean == 19.0 / 12);
    CHECK(c.rmse == std::sqrt(169.0 / 12));
    CHECK(c.psnr == Approx(20 * std::log10(255 * std::sqrt(12.0) / 13)).epsilon(1e-14));
    CHECK(c.maximum == 12);
    CHECK(c.worstX == 0);
    CHECK(c.worstY == 1);
}

TEST_CASE("compare: the worst pixel") {
    const ByteImage a = flat(3, 3, 0);
    SECTION("the larger sum, where the maximum is the same") {
        const Comparison c = compareImages(a, with(with(a, 1, 0, 9, 0, 0), 2, 1, 9, 1, 0));
        CHECK(c.worstX == 2);
        CHECK(c.worstY == 1);
    }
    SECTION("the maximum before the sum") {
        const Comparison c = compareImages(a, with(with(a, 1, 0, 9, 0, 0), 2, 1, 8, 8, 8));
        CHECK(c.worstX == 1);
        CHECK(c.worstY == 0);
    }
    SECTION("the first in reading order") {
        const Comparison c = compareImages(a, with(with(a, 2, 0, 9, 0, 0), 0, 2, 0, 9, 0));
        CHECK(c.worstX == 2);
        CHECK(c.worstY == 0);
    }
}

TEST_CASE("compare: the autograder's score") {
    SECTION("of one pixel: no neighbours to forgive it") {
        CHECK(compareImages(flat(1, 1, 0), flat(1, 1, 1)).score == 96);  // 100 - 1000 / 255 = 96.08
        CHECK(compareImages(flat(1, 1, 0), flat(1, 1, 25)).score == 2);
        CHECK(compareImages(flat(1, 1, 0), flat(1, 1, 26)).score == 0);  // -1.96, but no less than 0
        CHECK(compareImages(flat(1, 1, 0), flat(1, 1, 255)).score == 0);
    }
    SECTION("half a point is rounded to the even one") {
        const ByteImage black =
            flat(20, 20, 0);  // one lone pixel of the sum 153 costs 1000 * 153 / 1200 / 255 = 0.5
        CHECK(compareImages(black, with(black, 5, 1, 153, 0, 0)).score == 100);
        CHECK(compareImages(black, with(black, 5, 1, 154, 0, 0)).score == 99);
        CHECK(compareImages(black, with(black, 5, 1, 153, 153, 153)).score == 98);
        CHECK(compareImages(black, with(black, 5, 1, 153, 153, 152)).score == 99);
    }
    SECTION("a pixel that moved by one costs nothing, by two it does") {
        const ByteImage black = flat(5, 5, 0);
        const ByteImage dot = with(black, 2, 2, 255, 255, 255);
        CHECK(compareImages(dot, with(black, 3, 3, 255, 255, 255)).score == 100);
        CHECK(compareImages(dot, with(black, 4, 2, 255, 255, 255)).score == 20);  // 100 - 1000 * 2 / 25
    }
    SECTION("a pixel that is in one picture alone counts in that direction") {
        const ByteImage black = flat(5, 5, 0);
        const ByteImage dot = with(black, 2, 2, 255, 255, 255);
        CHECK(compareImages(dot, black).score == 60);  // 100 - 1000 / 25
        CHECK(compareImages(black, dot).score == 60);
    }
    SECTION("the larger of the two distances is by the pixel, not by the channel") {
        // A is (0, 0, 0) everywhere, B's pixel 0 is (30, 0, 0), its pixel 1 (0, 40, 0): from A's pixel 0 the
        // nearest in B is (30, 0, 0), from its pixel 1 too; from B's pixels to A 30 and 40. Pixels: 30 and
        // 40, so 70 over 6 channels.
        const ByteImage a = flat(2, 1, 0);
        const ByteImage b = with(with(a, 0, 0, 30, 0, 0), 1, 0, 0, 40, 0);
        CHECK(compareImages(a, b).score ==
              54);  // 100 - 1000 * 70 / 6 / 255 = 54.2; by the channel 100 / 6: 34.6
    }
    SECTION("the nearest is by the sum over the channels") {
        const ByteImage a = flat(2, 1, 0);
        const ByteImage b = with(with(a, 0, 0, 9, 9, 9), 1, 0, 25, 0, 0);  // 27 is farther than 25
        CHECK(compareImages(a, b).score == 66);  // from A 25, 25; from B 27, 25: 52 / 6
    }
    SECTION("there are no neighbours across the picture's border") {
        const ByteImage a = with(flat(4, 4, 0), 0, 1, 255, 255, 255);
        const ByteImage b = with(flat(4, 4, 0), 3, 1, 255, 255, 255);
        CHECK(compareImages(a, b).score == 0);  // 100 - 1000 * 2 / 16
        CHECK(compareImages(flat(9, 9, 0), with(flat(9, 9, 0), 0, 0, 255, 255, 255)).score == 88);
    }
}

TEST_CASE("compare: speckle") {
    const ByteImage grey = flat(5, 5, 100);
    const auto speckle = [](const ByteImage& a, const ByteImage& b) {
        const std::uint64_t count = compareImages(a, b).speckle;
        CHECK(compareImages(b, a).speckle == count);
        return count;
    };
    SECTION("a lone pixel, also at the border") {
        CHECK(speckle(grey, with(grey, 2, 2, 100, 109, 100)) == 1);
        CHECK(speckle(grey, with(grey, 0, 0, 100, 109, 100)) == 1);
        CHECK(speckle(grey, with(grey, 4, 2, 100, 109, 100)) == 1);
    }
    SECTION("of 8 it is not yet unlike") { CHECK(speckle(grey, with(grey, 2, 2, 92, 108, 100)) == 0); }
    SECTION("two together are not alone") {
        CHECK(speckle(grey, with(with(grey, 2, 2, 200, 0, 0), 3, 3, 200, 0, 0)) == 0);
    }
    SECTION("two apart are two, also where one is in each picture") {
        CHECK(speckle(grey, with(with(grey, 1, 1, 200, 0, 0), 3, 3, 200, 0, 0)) == 2);
        CHECK(speckle(with(grey, 1, 1, 200, 0, 0), with(grey, 3, 3, 200, 0, 0)) == 2);
    }
    SECTION("alone in both is no speckle") {
        CHECK(speckle(with(grey, 2, 2, 200, 0, 0), with(grey, 2, 2, 0, 0, 200)) == 0);
    }
    SECTION("a picture of one pixel") { CHECK(speckle(flat(1, 1, 0), flat(1, 1, 255)) == 0); }
}

TEST_CASE("compare: symmetric") {
    ByteImage a = flat(17, 11, 0), b = a;
    std::uint32_t state = 12345;
    for (ByteImage* image : {&a, &b})
        for (std::uint8_t& sample : image->pixels)
            sample = static_cast<std::uint8_t>((state = state * 1664525 + 1013904223) >> 28);
    const Comparison ab = compareImages(a, b), ba = compareImages(b, a);
    CHECK(ab.pixelsByDifference == ba.pixelsByDifference);
    CHECK(ab.mean == ba.mean);
    CHECK(ab.rmse == ba.rmse);
    CHECK(ab.score == ba.score);
    CHECK(ab.speckle == ba.speckle);
    CHECK(ab.worstX == ba.worstX);
    CHECK(ab.worstY == ba.worstY);
}

TEST_CASE("compare: floats") {
    FloatImage a = flatFloats(2, 2, 0.5F);
    SECTION("errors are linear and not clamped, counts are of bytes") {
        FloatImage b = a;
        b.pixels[3] = 4.5F;     // byte 255, 127 away
        b.pixels[6] = 0.5005F;  // the same byte, 128
        const Comparison c = compareImages(a, b);
        CHECK(c.peak == 1);
        CHECK(c.maximum == 4);
        CHECK(c.mean == Approx((4 + 0.0005) / 12));
        CHECK(c.rmse == Approx(std::sqrt((16 + 0.0005 * 0.0005) / 12)));
        CHECK(c.psnr == Approx(-20 * std::log10(c.rmse)));
        CHECK(c.pixelsOver(0) == 1);
        CHECK(c.pixelsOver(126) == 1);
        CHECK(c.pixelsOver(127) == 0);
        CHECK(c.worstX == 1);
        CHECK(c.worstY == 0);
    }
    SECTION("the same infinity or NaN is equal, another is infinitely far") {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        const float infinity = std::numeric_limits<float>::infinity(),
                    nan = std::numeric_limits<float>::quiet_NaN();
        a.pixels = {infinity, nan, -infinity, 0, 0, 0, 0, 0, 0, 0, 0, 0};
        FloatImage b = a;
        CHECK(compareImages(a, b).maximum == 0);
        b.pixels[5] = nan;
        CHECK(compareImages(a, b).maximum == infinite);
        CHECK(compareImages(a, b).worstX == 1);
        CHECK(compareImages(a, b).psnr == -infinite);
        CHECK(compareImages(a, b).pixelsOver(0) == 1);
        CHECK(compareImages(b, Picture(flat(2, 2, 0))).pixelsOver(254) == 2);
        CHECK(toBytes(b, a).pixels[5] == 255);
        CHECK(toBytes(b, Picture(flat(2, 2, 128))).pixels[5] == 0);
        CHECK(toBytes(b, b).pixels[5] == 0);
    }
    SECTION("a NaN where the other has a number is wrong, whatever its neighbours are") {
        FloatImage checkers = flatFloats(8, 8, 0), broken = checkers;
        for (std::size_t i = 0; i < checkers.pixels.size(); ++i)
            checkers.pixels[i] = (i / 3 + i / 24) % 2 == 0 ? 0 : 1;
        broken = checkers;
        for (std::size_t c = 0; c < 3; ++c) broken.pixels[3 * 27 + c] = std::nanf("");
        CHECK(compareImages(broken, checkers).score == 84);  // one of 64 pixels is off by 255
        CHECK(compareImages(checkers, broken).score == 84);
        CHECK(compareImages(broken, broken).score == 100);
        broken.pixels[3 * 28] = std::nanf("");
        const FloatImage once = broken;
        broken.pixels[3 * 28] = 0.5F;
        CHECK(compareImages(once, broken).score == 84);  // one channel is enough
        const FloatImage grey = flatFloats(8, 8, 0.5F);
        broken = grey;
        broken.pixels[0] = std::nanf("");
        CHECK(compareImages(broken, grey).pixelsOver(254) == 1);
        CHECK(compareImages(Picture(broken), Picture(flat(8, 8, 128))).pixelsOver(254) == 1);
    }
    SECTION("a NaN is nobody's neighbour") {
        FloatImage broken = flatFloats(2, 1, 0), right = broken;
        broken.pixels[0] = broken.pixels[1] = broken.pixels[2] = std::nanf("");
        for (std::size_t c = 3; c < 6; ++c) right.pixels[c] = 1;
        CHECK(compareImages(broken, right).score == 0);
    }
    SECTION("with a PNG: as bytes") {
        const Comparison c = compareImages(Picture(a), Picture(flat(2, 2, 127)));
        CHECK(c.peak == 255);
        CHECK(c.maximum == 1);
        CHECK(compareImages(Picture(a), Picture(a)).peak == 1);
    }
}

TEST_CASE("compare: sizes must be the same") {
    CHECK_THROWS_WITH(compareImages(flat(2, 3, 0), flat(3, 2, 0)),
                      "the pictures' sizes differ: 2 x 3 and 3 x 2");
    CHECK_THROWS_WITH(amplifiedDifference(flat(2, 3, 0), flat(2, 2, 0)),
                      "the pictures' sizes differ: 2 x 3 and 2 x 2");
}

TEST_CASE("compare: the difference as a picture") {
    const ByteImage a = flat(2, 1, 100);
    const ByteImage difference =
        amplifiedDifference(a, with(with(a, 0, 0, 100, 101, 99), 1, 0, 76, 123, 255));
    CHECK(difference.width == 2);
    CHECK(difference.height == 1);
    CHECK(difference.pixels == LargeVector<std::uint8_t>{0, 72, 72, 255, 248, 255});
}

TEST_CASE("compare: thresholds") {
    const ByteImage a = flat(10, 10, 0);
    const Comparison equal = compareImages(a, a);
    const Comparison c = compareImages(a, with(with(a, 1, 1, 2, 0, 0), 5, 5, 255, 255, 255));  // score 90
    REQUIRE(c.score == 90);
    CHECK(within(equal, {}));
    CHECK_FALSE(within(c, {}));
    CHECK_FALSE(within(c, {.maxPixels = 1, .tolerance = {}, .minScore = {}}));
    CHECK(within(c, {.maxPixels = 2, .tolerance = {}, .minScore = {}}));
    CHECK_FALSE(within(c, {.maxPixels = 1, .tolerance = 1, .minScore = {}}));
    CHECK(within(c, {.maxPixels = 1, .tolerance = 2, .minScore = {}}));
    CHECK_FALSE(within(c, {.maxPixels = {}, .tolerance = 254, .minScore = {}}));
    CHECK(within(c, {.maxPixels = {}, .tolerance = 255, .minScore = {}}));
    CHECK(within(c, {.maxPixels = {}, .tolerance = {}, .minScore = 90}));
    CHECK_FALSE(within(c, {.maxPixels = {}, .tolerance = {}, .minScore = 91}));
    CHECK_FALSE(within(c, {.maxPixels = 1, .tolerance = {}, .minScore = 90}));
    CHECK(within(c, {.maxPixels = 2, .tolerance = 0, .minScore = 90}));
}
