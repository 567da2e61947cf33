// The order in which many shapes are made: each once, and the eight corners' clusters one after the other.
#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "raytracer/bvh/spatial_order.h"

using namespace raytracer;

namespace {

int octant(const glm::vec3& p) { return (p.x > 0) + 2 * (p.y > 0) + 4 * (p.z > 0); }

}  // namespace

TEST_CASE("spatial order: every point once, each octant together") {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1, 1);
    std::vector<glm::vec3> points{{-1, -1, -1}, {1, 1, 1}};
    for (int i = 0; i < 5000; ++i) points.emplace_back(place(random), place(random), place(random));
    const std::vector<std::uint32_t> order = spatialOrder(points);
    std::vector<std::uint32_t> sorted = order;
    std::ranges::sort(sorted);
    REQUIRE(sorted.size() == points.size());
    for (std::uint32_t i = 0; i < sorted.size(); ++i) REQUIRE(sorted[i] == i);
    REQUIRE(std::ranges::is_sorted(order, {}, [&](std::uint32_t i) { return octant(points[i]); }));
}

TEST_CASE("spatial order: what has no extent stays as it was, what nearly overflows is ordered") {
    CHECK(spatialOrder({}).empty());
    CHECK(spatialOrder(std::vector<glm::vec3>(4, glm::vec3(7))) == std::vector<std::uint32_t>{0, 1, 2, 3});
    constexpr float most = std::numeric_limits<float>::max();
    CHECK(spatialOrder(std::vector<glm::vec3>{{most, 0, 0}, {-most, 0, 0}, {0, 0, 0}}) ==
          std::vector<std::uint32_t>{1, 2, 0});
}
