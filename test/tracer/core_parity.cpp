// From outside a solid a line enters and leaves it in turn and is outside at last, wherever it is aimed: at
// rims, cap edges, edges and corners, the apex, silhouettes. (Meshes: core_watertight.cpp.)
#include <catch2/catch.hpp>

#include "../support/core_random.h"
#include "raytracer/tracer/shading.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

struct Parity {
    std::uint64_t lines = 0, met = 0;
    std::uint64_t wrongSide = 0;  // entered when inside, or left when outside
    std::uint64_t odd = 0;        // went on for ever, or ended inside
};

// The direction of steepest ascent, of offsetOf.
Wide normalAt(Kind kind, const Wide& p) {
    constexpr long double step = 1e-6L;
    Wide n;
    for (int axis = 0; axis < 3; ++axis) {
        Wide by(0);
        by[axis] = step;
        n[axis] = offsetOf(kind, p + by) - offsetOf(kind, p - by);
    }
    return n / std::sqrt(glm::dot(n, n));
}

// A point of the surface and a direction in which a line passes through it.
struct Aim {
    Wide target, way;
};

Aim randomAim(Kind kind, Random& random) {
    const int what = random.below(3);
    const Place place = what == 0 ? Place::Edge : what == 1 ? Place::Corner : Place::Anywhere;
    Aim aim{placeOn(kind, nullptr, place, random), Wide(random.direction())};
    if (place != Place::Anywhere) return aim;
    const Wide n = normalAt(kind, aim.target);
    aim.way -= glm::dot(aim.way, n) * n;
    return aim;
}

void follow(const Shape& shape, Ray ray, Parity& parity) {
    ++parity.lines;
    bool inside = false;
    for (int crossings = 0; crossings < 4; ++crossings) {
        const Intersection hit = shape.rayIntersect(ray);
        parity.met += crossings == 0 && hit.valid;
        if (!hit.valid) {
            parity.odd += inside;
            return;
        }
        parity.wrongSide += hit.entering == inside;
        inside = hit.entering;
        ray = ShadingPoint(ray, hit, false).leave(ray.direction, ShadingPoint::Side::Far);
    }
    ++parity.odd;
}

// From eyes that are outside by more than their place is rounded by.
void checkParity(Kind kind) {
    constexpr bool isFloat = std::numeric_limits<Real>::digits < 32;
    constexpr Extents extents = isFloat ? Extents{1, 1, 1} : Extents{4, 2, 4};
    constexpr double farthest = isFloat ? 2 : 6;  // decades
    constexpr std::uint64_t count = std::numeric_limits<Real>::digits == 53 ? 100000 : 20000;
    Random random(5);
    const Material material;
    Parity parity;
    while (parity.lines < count) {
        const Affine affine = randomAffine(random, extents);
        const WideInverse inverse(affine);
        const auto shape = makeShape(kind, affine, material);
        for (int i = 0; i < 256; ++i) {
            const Aim aim = randomAim(kind, random);
            const Vec3 eye(pointToWorld(
                affine,
                aim.target - static_cast<long double>(std::pow(10, random.between(-2, farthest))) * aim.way));
            if (offsetOf(kind, inverse.point(Wide(eye))) > 1e-3L)
                follow(*shape, {eye, Vec3(pointToWorld(affine, aim.target) - Wide(eye)), {}}, parity);
        }
    }
    INFO(parity.lines << " lines, of which " << parity.met << " met the solid");
    CHECK(parity.met * 5 > parity.lines);
    CHECK(parity.wrongSide == 0);
    CHECK(parity.odd == 0);
}

}  // namespace

TEST_CASE("parity: sphere") { checkParity(Kind::Sphere); }
TEST_CASE("parity: cylinder") { checkParity(Kind::Cylinder); }
TEST_CASE("parity: cone") { checkParity(Kind::Cone); }
TEST_CASE("parity: cube") { checkParity(Kind::Cube); }

// Solids are closed: a line that touches one in a single point of a rim or an edge meets it, though the
// roundings of the two faces' t would have it leave before it enters.
TEST_CASE("parity: a rim or an edge met in a single point is met") {
    const Material material;
    Random random(6);
    for (const Kind kind : {Kind::Cylinder, Kind::Cone, Kind::Cube}) {
        const auto shape = makeShape(kind, Affine{}, material);
        int missed = 0;
        for (int i = 0; i < 10000; ++i) {
            const Wide rim =
                kind == Kind::Cube ? Wide(1, random.between(-1, 1), -1) : circle(random.uniform());
            const Wide outwards = kind == Kind::Cube ? Wide(1, 0, 0) : rim;
            // Outwards and upwards from below the solid, across the rim of its lower side.
            const long double steep = random.between(0.1, 3);
            const Wide eye = rim - outwards - Wide(0, 0, steep);
            const Vec3 origin(eye);
            missed += !shape->rayIntersect({origin, Vec3(rim - Wide(origin)), {}}).valid;
        }
        INFO(nameOf(kind));
        CHECK(missed == 0);
    }
}

// From afar, too: past a rim or an edge by more than the line's own rounding there is nothing.
TEST_CASE("parity: a distant solid is not fatter than its lines are rounded") {
    const Material material;
    Random random(7);
    const long double far = std::scalbn(1.0L, 2 * std::numeric_limits<Real>::digits / 3);
    const long double rounding = 4 * far * static_cast<long double>(unitRoundoff);
    for (const Kind kind : {Kind::Cylinder, Kind::Cone, Kind::Cube}) {
        const auto shape = makeShape(kind, Affine{}, material);
        int met = 0, missed = 0;
        for (int i = 0; i < 1000; ++i) {
            const Wide rim =
                kind == Kind::Cube ? Wide(1, random.between(-1, 1), -1) : circle(random.uniform());
            const Wide outwards = kind == Kind::Cube ? Wide(1, 0, 0) : rim, way = outwards + Wide(0, 0, 1);
            for (const int side : {-1, 1}) {
                const Wide target = rim + side * rounding * outwards;
                const Vec3 origin(target - far * way);
                const bool valid = shape->rayIntersect({origin, Vec3(target - Wide(origin)), {}}).valid;
                met += valid && side > 0;
                missed += !valid && side < 0;
            }
        }
        INFO(nameOf(kind));
        CHECK(met == 0);
        CHECK(missed == 0);
    }
}
