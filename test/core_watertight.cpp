// No ray gets through a closed mesh, and none crosses a shared edge twice. The long run is bench/watertight.cpp.
#include <catch2/catch.hpp>

#include "core_watertight.h"

using namespace raytracer;
using namespace raytracer::test;

TEST_CASE("watertight: aimed at vertices and edges, near the origin and far from it") {
    for (const glm::dvec3& center : {glm::dvec3(0), glm::dvec3(148376, 1234, -223423)}) {
        const Crossings result = WatertightTest(center, 3).run(200000);
        CHECK(result.through == 0);
        CHECK(result.twice == 0);
        CHECK(result.odd == 0);
    }
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
