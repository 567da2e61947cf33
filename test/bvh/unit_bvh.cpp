// The tree may discard but never decide: with it or without, and with any instruction set, pictures are the
// same to the last bit of every colour (src/README.md, invariant 2).
#include <algorithm>
#include <memory>
#include <random>

#include <catch2/catch.hpp>

#include "../support/ball_mesh.h"
#include "../support/scene_files.h"
#include "../support/slowness.h"
#include "raytracer/bvh/bvh.h"
#include "raytracer/scene/mesh_file.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

FloatImage picture(const SceneDescription& scene, Precision precision, const BuildOptions& options,
                   int longEdge) {
    return renderFloats(*makeRenderer(scene, precision, options), wholePicture(scene, longEdge));
}

// With packets of rays too, where the instruction set has them: without a tree there are none.
void checkAll(const SceneDescription& scene, int longEdge) {
    for (const Precision precision : {Precision::Double, Precision::Float, Precision::Extended}) {
        const FloatImage without = picture(scene, precision, {Accelerator::None, 0}, longEdge);
        // Long doubles have no lanes, and their trees are double's.
        const auto sets = precision == Precision::Extended ? std::vector{defaultInstructionSet()}
                                                           : supportedInstructionSets();
        for (const InstructionSet set : sets)
            CHECK(picture(scene, precision, {Accelerator::Bvh, 0, set}, longEdge).pixels == without.pixels);
    }
}

class Random {
  public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    glm::dvec3 inCube(double half) {
        return {between(-half, half), between(-half, half), between(-half, half)};
    }
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(between(0, static_cast<double>(n))); }

  private:
    std::mt19937 engine_;
};

// A camera at (0, 0, 3) that sees the unit cube, lights, and materials that are dull, a mirror and glass.
SceneDescription stage(bool glass) {
    SceneDescription scene;
    scene.camera.eye = {0, 0, 3};
    scene.camera.focal_length = 2;
    scene.lights = {{{3, 4, 5}, {0.7, 0.7, 0.6}, {0.2, 0.2, 0.2}}, {{-2, 1, 3}, {0.3, 0.3, 0.5}, {0, 0, 0}}};
    scene.materials.resize(3);
    scene.materials[1].reflective = true;
    scene.materials[2].refractive = glass;
    scene.materials[2].index_of_refraction = 1.4;
    return scene;
}

void addShape(SceneDescription& scene, ShapeType type, const TransformDescription& transform,
              std::size_t material, std::shared_ptr<const MeshData> mesh = nullptr) {
    scene.transforms.push_back(transform);
    scene.shapes.push_back({type, scene.transforms.size() - 1, material, std::move(mesh)});
}

TransformDescription randomTransform(Random& random, double size) {
    TransformDescription transform;
    transform.translate = random.inCube(1);
    transform.rotate = {random.between(0, 360), random.inCube(1)};
    transform.scale =
        glm::dvec3(random.between(0.05, 1), random.between(0.05, 1), random.between(0.05, 1)) * size;
    return transform;
}

void addRandomSolids(SceneDescription& scene, Random& random, int count) {
    using Type = ShapeType;
    constexpr Type types[] = {Type::Sphere, Type::Cylinder, Type::Cone, Type::Cube};
    for (int i = 0; i < count; ++i)
        addShape(scene, types[random.below(4)], randomTransform(random, 0.4), random.below(3));
}

// Triangles of all sizes, some of them slivers, some without an area.
std::shared_ptr<const MeshData> triangleSoup(Random& random, std::uint32_t count) {
    auto mesh = std::make_shared<MeshData>();
    for (std::uint32_t i = 0; i < 3 * count; ++i) mesh->positionIndex.push_back(i);
    for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 at = random.inCube(1), size(random.between(0, 1) < 0.1 ? 1 : 0.1);
        mesh->positions.push_back(at);
        mesh->positions.push_back(at + size * random.inCube(1));
        mesh->positions.push_back(i % 7 == 0   ? at
                                  : i % 5 == 0 ? at + 1e-6 * random.inCube(1)
                                               : at + size * random.inCube(1));
    }
    mesh->findBounds();
    return mesh;
}

