// A ray that leaves a surface never meets the point that it leaves, and one that enters a solid comes out of
// it. The long run is bench/reintersection.cpp.
#include <catch2/catch.hpp>

#include "../support/core_reintersection.h"
#include "../support/slowness.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

// Of float, as much as its digits cover: a place 10^4 radii away is known to a thousandth of a radius.
constexpr bool hasFewDigits = std::numeric_limits<Real>::digits < 32;
constexpr Extents posesWithin = hasFewDigits ? Extents{2, 2, 2} : Extents{4, 4, 8};
constexpr std::uint64_t raysToTry =
    std::numeric_limits<Real>::digits == 53 ? 1000000 / slowness : 100000 / slowness;

void check(Kind kind, std::uint64_t seed, std::shared_ptr<const MeshData> mesh = nullptr) {
    const Reintersections result = Reintersection(kind, mesh, seed, posesWithin).run(raysToTry);
    CHECK(result.missed * 5 < result.points);
    CHECK(result.metAgain == 0);
    CHECK(result.neverOut == 0);
    CHECK(result.stuck == 0);
    CHECK(result.oddCrossings == 0);
}

}  // namespace

TEST_CASE("re-intersection: sphere") { check(Kind::Sphere, 1); }
TEST_CASE("re-intersection: plane") { check(Kind::Plane, 2); }
TEST_CASE("re-intersection: cylinder") { check(Kind::Cylinder, 3); }
TEST_CASE("re-intersection: cone") { check(Kind::Cone, 4); }
TEST_CASE("re-intersection: cube") { check(Kind::Cube, 5); }
TEST_CASE("re-intersection: mesh") { check(Kind::Mesh, 6, roundMesh()); }

// Reflected at a grazing angle, a direction may be turned over by rounding: even so.
TEST_CASE("re-intersection: a plane and a triangle never meet their own ray, wherever it goes") {
    auto triangle = std::make_shared<MeshData>();
    triangle->positions = {{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}};
    triangle->positionIndex = {0, 1, 2};
    triangle->findBounds();
    const Material material;
    Random random(8);
    int again = 0;
    for (int i = 0; i < 20000; ++i) {
        const Affine affine = randomAffine(random, posesWithin);
        const auto shape = makeShape(i % 2 ? Kind::Plane : Kind::Mesh, affine, material, triangle);
        const Wide target(random.uniform() / 2, random.uniform() / 2, 0);
        const Vec3 eye(pointToWorld(affine, target + Wide(random.direction())));
        const Ray ray{eye, Vec3(pointToWorld(affine, target) - Wide(eye)), {}};
        const Intersection hit = shape->rayIntersect(ray);
        if (!hit.valid) continue;
        const ShadingPoint point(ray, hit, false);
        const Vec3 any(random.direction()), tangent = any - glm::dot(any, point.N) * point.N;
        const auto below = static_cast<Real>(random.below(2) * std::pow(10, random.between(-20, 0)));
        again += shape->rayIntersect(point.leave(tangent - below * point.N, ShadingPoint::Side::Near)).valid;
    }
    CHECK(again == 0);
}

TEST_CASE("re-intersection: shapes of 10^+-30, 10^+-30 from the origin") {
    if (hasFewDigits) return;
    for (const Kind kind : allKinds) {
        INFO(nameOf(kind));
        const Reintersections result = Reintersection(kind, roundMesh(), 7, {30, 4, 30}).run(20000);
        CHECK(result.metAgain + result.neverOut + result.stuck + result.oddCrossings == 0);
    }
}

// As in a file of coordinates on a map: the error of a point is far less than a triangle, but not than the
// square of one.
TEST_CASE("re-intersection: a mesh that is small beside its distance from its own origin") {
    const double size = hasFewDigits ? 0x1p-8 : 0x1p-20;
    auto mesh = std::make_shared<MeshData>(*roundMesh());
    for (glm::dvec3& position : mesh->positions) position = size * position + glm::dvec3(1, 0.7, 0.4);
    mesh->findBounds();
    const Material material;
    const auto shape = makeShape(Kind::Mesh, Affine{}, material, mesh);
    Random random(9);
    int entered = 0, neverOut = 0, metAgain = 0;
    for (int i = 0; i < 20000 / slowness; ++i) {
        const Wide target = placeOn(Kind::Mesh, mesh.get(), static_cast<Place>(random.below(3)), random);
        const Vec3 eye(target + Wide(size * random.magnitude(1) * random.direction()));
        const Ray ray{eye, Vec3(target) - eye, {}};
        const Intersection hit = shape->rayIntersect(ray);
        if (!hit.valid || !hit.entering) continue;
        const ShadingPoint point(ray, hit, false);
        const Vec3 any(random.direction()), out = glm::dot(any, point.N) < 0 ? -any : any;
        ++entered;
        neverOut += !shape->rayIntersect(point.leave(-out, ShadingPoint::Side::Far)).valid;
        metAgain += shape->rayIntersect(point.leave(out, ShadingPoint::Side::Near)).valid;
    }
    CHECK(entered > 5000 / slowness);
    CHECK(neverOut == 0);
    CHECK(metAgain == 0);
}
