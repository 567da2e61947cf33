#include <catch2/catch.hpp>
#include <map>
#include <utility>
#include <vector>

#include "raytracer/tracer/sample_grid.h"

using namespace raytracer;

TEST_CASE("a grid's samples are its corners and the others, each once") {
    for (const int n : {1, 2, 3, 5}) {
        INFO(n);
        const SampleGrid grid{n};
        std::vector<std::pair<int, int>> corners;
        std::map<std::pair<int, int>, int> taken;
        grid.forEachCorner([&](int i, int j) { corners.emplace_back(i, j); });
        for (const auto& corner : corners) ++taken[corner];
        grid.forEachOther([&](int i, int j) { ++taken[{i, j}]; });
        CHECK(static_cast<int>(corners.size()) == grid.cornerCount());
        CHECK(static_cast<int>(taken.size()) == grid.count());
        for (const auto& [sample, times] : taken) CHECK(times == 1);
        if (n > 1)
            CHECK(corners ==
                  std::vector<std::pair<int, int>>{{0, 0}, {n - 1, 0}, {0, n - 1}, {n - 1, n - 1}});
    }
    CHECK(SampleGrid{1}.offset<double>(0) == 0.5);
    CHECK(SampleGrid{4}.offset<double>(3) == 0.875);
}

TEST_CASE("a spread of colours is that of the clamped ones, in the worst channel") {
    ColorSpread<double> spread;
    spread.add({0.25, -3, 5});
    CHECK(spread.largest() == 0);
    spread.add({0.5, 0.75, 1});
    CHECK(spread.largest() == 0.75);
}
