// No ray gets through a closed mesh, and none crosses a shared edge twice. The long run is
// bench/watertight.cpp.
#include <catch2/catch.hpp>

#include "../support/core_watertight.h"
#include "../support/slowness.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

// The many are for double, where a release takes ten seconds for them.
constexpr std::uint64_t many = 10000000 / slowness, few = 200000 / slowness;
constexpr bool isDouble = std::numeric_limits<Real>::digits == 53;

void check(const Crossings& result) {
    CHECK(result.through == 0);
    CHECK(result.twice == 0);
    CHECK(result.odd == 0);
}

}  // namespace

TEST_CASE("watertight: aimed at vertices and edges, about the origin") {
    check(WatertightTest(glm::dvec3(0), 3).run(few));
}

TEST_CASE("watertight: aimed at vertices and edges, far from the origin") {
    check(WatertightTest(glm::dvec3(148376, 1234, -223423), 3).run(isDouble ? many : few));
}

TEST_CASE("watertight: exactly through the vertices and edges of a cube of triangles") {
    const auto data = cubeMesh();
    const auto triangles = std::make_shared<TriangleMesh>(data, BuildOptions{});
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z)
                for (const Vec3& direction :
                     {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(1, 1, 0), Vec3(1, 1, -1), Vec3(2, 1, 0)}) {
                    const ObjectRay ray{Vec3(x, y, z) / Real(2) - Real(4) * direction, direction};
                    int in = 0, out = 0;
                    for (std::uint32_t triangle = 0; triangle < 12; ++triangle)
                        if (const auto line = meetLine(*triangles, ray, triangle); line.hit)
                            ++(line.entering ? in : out);
                    INFO(x << y << z << " along " << direction.x << direction.y << direction.z);
                    CHECK(in == out);
                    CHECK(in <= 1);
                }
}

// A vertex all but on an edge, so that one of the four triangles is a sliver, and a line so close to both
// that rounded products agree: were sides guessed there, those of two edges would contradict each other.
TEST_CASE("watertight: by a sliver") {
    Random random(7);
    int wrong = 0;
    for (int i = 0; i < 100000 / slowness; ++i) {
        // Rounded to Real so that a mesh, which has double, holds what the test means.
        const auto rounded = [](const glm::dvec3& v) { return glm::dvec3(Vec3(v)); };
        const glm::dvec3 way(random.between(0.5, 1), random.between(0.5, 1), 0), side(-way.y, way.x, 0);
        const glm::dvec3 middle = rounded(random.between(-0.1, 0.1) * way), right = rounded(way);
        const glm::dvec3 left = rounded(middle + random.between(0.5, 2) * (middle - right));
        auto data = std::make_shared<MeshData>();
        data->positions = {middle, right, rounded(side), left, rounded(-side)};
        data->positionIndex = {0, 1, 2, 0, 2, 3, 0, 3, 1, 3, 4, 1};
        data->findBounds();
        const TriangleMesh triangles(data);
        const ObjectRay line{Vec3(0, 0, -1), Vec3(0, 0, 1)};
        int crossings = 0;
        for (std::uint32_t triangle = 0; triangle < 4; ++triangle)
            if (const auto hit = meetLine(triangles, line, triangle); hit.hit)
                crossings += hit.entering ? 1 : -1;
        wrong += std::abs(crossings) != 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("watertight: the side of an edge is exact where rounded products agree") {
    const Real step = 2 * unitRoundoff, a = 1 + step;
    CHECK(differenceOfProducts(a, a, 1 + 2 * step, 1) == step * step);  // (1 + e)^2 = 1 + 2e + e^2
    CHECK(differenceOfProducts(1 + 2 * step, 1, a, a) == -step * step);
    CHECK(differenceOfProducts(a, 1 - step, 1, 1) == -step * step);
    CHECK(differenceOfProducts(a, -a, -a, a) == 0);
    CHECK(differenceOfProducts(3, 4, 6, 2) == 0);
}
