// A ray of the camera that starts on a surface meets it there, whatever its direction and the shape's pose.
#include <catch2/catch.hpp>

#include "../support/core_random.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

// Of float, as much as its digits cover.
constexpr Extents originPoses = std::numeric_limits<Real>::digits < 32 ? Extents{1, 1, 0} : Extents{2, 2, 2};

// In an edge of a mesh the exact test of a line decides which triangle it meets.
Place somewhere(Kind kind, Random& random) {
    return kind == Kind::Mesh ? Place::Anywhere : static_cast<Place>(random.below(3));
}

// Through a mesh: a line that grazes it may pass its triangle by.
Vec3 someDirection(Kind kind, const Affine& affine, const Vec3& eye, Random& random) {
    if (kind != Kind::Mesh) return Vec3(random.direction());
    return Real(random.sign()) * (Vec3(pointToWorld(affine, placeInside(random))) - eye);
}

// Rays from a place that do not meet it, or in another face than the others.
int strayRays(const Shape& shape, const Affine& affine, const Vec3& eye, Random& random) {
    int stray = 0;
    std::optional<std::uint32_t> face;
    for (int i = 0; i < 20; ++i) {
        const Vec3 direction = someDirection(shape.type(), affine, eye, random);
        const Intersection hit = shape.rayIntersect({eye, direction, {}});
        if (hit.valid && !face) face = hit.primitive;
        stray += !hit.valid || hit.t != 0 || hit.primitive != *face;
    }
    return stray;
}

void checkOrigin(Kind kind) {
    const Material material;
    const auto mesh = kind == Kind::Mesh ? roundMesh() : nullptr;
    Random random(9);
    int stray = 0;
    for (int pose = 0; pose < 100; ++pose) {
        const Affine affine = pose == 0 ? Affine{} : randomAffine(random, originPoses);
        const auto shape = makeShape(kind, affine, material, mesh);
        for (int i = 0; i < 20; ++i) {
            const Wide place = placeOn(kind, mesh.get(), somewhere(kind, random), random);
            stray += strayRays(*shape, affine, Vec3(glm::dvec3(pointToWorld(affine, place))), random);
        }
    }
    INFO(nameOf(kind));
    CHECK(stray == 0);
}

}  // namespace

TEST_CASE("origin: a ray that starts on a surface meets it there") {
    for (const Kind kind : allKinds) checkOrigin(kind);
}

TEST_CASE("origin: a ray that starts on a plane, as far from zero as the plane's middle, but opposite") {
    const Material material;
    Random random(11);
    int stray = 0;
    for (int pose = 0; pose < 100; ++pose) {
        TransformDescription description;
        description.rotate = TransformDescription::Rotation{random.between(0, 360), random.direction()};
        description.translate =
            glm::dvec3(pointToWorld(compose(description), Wide(random.uniform(), random.uniform(), 0)));
        const Affine affine = compose(description);
        stray += strayRays(*makeShape(Kind::Plane, affine, material), affine, -Vec3(*description.translate),
                           random);
    }
    CHECK(stray == 0);
}

TEST_CASE("origin: it enters or leaves by the direction alone") {
    const Material material;
    const auto cone = makeShape(Kind::Cone, Affine{}, material);
    Random random(10);
    for (int i = 0; i < 100; ++i) {
        const Vec3 direction(random.direction());
        const Intersection base = cone->rayIntersect({Vec3(Real(0.2), Real(0.1), 0), direction, {}});
        CHECK(base.primitive == 1);
        CHECK(base.entering == (direction.z > 0));
    }
}