std::shared_ptr<const MeshData> ball(std::uint32_t n) {
    return ballMesh(n, [](double, double) { return 1.0; });
}

}  // namespace

TEST_CASE("the scenes are the same with and without a tree") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        checkAll(loadScene(file).description, shortened(16));
    }
}

TEST_CASE("packets are the same whatever the samples, the depth and the terms") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        const auto without = makeRenderer(scene, Precision::Double, {Accelerator::None, 0});
        std::vector<std::unique_ptr<Renderer>> with;
        for (const InstructionSet set : supportedInstructionSets())
            with.push_back(makeRenderer(scene, Precision::Double, {Accelerator::Bvh, 0, set}));
        RenderOptions several = wholePicture(scene, shortened(14)), deep = several, plain = several;
        several.samples = 16, several.adaptive = 0.02, several.bilinear = true;
        deep.max_recursion = slowness > 1 ? 5 : 8, deep.cutoff = 0.01;
        plain.shadows = plain.refraction = false;
        plain.crop = {1, 1, plain.size.width * 2 / 3, std::max(2, plain.size.height / 2)};
        for (const RenderOptions& options : {several, deep, plain}) {
            FloatSink one(options.crop);
            const RenderCounts counts = without->render(options, one);
            for (const auto& renderer : with) {
                FloatSink packets(options.crop);
                const RenderCounts packetCounts = renderer->render(options, packets);
                CHECK(packets.image().pixels == one.image().pixels);
                CHECK(packetCounts.shadow == counts.shadow);
                CHECK(packetCounts.reflection == counts.reflection);
                CHECK(packetCounts.refraction == counts.refraction);
                CHECK(packetCounts.tests > 0);
                CHECK(packetCounts.tests < 2 * counts.tests);
                CHECK(packetCounts.cutoffBound == Approx(counts.cutoffBound).epsilon(1e-12));
            }
        }
    }
}

// Two meshes and a cube, one in another, in a mirror that is 10^15 times larger. From there, shapes that lie
// apart have the same t: which one is taken must not depend on the tree's order. Looking back along a ray,
// one finds triangles that the ray itself, rounded, does not meet.
TEST_CASE("what lies in a mirror 10^15 times larger is the same with and without a tree") {
    SceneDescription scene = loadScene(SOURCE_DIR "/test/bvh/far_mirror/scene.json").description;
    scene.lights[0].position *= 1e14;  // near the shapes it asks for more than double
    const FloatImage without = picture(scene, Precision::Double, {Accelerator::None, 0}, 100);
    for (const InstructionSet set : supportedInstructionSets())
        CHECK(picture(scene, Precision::Double, {Accelerator::Bvh, 0, set}, 100).pixels == without.pixels);
}

// A flat solid, aslant to an orthographic camera, so that some rays of a packet come from farther than
// distantSquared, in its thickness, and some from nearer.
TEST_CASE("a solid from which rays are distant and near is the same with and without a tree") {
    for (const double limit : {std::ldexp(1.0, 9), std::ldexp(std::sqrt(2.0), 19)})  // of float and double
        for (const ShapeType type :
             {ShapeType::Sphere, ShapeType::Cylinder, ShapeType::Cone, ShapeType::Cube}) {
            SceneDescription scene = stage(false);
            scene.camera.type = CameraDescription::Type::Orthographic;
            scene.camera.eye = limit * glm::dvec3(-1, 0, 1);
            scene.camera.look = {1, 0.1, -1};
            setFilm(scene, -limit, limit);
            for (LightDescription& light : scene.lights) light.position *= limit;
            addShape(scene, type, {"", {}, {}, glm::dvec3(limit, limit, 1), {}}, 0);
            checkAll(scene, 36);
        }
}

TEST_CASE("many solids are the same with and without a tree") {
    for (const bool glass : {false, true}) {
        Random random(7);
        SceneDescription scene = stage(glass);
        addRandomSolids(scene, random, 150);
        addShape(scene, ShapeType::Plane, {"", glm::dvec3(0, 0, -1), {}, {}, {}}, 0);
        checkAll(scene, 36);
    }
}

