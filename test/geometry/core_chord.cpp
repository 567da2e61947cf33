// Chords by any direction that a transform can make of a ray: none recurses without end.
#include <catch2/catch.hpp>

#include "raytracer/geometry/cone.h"
#include "raytracer/geometry/cube.h"
#include "raytracer/geometry/cylinder.h"
#include "raytracer/geometry/sphere.h"

using namespace raytracer;

namespace {

template <class Kind>
void checkAnyDirection() {
    using Limits = std::numeric_limits<Real>;
    const Real sizes[] = {0,
                          1,
                          -1,
                          Limits::denorm_min(),
                          Limits::min(),
                          Limits::max(),
                          infinity,
                          -infinity,
                          Limits::quiet_NaN()};
    for (const Real x : sizes)
        for (const Real y : sizes)
            for (const Real z : sizes)
                for (const Real origin : {Real(0), Real(0.5), Real(3), Limits::max(), infinity}) {
                    const Chord<Real> chord = Kind::chordOf(ObjectRay{Vec3(0, 0, origin), Vec3(x, y, z)});
                    INFO(x << ' ' << y << ' ' << z << " from " << origin);
                    CHECK_FALSE((chord.hit && chord.entry > chord.exit));
                }
}

}  // namespace

TEST_CASE("chord: a direction that is zero, infinite, no number or of any size") {
    checkAnyDirection<Sphere>();
    checkAnyDirection<Cylinder>();
    checkAnyDirection<Cone>();
}

TEST_CASE("chord: t counts in a direction of any size") {
    for (const int exponent : {-1, 1}) {
        const Real size = std::scalbn(Real(1), exponent * (std::numeric_limits<Real>::max_exponent - 4));
        const ObjectRay ray{Vec3(0, 0, 3), size * Vec3(0, 0, -2)};
        const Real unit = Real(0.5) / size;
        const Chord<Real> ball = Sphere::chordOf(ray), cone = Cone::chordOf(ray);
        CHECK(ball.hit);
        CHECK(ball.entry == 2 * unit);
        CHECK(ball.exit == 4 * unit);
        CHECK(cone.hit);
        CHECK(std::abs(cone.entry - 2 * unit) <= gamma(8) * 2 * unit);
        CHECK(std::abs(cone.exit - 3 * unit) <= gamma(8) * 3 * unit);
    }
}

TEST_CASE("chord: where two faces are met at once, the first one is") {
    for (const Real x : {Real(-1), Real(1)})
        for (const Real y : {Real(-1), Real(1)}) {
            const ObjectRay ray{Real(-3) * Vec3(x, y, 0), Vec3(x, y, 0)};
            const Chord<Real> cube = Cube::chordOf(ray),
                              corner = Cube::chordOf(ObjectRay{Vec3(0), Vec3(x, y, 1)});
            CHECK(cube.entryFace == (x < 0 ? 0 : 1));  // of +x, -x, +y, -y, +z, -z
            CHECK(cube.exitFace == (x > 0 ? 0 : 1));
            CHECK(corner.exitFace == (x > 0 ? 0 : 1));
        }
    for (const Real z : {Real(-1), Real(1)}) {
        const Chord<Real> rim = Cylinder::chordOf(ObjectRay{Vec3(0, 0, Real(0.5)), Vec3(2, 0, z)});
        CHECK(rim.exit == Real(0.5));
        CHECK(rim.exitFace == 0);  // the body
    }
}

TEST_CASE("chord: a line in the plane of a cap passes, one in the plane of a cube's face meets other faces") {
    for (const Real z : {Real(0), Real(1)}) {
        CHECK_FALSE(Cylinder::chordOf(ObjectRay{Vec3(-3, 0, z), Vec3(1, 0, 0)}).hit);
        CHECK(Cylinder::chordOf(ObjectRay{Vec3(-3, 0, Real(0.5) + z / 4), Vec3(1, 0, 0)}).hit);
    }
    CHECK_FALSE(Cone::chordOf(ObjectRay{Vec3(-3, 0, 0), Vec3(1, 0, 0)}).hit);
    CHECK_FALSE(Cylinder::chordOf(ObjectRay{Vec3(1, 0, -3), Vec3(0, 0, 1)}).hit);  // along the body
    for (const Real x : {Real(-1), Real(1)}) {
        const Chord<Real> chord = Cube::chordOf(ObjectRay{Vec3(x, 0, 3), Vec3(0, 0, -1)});
        CHECK(chord.hit);
        CHECK(chord.entry == 2);
        CHECK(chord.exit == 4);
    }
}

// A thin solid from afar: both faces have one t, rounded.
TEST_CASE("chord: of two faces with one t the entry faces the ray") {
    const Real far = 4 / (unitRoundoff * unitRoundoff);
    for (const Real side : {Real(-1), Real(1)})
        for (const Real aslant : {Real(0), Real(0.1)}) {
            const ObjectRay ray{Vec3(-aslant, 0, far * side), Vec3(aslant, 0, -far * side)};
            const Chord<Real> cube = Cube::chordOf(ray), cylinder = Cylinder::chordOf(ray);
            CHECK(cube.entry == cube.exit);
            CHECK(cube.entryFace == (side > 0 ? 4 : 5));
            CHECK(cylinder.entryFace == (side > 0 ? 1 : 2));
        }
}

// The eye may be nearer to the base than a rounding of the cone's size.
TEST_CASE("chord: a cone's base is where the ray's own origin sees it") {
    const Real near = unitRoundoff * unitRoundoff;
    for (const Real side : {Real(-1), Real(1)}) {
        const ObjectRay ray{Vec3(Real(0.3), Real(0.2), side * near), Vec3(Real(0.1), 0, -side)};
        const Chord<Real> chord = Cone::chordOf(ray);
        CHECK((side < 0 ? chord.entryFace : chord.exitFace) == 1);
        CHECK((side < 0 ? chord.entry : chord.exit) == near);
    }
}

// One root is infinite.
TEST_CASE("chord: a line parallel to a cone's side") {
    const Chord<Real> chord = Cone::chordOf(ObjectRay{Vec3(-2, 0, Real(2.5)), Vec3(1, 0, -1)});
    CHECK(chord.hit);
    CHECK(chord.entry == Real(1.75));
    CHECK(chord.exit == Real(2.5));
}

// The squares of its distance overflow.
TEST_CASE("chord: a line that passes very far away does not hit") {
    const Real far = std::sqrt(std::numeric_limits<Real>::max()) * 16;
    for (const Real slope : {Real(0), Real(0.001), Real(0.5)}) {
        const ObjectRay ray{Vec3(far, far, far / 2), Vec3(slope, 0, 1)};
        CHECK_FALSE(Cone::chordOf(ray).hit);
        CHECK_FALSE(Cylinder::chordOf(ray).hit);
        CHECK_FALSE(Cube::chordOf(ray).hit);
        CHECK_FALSE(Sphere::chordOf(ray).hit);
    }
}
