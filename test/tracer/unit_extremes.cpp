// A picture depends neither on the unit of length nor on where the origin lies; and no number that a scene
// may hold makes it anything but a picture.
#include <algorithm>
#include <catch2/catch.hpp>

#include "../support/described.h"
#include "../support/slowness.h"
#include "raytracer/scene/mesh_file.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

std::vector<int> exponentsBetween(int first, int last, int step) {
    std::vector<int> exponents;
    for (int exponent = first; exponent <= last; exponent += step) exponents.push_back(exponent);
    return exponents;
}

void checkPowersOfTwo(Precision precision, const std::vector<int>& exponents, int longEdge) {
    for (const std::string& file : sceneFiles()) {
        const SceneDescription scene = loadScene(file).description;
        const ByteImage plain = bytesOf(scene, longEdge, precision);
        for (const int exponent : exponents) {
            INFO(file << " times 2^" << exponent << " in " << precisionName(precision));
            CHECK(bytesOf(scaled(scene, std::ldexp(1.0, exponent)), longEdge, precision).pixels ==
                  plain.pixels);
        }
    }
}

// With a cube far away to either side, where no ray is likely to meet it. The scene's extent is then theirs,
// and with it the unit in which it is computed, however small the rest of it is.
SceneDescription betweenFarCubes(SceneDescription scene, double distance) {
    for (const double side : {-distance, distance}) {
        scene.transforms.push_back(
            {"", side * glm::dvec3(0.48, 0.6, 0.64), {}, glm::dvec3(distance * 0x1p-20), {}});
        scene.shapes.push_back({ShapeType::Cube, scene.transforms.size() - 1, 0, nullptr});
    }
    return scene;
}

// How far the scene reaches from the camera: what translations are measured in.
double sizeOf(const SceneDescription& scene) {
    double largest = 1e-3;
    for (const LightDescription& light : scene.lights)
        largest = std::max(largest, glm::distance(light.position, scene.camera.eye));
    return largest;
}

// Of 10,000 pixels, those that differ from extended precision's by more than 1 of 255, on the very same
// numbers.
struct Tally {
    int wrong = 0, pixels = 0;

    void add(const SceneDescription& scene, const ByteImage& reference,
             Precision precision = Precision::Double) {
        const ByteImage image = bytesOf(scene, std::max(reference.width, reference.height), precision);
        wrong += differingPixels(image, reference, 1);
        pixels += image.width * image.height;
    }
    void check() const {
        INFO(wrong << " of " << pixels << " pixels");
        CHECK(wrong * 10000 <= pixels);
    }
};

}  // namespace

TEST_CASE("a scene times a power of two is the same picture to the byte") {
    checkPowersOfTwo(Precision::Double, exponentsBetween(-300, 300, 25),
                     40);  // odd and even: a root is taken of some
}

TEST_CASE("a scene times a power of two is the same picture in float") {
    checkPowersOfTwo(Precision::Float, exponentsBetween(-30, 30, 1), 16);
}

// The unit stays, so all numbers of the arithmetic change, and a constant among them shows.
TEST_CASE("a scene times a power of two is the same picture beside what stays as it is") {
    const auto check = [](Precision precision, double distance, const std::vector<int>& exponents) {
        for (const std::string& file : sceneFiles()) {
            const SceneDescription scene = loadScene(file).description;
            const ByteImage plain = bytesOf(scene, 24, precision);
            for (const int exponent : exponents) {
                INFO(file << " times 2^" << exponent << " in " << precisionName(precision));
                const SceneDescription other =
                    betweenFarCubes(scaled(scene, std::ldexp(1.0, exponent)), distance);
                CHECK(bytesOf(other, 24, precision).pixels == plain.pixels);
            }
        }
    };
    check(Precision::Double, 0x1p330, {-300, -100, -20, 0, 40, 300});
    check(Precision::Float, 0x1p45, {-20, -5, 0, 15, 30});
}

// Double in every scene; float in all of them together.
TEST_CASE("a scene times a power of ten is what extended precision makes of it") {
    Tally inFloat;
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        Tally tally;
        for (int exponent = -12; exponent <= 12; exponent += slowness > 1 ? 6 : 1) {
            const SceneDescription other = scaled(scene, std::pow(10, exponent));
            const ByteImage reference = bytesOf(other, 45, Precision::Extended);
            tally.add(other, reference);
            inFloat.add(other, reference, Precision::Float);
        }
        tally.check();
    }
    inFloat.check();
}

