// A ray that leaves a surface never meets the point that it leaves, and one that enters a solid comes out of it. The long
// run is bench/reintersection.cpp.
#include <catch2/catch.hpp>

#include "core_reintersection.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

// Of float, as much as its digits cover: a place 10^4 radii away is known to a thousandth of a radius.
constexpr bool isFloat = std::numeric_limits<Real>::digits < 32;
constexpr Extents extents = isFloat ? Extents{2, 2, 2} : Extents{4, 4, 8};
constexpr std::uint64_t count = std::numeric_limits<Real>::digits == 53 ? 1000000 : 100000;

void check(const Reintersections& result) {
    CHECK(result.missed * 5 < result.points);
    CHECK(result.metAgain == 0);
    CHECK(result.neverOut == 0);
    CHECK(result.stuck == 0);
    CHECK(result.oddCrossings == 0);
}

}  // namespace

TEST_CASE("re-intersection: sphere") { check(Reintersection(Kind::Sphere, nullptr, 1, extents).run(count)); }
TEST_CASE("re-intersection: plane") { check(Reintersection(Kind::Plane, nullptr, 2, extents).run(count)); }
TEST_CASE("re-intersection: cylinder") { check(Reintersection(Kind::Cylinder, nullptr, 3, extents).run(count)); }
TEST_CASE("re-intersection: cone") { check(Reintersection(Kind::Cone, nullptr, 4, extents).run(count)); }
TEST_CASE("re-intersection: cube") { check(Reintersection(Kind::Cube, nullptr, 5, extents).run(count)); }
TEST_CASE("re-intersection: mesh") { check(Reintersection(Kind::Mesh, roundMesh(), 6, extents).run(count)); }

TEST_CASE("re-intersection: shapes of 10^+-30, 10^+-30 from the origin") {
    if (isFloat) return;
    for (const Kind kind : allKinds) {
        INFO(nameOf(kind));
        const Reintersections result = Reintersection(kind, roundMesh(), 7, {30, 4, 30}).run(20000);
        CHECK(result.metAgain + result.neverOut + result.stuck + result.oddCrossings == 0);
    }
}
