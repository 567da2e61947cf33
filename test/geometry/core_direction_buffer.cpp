// A direction buffer discards no hit: the answers are those of a list of all shapes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "../support/core_random.h"
#include "../support/slowness.h"
#include "raytracer/geometry/shape_tree.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

struct RandomScene {
    std::vector<Affine> affines;
    std::vector<Shape> shapes;

    RandomScene(Random& random, const Material& material, const std::shared_ptr<const MeshData>& mesh) {
        const int count = 1 + random.below(random.below(4) == 0 ? 64 : 12);
        for (int i = 0; i < count; ++i) {
            const Kind kind = i == 0 ? Kind::Sphere : allKinds[static_cast<std::size_t>(random.below(6))];
            affines.push_back(randomAffine(random, {1, 1, 1}));
            shapes.push_back(*makeShape(kind, affines.back(), material, kind == Kind::Mesh ? mesh : nullptr,
                                        static_cast<std::uint32_t>(i)));
        }
    }

    // On a shape, often at its silhouette or an edge.
    Vec3 place(Random& random, const MeshData& mesh) const {
        const auto i = static_cast<std::size_t>(random.below(static_cast<int>(shapes.size())));
        return Vec3(pointToWorld(
            affines[i],
            placeOn(shapes[i].type(), &mesh, random.below(2) ? Place::Edge : Place::Anywhere, random)));
    }

    // Anywhere, within a shape, or far from all: as far as there are buffers.
    Vec3 point(Random& random) const {
        const double decades = std::min(300.0, std::log10(static_cast<double>(widestRange / 2)));
        if (random.below(4) == 0) return shapes[0].transform().translation();
        if (random.below(4) == 0)
            return Vec3(random.direction() * std::pow(10, random.between(2, random.below(2) ? 5 : decades)));
        return Vec3(random.box() * random.magnitude(2));
    }
};

bool areEqual(const HitQuery& a, const HitQuery& b) {
    if (a.found() != b.found()) return false;
    const Hit one = a.nearest(), other = b.nearest();
    return a.found() == 0 || (one.t <= other.t && other.t <= one.t && one.shape == other.shape);
}

struct Counts {
    int hits = 0, wrong = 0;
};

// test(scene, with a buffer for rays to or from point, list, point, counts)
template <class Test>
Counts inRandomScenes(std::uint64_t seed, Test test) {
    Random random(seed);
    const Material material;
    const std::shared_ptr<const MeshData> mesh = roundMesh();
    Counts counts;
    for (int i = 0; i < 1000 / slowness; ++i) {
        const RandomScene scene(random, material, mesh);
        const ShapeTree tree(scene.shapes, {}), list(scene.shapes, {.accelerator = Accelerator::None});
        const Vec3 point = scene.point(random);
        for (int ray = 0; ray < 200; ++ray)
            test(tree, list, point, scene.place(random, *mesh), random, counts);
    }
    return counts;
}

}  // namespace

TEST_CASE("rays from an eye hit with a direction buffer what they hit in a list") {
    Vec3 eye(infinity);
    DirectionBuffer buffer;
    const Counts counts =
        inRandomScenes(41, [&](const ShapeTree& tree, const ShapeTree& list, const Vec3& point,
                               const Vec3& target, Random& random, Counts& sums) {
            if (eye != point) {
                eye = point;
                buffer = tree.fromEye(eye);
                REQUIRE(!buffer.empty());
            }
            const Ray ray{eye, static_cast<Real>(random.magnitude(3)) * (target - eye), {}};
            HitQuery some, all;
            buffer.meet(ray, some);
            list.meet(ray, all);
            sums.hits += all.found() != 0;
            sums.wrong += !areEqual(some, all);
        });
    CHECK(counts.hits > 100000 / slowness);
    CHECK(counts.wrong == 0);
}

TEST_CASE("rays to a light hit with a direction buffer what they hit in a list") {
    Vec3 light(infinity);
    DirectionBuffer buffer;
    const Counts counts =
        inRandomScenes(42, [&](const ShapeTree& tree, const ShapeTree& list, const Vec3& point,
                               const Vec3& target, Random& random, Counts& sums) {
            if (light != point) {
                light = point;
                buffer = tree.toLight(light);
                REQUIRE(!buffer.empty());
            }
            // From the target, or through it from a point behind it; sometimes from very far away.
            const double behind = random.below(8) == 0 ? 1e6 : random.below(2) * random.uniform();
            const Vec3 origin = target + static_cast<Real>(behind) * (target - light);
            const bool any = random.below(2) == 0;
            HitQuery some(light, any), all(light, any);
            const Ray ray{origin, light - origin, {}};
            buffer.meet(ray, some);
            list.meet(ray, all);
            sums.hits += all.found() != 0;
            sums.wrong += any ? some.found() != all.found() : !areEqual(some, all);
        });
    CHECK(counts.hits > 100000 / slowness);
    CHECK(counts.wrong == 0);
}

TEST_CASE("there is no direction buffer of a point so far away that its numbers could overflow") {
    const Material material;
    const std::vector<Shape> shapes{*makeShape(Kind::Sphere, Affine(), material, nullptr, 0)};
    const ShapeTree tree(shapes, {});
    for (const Real far : {2 * widestRange, std::numeric_limits<Real>::max(), infinity}) {
        CHECK(tree.fromEye(Vec3(0, far, 0)).empty());
        CHECK(tree.toLight(Vec3(0, far, 0)).empty());
    }
}