// An orthographic picture does not depend on how far away the camera is.
TEST_CASE("a far camera sees what a near one sees, or it is told that it may not") {
    SceneDescription scene;
    scene.camera.type = CameraDescription::Type::Orthographic;
    scene.camera.look = {0, 0, -1};
    scene.lights = {{{2, 3, 4}, glm::dvec3(0.8), glm::dvec3(0.2)}};
    scene.materials.resize(1);
    scene.transforms.resize(1);
    scene.shapes = {{ShapeType::Sphere, 0, 0, nullptr}};
    scene.camera.eye = {0, 0, 5};
    const ByteImage near = bytesOf(scene, 24);
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended})
        for (int exponent = 1; exponent <= 30; ++exponent) {
            CAPTURE(exponent);
            scene.camera.eye.z = std::pow(10, exponent);
            const bool fits = makeRenderer(scene, precision)->fits();
            CHECK(fits == (exponent <= 15));
            if (fits) CHECK(differingPixels(bytesOf(scene, 24, precision), near, 1) == 0);
        }
}

// A plane is the same wherever along itself its origin lies, as is a floor of two triangles however large.
TEST_CASE("a floor whose numbers are large is the same floor, or it is told that it may not be") {
    SceneMaker make;
    make.scene.camera.type = CameraDescription::Type::Perspective;
    make.scene.camera.focal_length = 1.5;
    make.scene.camera.eye = {0, 0, 4};
    make.material(glm::dvec3(0)).color_diffuse = glm::dvec3(1);
    make.shape(ShapeType::Plane, {});
    make.light({-1, 1, 2});
    const ByteImage plain = bytesOf(make.scene, 16);
    const auto check = [&](const SceneDescription& scene, int exponent, int farthest) {
        CAPTURE(exponent);
        for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended}) {
            const bool fits = makeRenderer(scene, precision)->fits();
            CHECK(fits == (exponent <= farthest));
            if (fits) CHECK(differingPixels(bytesOf(scene, 16, precision), plain, 1) == 0);
        }
    };
    const auto floor = std::make_shared<MeshData>();
    floor->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    floor->positionIndex = {0, 1, 2, 0, 2, 3};
    floor->findBounds();
    for (int exponent = 1; exponent <= 30; ++exponent) {
        const double size = std::pow(10, exponent);
        SceneDescription moved = make.scene, mesh = make.scene;
        moved.transforms[0].translate = {size, 0, 0};
        check(moved, exponent, 15);
        moved.lights[0].position *= size;  // a light far away says nothing of what the eye sees
        CHECK(makeRenderer(moved, Precision::Double)->fits() == (exponent <= 15));
        moved.lights.clear();
        CHECK(makeRenderer(moved, Precision::Double)->fits() == (exponent <= 15));
        mesh.shapes[0] = {ShapeType::Mesh, 0, 0, floor};
        mesh.transforms[0].scale = glm::dvec3(size);
        check(mesh, exponent, 15);
    }
}

// The products of a needle's extents may be beyond double where its length is not.
TEST_CASE("a mesh of needles is what extended precision makes of it") {
    SceneMaker make;
    make.scene.camera.eye = {0, 0, 4};
    make.scene.camera.focal_length = 1;
    make.material(glm::dvec3(0)).color_diffuse = glm::dvec3(1);
    const auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{1, 0, 0}, {-1, 0, 0}, {6e254, 1, 0}, {0, 7e174, 0}, {0, 0, 1}, {0, 0, -7e140}};
    mesh->positionIndex = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    mesh->findBounds();
    mesh->chooseUnit();
    TransformDescription turned;
    turned.rotate = TransformDescription::Rotation{66, {-1, 0.35, 0.1}};
    make.shape(ShapeType::Mesh, turned);
    make.scene.shapes[0].mesh = mesh;
    make.light({1, 2, 5});
    CHECK(differingPixels(bytesOf(make.scene, 16), bytesOf(make.scene, 16, Precision::Extended), 1) == 0);
}

// A point of the ray is put onto a sphere or a cone: of one that is too flat for that, anywhere.
TEST_CASE("a sphere or a cone that is flat is what extended precision makes of it, or it is told") {
    for (const ShapeType type : {ShapeType::Sphere, ShapeType::Cone})
        for (int exponent = 1; exponent <= 60; ++exponent) {
            CAPTURE(static_cast<int>(type), exponent);
            SceneMaker make;
            make.material(glm::dvec3(0)).color_diffuse = glm::dvec3(1);
            TransformDescription flat;
            flat.scale = {1, 1, std::pow(10, -exponent)};
            make.shape(type, flat);
            make.light({1, 2, 3});
            const auto renderer = makeRenderer(make.scene, Precision::Double);
            CHECK(renderer->fits() == (exponent <= 14));
            if (renderer->fits())
                CHECK(differingPixels(bytesOf(make.scene, 16), bytesOf(make.scene, 16, Precision::Extended),
                                      1) == 0);
        }
}

