// No ray gets through a closed mesh, and none crosses a shared edge twice. The long run is bench/watertight.cpp.
#include <catch2/catch.hpp>

#include "core_watertight.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

// Ten million in double, but fewer where they would take minutes.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
constexpr std::uint64_t many = 10000000;
#else
constexpr std::uint64_t many = 200000;
#endif
constexpr std::uint64_t few = 200000;
constexpr bool isDouble = std::numeric_limits<Real>::digits == 53;

void check(const Crossings& result) {
    CHECK(result.through == 0);
    CHECK(result.twice == 0);
    CHECK(result.odd == 0);
}

}  // namespace

TEST_CASE("watertight: aimed at vertices and edges, about the origin") { check(WatertightTest(glm::dvec3(0), 3).run(few)); }

TEST_CASE("watertight: aimed at vertices and edges, far from the origin") {
    check(WatertightTest(glm::dvec3(148376, 1234, -223423), 3).run(isDouble ? many : few));
}

TEST_CASE("watertight: exactly through the vertices and edges of a cube of triangles") {
    const auto data = cubeMesh();
    const Material material;
    const auto triangles = std::make_shared<TriangleMesh>(data, BuildOptions{});
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z)
                for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 0), Vec3(1, 1, -1), Vec3(2, 1, 0)}) {
                    const ShearedRay ray({Vec3(x, y, z) / Real(2) - Real(4) * direction, direction});
                    int in = 0, out = 0;
                    for (std::uint32_t triangle = 0; triangle < 12; ++triangle)
                        if (const auto line = triangles->intersectLine(ray, triangle); line.hit) ++(line.entering ? in : out);
                    INFO(x << y << z << " along " << direction.x << direction.y << direction.z);
                    CHECK(in == out);
                    CHECK(in <= 1);
                }
}

// Four triangles around a vertex at which two edges go straight on, as in every subdivided face, and a line that passes by one of
// these edges so closely that rounded products agree: guessed there, the sides of two edges contradict each other.
TEST_CASE("watertight: by an edge that goes straight on through a vertex") {
    Random random(7);
    int wrong = 0;
    for (int i = 0; i < 100000; ++i) {
        // Rounded to Real so that a mesh, which has double, holds what the test means.
        const auto rounded = [](const glm::dvec3& v) { return glm::dvec3(Vec3(v)); };
        const glm::dvec3 way(random.between(0.5, 1), random.between(0.5, 1), 0), side(-way.y, way.x, 0);
        const glm::dvec3 middle = rounded(random.between(-0.1, 0.1) * way);
        auto data = std::make_shared<MeshData>();
        data->positions = {middle, rounded(way), rounded(side), rounded(middle + random.between(0.5, 2) * (middle - way)), rounded(-side)};
        data->positionIndex = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
        const TriangleMesh triangles(data);
        const ShearedRay line({Vec3(0, 0, -1), Vec3(0, 0, 1)});
        int met = 0;
        for (std::uint32_t triangle = 0; triangle < 4; ++triangle) met += triangles.intersectLine(line, triangle).hit;
        wrong += met != 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("watertight: the side of an edge is exact where rounded products agree") {
    const Real step = 2 * unitRoundoff, a = 1 + step;
    CHECK(signOfDifferenceOfProducts(a, a, 1 + 2 * step, 1) == 1);  // (1 + e)^2 = 1 + 2e + e^2
    CHECK(signOfDifferenceOfProducts(1 + 2 * step, 1, a, a) == -1);
    CHECK(signOfDifferenceOfProducts(a, 1 - step, 1, 1) == -1);  // 1 - e^2
    CHECK(signOfDifferenceOfProducts(a, -a, -a, a) == 0);
    CHECK(signOfDifferenceOfProducts(3, 4, 6, 2) == 0);
}