TEST_CASE("shapes that coincide, are tiny, vast or flat are the same with and without a tree") {
    Random random(8);
    SceneDescription scene = stage(true);
    addRandomSolids(scene, random, 20);
    for (const double size : {1e-9, 1e-4, 1e3, 1e9}) {
        TransformDescription transform;
        transform.translate = glm::dvec3(0, -0.5 - size, 0);
        transform.scale = glm::dvec3(size);
        for (const std::size_t material : {0, 1, 2})  // three in one place
            addShape(scene, ShapeType::Sphere, transform, material);
        transform.scale = glm::dvec3(size, 1e-7 * size, size);
        addShape(scene, ShapeType::Cube, transform, 0);
    }
    checkAll(scene, 36);
}

TEST_CASE("meshes are the same with and without a tree") {
    Random random(9);
    for (const auto& mesh : {triangleSoup(random, 400), ball(8), triangleSoup(random, 9)}) {
        SceneDescription scene = stage(true);
        for (const std::size_t material : {0, 1, 2})
            addShape(scene, ShapeType::Mesh, randomTransform(random, 1.5), material, mesh);
        checkAll(scene, 36);
    }
}

TEST_CASE("a mesh far from its own origin is the same with and without a tree") {
    Random random(10);
    for (const double distance : {1e3, 1e7}) {
        auto mesh = std::make_shared<MeshData>(*ball(6));
        for (glm::dvec3& p : mesh->positions) p += distance;
        mesh->findBounds();
        SceneDescription scene = stage(true);
        TransformDescription transform;
        transform.translate = glm::dvec3(-distance);
        addShape(scene, ShapeType::Mesh, transform, 2, mesh);
        addRandomSolids(scene, random, 30);
        checkAll(scene, 36);
    }
}

TEST_CASE(
    "a tree over many triangles, built by several threads, returns each of them to a ray through its "
    "middle") {
    Random random(11);
    const auto mesh = triangleSoup(random, 60000);
    for (const int threads : {1, 3}) {
        const Bvh bvh = Bvh::ofTriangles(*mesh, {Accelerator::Bvh, threads});
        int missing = 0;
        for (std::uint32_t triangle = 0; triangle < mesh->triangleCount(); triangle += 7) {
            const glm::dvec3* corner = &mesh->positions[3 * triangle];
            const glm::dvec3 middle = (corner[0] + corner[1] + corner[2]) / 3.0, origin = random.inCube(3);
            BvhCursor cursor(bvh, BvhRay{origin, middle - origin, 1e-14});
            REQUIRE(cursor.usable());
            bool found = false;
            while (!found && cursor.next(1 + 1e-9))
                found = std::ranges::count(cursor.primitives(), triangle) != 0;
            missing += !found;
        }
        CHECK(missing == 0);
    }
}

// The beam of rays that differ a little.
BvhBeam beamAround(std::span<const BvhRay> rays) {
    BvhBeam beam{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto range = [&](auto numberOf, double& low, double& high) {
            low = high = numberOf(rays[0]);
            for (const BvhRay& ray : rays)
                low = std::min(low, numberOf(ray)), high = std::max(high, numberOf(ray));
        };
        range([axis](const BvhRay& ray) { return ray.origin[axis]; }, beam.originLow[axis],
              beam.originHigh[axis]);
        range([axis](const BvhRay& ray) { return ray.direction[axis]; }, beam.directionLow[axis],
              beam.directionHigh[axis]);
    }
    beam.slack = rays[0].slack;
    return beam;
}