namespace {

// Each makes a number of the camera, or of the first shape's transform, that large.
constexpr void (*stretches[])(SceneDescription& scene, double factor) = {
    [](SceneDescription& scene, double factor) { scene.camera.eye.z = factor; },
    [](SceneDescription& scene, double factor) { scene.camera.up.z = -factor; },
    [](SceneDescription& scene, double factor) { scene.camera.look = glm::dvec3(1, factor, -2); },
    [](SceneDescription& scene, double factor) {
        scene.camera.eye.x = -factor;
        scene.camera.film_left = factor - 1.5;
        scene.camera.film_right = factor + 1.5;
    },
    [](SceneDescription& scene, double factor) { scene.transforms[0].scale = glm::dvec3(1, 1, factor); },
    [](SceneDescription& scene, double factor) { scene.transforms[0].scale = glm::dvec3(factor, factor, 1); },
    [](SceneDescription& scene, double factor) {  // a cube has nothing round
        const bool round = scene.shapes[0].type != ShapeType::Cube;
        scene.transforms[0].scale = glm::dvec3(round ? 1 / factor : 1, 1, 1);
    },
    [](SceneDescription& scene, double factor) {
        scene.transforms[0].matrix = glm::dmat4(1);
        (*scene.transforms[0].matrix)[0][1] = -factor;
    },
};

void checkStretched(const SceneDescription& scene) {
    for (std::size_t what = 0; what < std::size(stretches); ++what)
        for (int exponent = 2; exponent <= 15; ++exponent) {
            CAPTURE(what, exponent);
            SceneDescription other = scene;
            stretches[what](other, std::pow(10, exponent));
            const ByteImage reference = bytesOf(other, 24, Precision::Extended);
            for (const Precision precision : {Precision::Float, Precision::Double}) {
                const bool told = makeRenderer(other, precision)->precision() != precision;
                if (precision == Precision::Double && exponent <= 5) CHECK(!told);
                if (!told) CHECK(differingPixels(bytesOf(other, 24, precision), reference, 8) <= 2);
            }
        }
}

}  // namespace

TEST_CASE("a stretched camera or shape is what extended precision makes of it, or it is told") {
    SceneMaker make;
    make.glass(glm::dvec3(0.9), 1).color_diffuse = glm::dvec3(1);
    TransformDescription turned;
    turned.rotate = TransformDescription::Rotation{40, {1, 2, 3}};
    make.shape(ShapeType::Sphere, turned);
    make.light({3, 4, 5});
    const auto octahedron = std::make_shared<MeshData>();
    octahedron->positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    octahedron->positionIndex = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    octahedron->findBounds();
    for (const ShapeType type : {ShapeType::Sphere, ShapeType::Plane, ShapeType::Cylinder, ShapeType::Cone,
                                 ShapeType::Cube, ShapeType::Mesh})
        for (const bool perspective : {false, true}) {
            CAPTURE(static_cast<int>(type), perspective);
            SceneDescription scene = make.scene;
            scene.shapes[0].type = type;
            if (type == ShapeType::Mesh) scene.shapes[0].mesh = octahedron;
            if (perspective) scene.camera.type = CameraDescription::Type::Perspective;
            scene.camera.focal_length = 1.5;
            scene.camera.eye = {0, 0, 4};
            checkStretched(scene);
        }
}

TEST_CASE("a scene moved far away is what extended precision makes of it") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        Tally tally;
        for (int exponent = 0; exponent <= 8; ++exponent) {
            const SceneDescription other =
                translated(scene, sizeOf(scene) * std::pow(10, exponent) * glm::dvec3(0.8, -0.31, 0.53));
            tally.add(other, bytesOf(other, 60, Precision::Extended));
        }
        tally.check();
    }
}

TEST_CASE("a ray that leaves a glass plate as it came, parallel to a plane, does not hit that") {
    SceneDescription scene;
    scene.camera.type = CameraDescription::Type::Orthographic;
    scene.camera.eye = {0, 0, 4};
    setFilm(scene, -1, 1);
    scene.lights.resize(1);
    scene.lights[0].color_ambient = glm::dvec3(1);
    scene.materials.resize(2);
    scene.materials[0].refractive = true;
    scene.materials[0].color_refract = glm::dvec3(1);
    scene.materials[0].index_of_refraction = 1.33;
    scene.materials[1].color_ambient = glm::dvec3(1);  // of a floor below and a ceiling above
    for (MaterialDescription& material : scene.materials)
        material.color_diffuse = material.color_specular = glm::dvec3(0);
    scene.transforms.resize(3);
    scene.transforms[0].scale = {3, 3, 0.1};
    scene.shapes.push_back({ShapeType::Cube, 0, 0, nullptr});
    for (const std::size_t plane : {1, 2}) {
        scene.transforms[plane].translate = {0, plane == 1 ? -4 : 4, 0};
        scene.transforms[plane].rotate = TransformDescription::Rotation{plane == 1 ? -90.0 : 90.0, {1, 0, 0}};
        scene.shapes.push_back({ShapeType::Plane, plane, 1, nullptr});
    }
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended})
        for (int degrees = 1; degrees < 50; ++degrees) {
            scene.transforms[0].rotate = TransformDescription::Rotation{double(degrees), {3, 2, 1}};
            INFO(degrees << " degrees, " << precisionName(precision));
            CHECK(
                std::ranges::all_of(bytesOf(scene, 4, precision).pixels, [](int byte) { return byte == 0; }));
        }
}
