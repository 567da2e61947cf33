// A pixel's samples: where they lie, and when it has enough.
#include <array>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "raytracer/tracer/contrast.h"
#include "raytracer/tracer/pixel_estimate.h"
#include "raytracer/tracer/sample_sequence.h"

using namespace raytracer;

namespace {

// Points i 2^k to (i + 1) 2^k - 1 in a grid of 2^j x 2^(k - j) cells: how many cells have one.
std::size_t cellsTaken(const SampleSequence& sequence, std::uint32_t i, int k, int j) {
    std::set<std::pair<int, int>> cells;
    for (std::uint32_t n = i << k; n < (i + 1) << k; ++n) {
        const glm::dvec2 point = sequence[n];
        cells.emplace(static_cast<int>(point.x * (1 << j)), static_cast<int>(point.y * (1 << (k - j))));
    }
    return cells.size();
}

}  // namespace

TEST_CASE("the samples of a pixel begin with its centre, exactly") {
    CHECK(SampleSequence()[0] == glm::dvec2(0.5));
    CHECK(SampleSequence(1)[0] != glm::dvec2(0.5));
}

TEST_CASE("the samples of a pixel are spread evenly: one in each cell of every grid of so many cells") {
    for (const std::uint32_t number : {0U, 1U, 7U}) {
        const SampleSequence sequence(number);
        for (int k = 0; k <= 8; ++k)
            for (int j = 0; j <= k; ++j)
                for (const std::uint32_t i : {0U, 1U, 5U, 200U})
                    CHECK(cellsTaken(sequence, i, k, j) == std::size_t{1} << k);
    }
}

TEST_CASE("the samples of a pixel are the same everywhere: multiples of 2^-24 below 1") {
    const SampleSequence sequence;
    for (std::uint32_t i = 0; i < 65536; ++i)
        for (const double offset : {sequence[i].x, sequence[i].y}) {
            const double places = offset * 0x1p24;
            if (offset < 0 || offset >= 1 || places != std::floor(places)) FAIL(i << ": " << offset);
        }
    // Written down, so that no change of the sequence, and of every picture, goes unnoticed.
    const std::array<std::pair<int, int>, 4> second = {
        {{2319235, 2374748}, {14576889, 7074151}, {7245065, 14179332}, {12556746, 1244552}}};
    for (std::uint32_t i = 0; i < 4; ++i)
        CHECK(glm::dvec2(second[i].first, second[i].second) * 0x1p-24 == sequence[i + 1]);
}

TEST_CASE("a pixel may stop at 1, 4, 8, 16 ... samples and at the limit") {
    CHECK(nextLevel(1, 256) == 4);
    CHECK(nextLevel(4, 256) == 8);
    CHECK(nextLevel(8, 256) == 16);
    CHECK(nextLevel(64, 100) == 100);
    CHECK(nextLevel(1, 3) == 3);
}

TEST_CASE("a pixel's error: by the contrast around it, and by what its samples say") {
    PixelEstimate pixel;
    pixel.add({0.5, 0.5, 0.5});
    CHECK(pixel.error(0.2, 0) == Approx(0.2 / 4));
    for (int i = 0; i < 3; ++i) pixel.add({0.5, 0.5, 0.5});
    CHECK(pixel.error(0, 0) == 0);
    const double weight = std::sqrt(2);  // (16 / 4)^1/4
    CHECK(pixel.error(0.2, 0) == Approx(weight * 0.2 / 16));
    CHECK(pixel.error(0.2, 0.3) == Approx(weight * 0.3 / 16));

    PixelEstimate mixed;
    for (const double red : {0.1, 0.1, 0.3, 0.3}) mixed.add({red, 0, 0});
    CHECK(mixed.color() == glm::dvec3(0.2, 0, 0));
    const double moment = 4 * 0.0001 / 3;  // the fourth, of four samples
    CHECK(mixed.error(0, 0) == Approx(weight * std::pow(moment, 0.25) / std::pow(4, 0.75) / std::sqrt(3)));
    CHECK(mixed.error(1, 0) == Approx(weight / 16));
}

TEST_CASE("a pixel's error is what it shows: of samples brighter than white") {
    PixelEstimate rare, white;
    for (int i = 0; i < 64; ++i) {
        rare.add(glm::dvec3(i == 9 ? 30 : 0));
        white.add(glm::dvec3(i % 2 == 0 ? 5 : 7));
    }
    // The fourth moment of `rare` is 30^4 / 64, so its estimated error is about that of one sample more or
    // less; the weight is sqrt(0.5).
    CHECK(rare.error(0, 0) == Approx(std::sqrt(0.5) * 30 / 64).epsilon(0.02));
    CHECK(white.error(0, 0) == 0);
    CHECK(white.error(2, 0) == 0);
    PixelEstimate single;  // white, but its neighbours are not
    single.add(glm::dvec3(1.7));
    CHECK(single.error(2.2, 0) == Approx(2.2 / 4));
    CHECK(single.error(0.5, 0) == 0);
    CHECK(single.error(0.5, 0.1) == Approx(0.1 / 4));  // what no neighbour shows may be dark
    PixelEstimate beside;                              // one sample beside something bright
    beside.add(glm::dvec3(0.25));
    CHECK(beside.error(2, 0) == Approx(0.5));
    CHECK(beside.error(30, 0) == Approx(0.75));
}

TEST_CASE("contrast is that of the 3 x 3 colours around a pixel, in the worst channel") {
    std::vector<glm::dvec3> colors(4 * 3, glm::dvec3(0.25, 0, 1));
    colors[0] = {0.5, 0.75, 1};
    CHECK(contrasts({0, 0, 4, 3}, colors, {}) ==
          std::vector<double>{0.75, 0.75, 0, 0, 0.75, 0.75, 0, 0, 0, 0, 0, 0});
    colors[11] = {0.25, 0.25, 0};
    CHECK(contrasts({0, 0, 4, 3}, colors, {}) ==
          std::vector<double>{0.75, 0.75, 0, 0, 0.75, 0.75, 1, 1, 0, 0, 1, 1});
    CHECK(contrasts({0, 0, 12, 1}, colors, {}) ==
          std::vector<double>{0.75, 0.75, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1});
    CHECK(contrasts({0, 0, 1, 12}, colors, {}) ==
          std::vector<double>{0.75, 0.75, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1});
}

TEST_CASE("contrast: extra samples count where they lie in the picture, and at most as 16") {
    const std::vector<glm::dvec3> colors(4 * 3, glm::dvec3(0.5));
    const std::vector<ExtraSample> extra = {{{10.9, 20.1}, glm::dvec3(0.25, 0.5, 0.5)},
                                            {{13.5, 22.9}, glm::dvec3(0.5, 30, 0.5)}};
    CHECK(contrasts({10, 20, 14, 23}, colors, extra) ==
          std::vector<double>{0.25, 0.25, 0, 0, 0.25, 0.25, 15.5, 15.5, 0, 0, 15.5, 15.5});
}