TEST_CASE("a beam meets whatever one of its rays does, with each instruction set") {
    Random random(12);
    const auto mesh = triangleSoup(random, 5000);
    std::vector<FloatBox> boxes;
    std::vector<std::uint32_t> names;
    for (std::uint32_t i = 0; i < mesh->triangleCount(); ++i) {
        FloatBox box;
        for (int axis = 0; axis < 3; ++axis) {
            const glm::dvec3* corner = &mesh->positions[3 * i];
            box.low[axis] = floatBelow(std::min({corner[0][axis], corner[1][axis], corner[2][axis]}));
            box.high[axis] = floatAbove(std::max({corner[0][axis], corner[1][axis], corner[2][axis]}));
        }
        boxes.push_back(box);
        names.push_back(i);
    }
    for (const InstructionSet set : supportedInstructionSets()) {
        const BuildOptions options{Accelerator::Bvh, 0, set};
        const Bvh trees[2] = {Bvh::ofTriangles(*mesh, options), Bvh::ofBoxes(boxes, names, options)};
        for (const Bvh& tree : trees) {
            int used = 0, missing = 0;
            for (int n = 0; n < 3000; ++n) {
                const glm::dvec3* corner = &mesh->positions[3 * random.below(mesh->triangleCount())];
                const glm::dvec3 middle = (corner[0] + corner[1] + corner[2]) / 3.0,
                                 origin = random.inCube(3);
                const auto triangle = static_cast<std::uint32_t>((corner - mesh->positions.data()) / 3);
                // The first goes through the triangle's middle, the others anywhere near.
                std::vector<BvhRay> rays{{origin, middle - origin, 1e-14}};
                const double spread = std::pow(10, random.between(-8, -1));
                for (int i = 0; i < 7; ++i) {
                    const glm::dvec3 from = origin + random.inCube(spread);
                    rays.push_back({from, middle + random.inCube(spread) - from, 1e-14});
                }
                BvhCursor cursor(tree, beamAround(rays));
                if (!cursor.usable()) continue;
                ++used;
                bool found = false;
                while (!found && cursor.next(1 + 1e-9))
                    found = std::ranges::count(cursor.primitives(), triangle) != 0;
                missing += !found;
            }
            CHECK(used > 1000);
            CHECK(missing == 0);
            const BvhRay wide[2] = {{{-3, 0, 0}, {1, 0.1, 0.1}},
                                    {{-3, 0, 0}, {1, 0.9, 0.1}}};  // follow them one at a time
            CHECK_FALSE(BvhCursor(tree, beamAround(wide)).usable());
        }
    }
}

TEST_CASE("a tree is no use for rays that are out of all proportion, or part") {
    const FloatBox boxes[2] = {{{0, 0, 0}, {1, 1, 1}}, {{2, 0, 0}, {3, 1, 1}}};
    const Bvh bvh = Bvh::ofBoxes(boxes, std::vector<std::uint32_t>{0, 1});
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    CHECK(BvhCursor(bvh, BvhRay{{0, 0, 0}, {1, 0, 0}}).usable());
    CHECK_FALSE(BvhCursor(bvh, BvhRay{{0, 0, 0}, {0, 0, 0}}).usable());
    CHECK_FALSE(BvhCursor(bvh, BvhRay{{0, nan, 0}, {1, 0, 0}}).usable());
    CHECK_FALSE(BvhCursor(bvh, BvhRay{{0, 0, 0}, {1, nan, 0}}).usable());
    CHECK_FALSE(BvhCursor(bvh, BvhRay{{infinity, 0, 0}, {1, 0, 0}}).usable());
    CHECK_FALSE(BvhCursor(bvh, BvhRay{{1e30, 0, 0}, {1, 0, 0}}).usable());
    CHECK_FALSE(BvhCursor(bvh, BvhRay{{0, 0, 0}, {infinity, 0, 0}}).usable());
    const auto isUsable = [&](const BvhRay& a, const BvhRay& b) {
        const BvhRay rays[2] = {a, b};
        return BvhCursor(bvh, beamAround(rays)).usable();
    };
    CHECK(isUsable({{0, 0, 0}, {1, 0.1, 0.1}}, {{0, 0, 0}, {1, 0.2, 0.1}}));
    CHECK_FALSE(isUsable({{0, 0, 0}, {1, 0.1, 0.1}}, {{0, 0, 0}, {1, -0.1, 0.1}}));
    CHECK_FALSE(isUsable({{0, 0, 0}, {1, nan, 0.1}}, {{0, 0, 0}, {1, 0.1, 0.1}}));
    CHECK_FALSE(isUsable({{infinity, 0, 0}, {1, 0.1, 0.1}}, {{infinity, 0, 0}, {1, 0.1, 0.1}}));
}
