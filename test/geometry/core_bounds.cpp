// The bound that a hit claims for its position holds, and is tight enough to be worth having: the true
// distance from the surface, by long double, against Intersection::positionError.
#include <algorithm>

#include <catch2/catch.hpp>

#include "../support/core_random.h"
#include "../support/slowness.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

// The equation F = 0 of the face that was hit, as F(p) and its gradient.
struct Equation {
    long double value;
    Wide gradient;
    bool quadratic;
};

Equation equationAt(Kind kind, std::uint32_t face, const MeshData* mesh, const Wide& p) {
    const Wide up(0, 0, 1);
    switch (kind) {
        case Kind::Sphere: return {glm::dot(p, p) - 1, 2.0L * p, true};
        case Kind::Plane: return {p.z, up, false};
        case Kind::Cylinder:
            if (face == 0) return {p.x * p.x + p.y * p.y - 1, {2 * p.x, 2 * p.y, 0}, true};
            return {p.z - (face == 1 ? 1 : 0), up, false};
        case Kind::Cone:
            if (face == 1) return {p.z, up, false};
            return {p.x * p.x + p.y * p.y - (1 - p.z) * (1 - p.z), {2 * p.x, 2 * p.y, 2 * (1 - p.z)}, true};
        case Kind::Cube: {
            Wide gradient(0);
            gradient[static_cast<int>(face / 2)] = 1;
            return {p[static_cast<int>(face / 2)] - (face % 2 == 0 ? 1 : -1), gradient, false};
        }
        case Kind::Mesh: break;
    }
    const auto corner = [&](std::size_t c) {
        return Wide(mesh->positions[mesh->positionIndex[3 * face + c]]);
    };
    const Wide n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
    return {glm::dot(n, p - corner(0)), n, false};
}

// |F| over the most that F can be within the claimed box: at most 1 where the claim holds, infinite where a
// bound is negative.
long double shareOfBound(Kind kind, const MeshData* mesh, const Intersection& hit,
                         const WideInverse& inverse) {
    const Wide p = inverse.point(Wide(hit.position)), error = inverse.error(Wide(hit.positionError));
    const Equation f = equationAt(kind, hit.primitive, mesh, p);
    const Wide g(std::abs(f.gradient.x), std::abs(f.gradient.y), std::abs(f.gradient.z));
    if (!(error.x >= 0 && error.y >= 0 && error.z >= 0)) return std::numeric_limits<long double>::infinity();
    return std::abs(f.value) / (glm::dot(g, error) + (f.quadratic ? glm::dot(error, error) : 0));
}

std::vector<long double> sharesOfBound(Kind kind, std::shared_ptr<const MeshData> mesh,
                                       const Extents& extents, std::size_t count) {
    Random random(11);
    const Material material;
    std::vector<long double> shares;
    while (shares.size() < count) {
        const Affine affine = randomAffine(random, extents);
        const WideInverse inverse(affine);
        const auto shape = makeShape(kind, affine, material, mesh);
        for (int i = 0; i < 256; ++i) {
            const Wide target = placeOn(kind, mesh.get(), i % 8 == 0 ? Place::Edge : Place::Anywhere, random);
            const Wide from =
                target + Wide(random.direction()) * static_cast<long double>(random.magnitude(6));
            const Vec3 eye(pointToWorld(affine, from));
            const Intersection hit =
                shape->rayIntersect({eye, Vec3(pointToWorld(affine, target) - Wide(eye)), {}});
            if (hit.valid) shares.push_back(shareOfBound(kind, mesh.get(), hit, inverse));
        }
    }
    return shares;
}

constexpr int digits = std::numeric_limits<Real>::digits;
constexpr bool isWidest = digits == std::numeric_limits<long double>::digits;  // nothing is more accurate

// A large triangle around the origin, of coordinates that are exact in float.
std::shared_ptr<const MeshData> triangleAroundOrigin(Random& random) {
    auto mesh = std::make_shared<MeshData>();
    const auto corner = [&] { return glm::round(0x1p20 * random.box()) * 0x1p-20; };
    const glm::dvec3 a = corner(), b = corner();
    mesh->positions = {a, b, -(a + b) + glm::round(4.0 * random.box()) * 0x1p-20};
    mesh->positionIndex = {0, 1, 2};
    mesh->findBounds();
    return mesh;
}

void check(Kind kind) {
    if (isWidest) return;
    constexpr bool isFloat = digits < 32;
    const Extents varied = isFloat ? Extents{2, 2, 1} : Extents{4, 4, 6},
                  wild = isFloat ? Extents{8, 2, 8} : Extents{90, 6, 90};
    for (const Extents& extents : {varied, wild}) {
        std::vector<long double> shares = sharesOfBound(kind, roundMesh(), extents, 500000 / slowness);
        const auto percentile99 = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() * 99 / 100);
        std::nth_element(shares.begin(), percentile99, shares.end());
        const long double most = *std::max_element(percentile99, shares.end());
        INFO("sizes of 10^+-" << extents.size << ": at most " << most << " of the bound, 99 % "
                              << *percentile99);
        CHECK(most <= 1);
        CHECK(*percentile99 >= 0.01L);
    }
}

}  // namespace

TEST_CASE("the claimed bound on a hit's position holds and is tight: sphere") { check(Kind::Sphere); }
TEST_CASE("the claimed bound on a hit's position holds and is tight: plane") { check(Kind::Plane); }
TEST_CASE("the claimed bound on a hit's position holds and is tight: cylinder") { check(Kind::Cylinder); }
TEST_CASE("the claimed bound on a hit's position holds and is tight: cone") { check(Kind::Cone); }
TEST_CASE("the claimed bound on a hit's position holds and is tight: cube") { check(Kind::Cube); }
TEST_CASE("the claimed bound on a hit's position holds and is tight: mesh") { check(Kind::Mesh); }

TEST_CASE("the claimed bound on a hit's position holds where a triangle's corners cancel") {
    if (isWidest) return;
    Random random(12);
    const Material material;
    long double most = 0;
    int hits = 0;
    for (int i = 0; i < 2000 / slowness; ++i) {
        const auto mesh = triangleAroundOrigin(random);
        const Affine affine;
        const WideInverse inverse(affine);
        const auto shape = makeShape(Kind::Mesh, affine, material, mesh);
        for (int k = 0; k < 32; ++k) {
            const Vec3 target(random.box() * random.magnitude(2) * 0x1p-14), away(random.direction());
            const Intersection hit = shape->rayIntersect({target + away, -away, {}});
            if (!hit.valid) continue;
            ++hits;
            most = std::max(most, shareOfBound(Kind::Mesh, mesh.get(), hit, inverse));
        }
    }
    INFO("at most " << most << " of the bound");
    CHECK(hits > 20000 / slowness);
    CHECK(most <= 1);
}

// Products of three of the triangle's lengths underflow.
TEST_CASE("a point beside a tiny triangle of a large mesh does not touch it") {
    constexpr int least =
        std::max(std::numeric_limits<Real>::min_exponent, std::numeric_limits<double>::min_exponent);
    const double size = std::ldexp(1.0, least / 3 - 24);
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, 1}};
    mesh->positionIndex = {0, 1, 2, 0, 1, 3};
    mesh->findBounds();
    const Material material;
    const auto shape = makeShape(Kind::Mesh, Affine{}, material, mesh);
    const auto tiny = static_cast<Real>(size);
    for (const Real height : {Real(0), Real(0.5), Real(-0.5)}) {
        const Vec3 point(tiny / 4, tiny / 4, height * tiny);
        CHECK(shape->touches(point, Vec3(unitRoundoff * tiny), 0) == (height == 0));
    }
}
