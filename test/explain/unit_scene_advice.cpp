// Every word that is said about scenes that can be rendered but may not be meant, and the silence about the
// others.
#include <catch2/catch.hpp>

#include <cmath>

#include "../support/ball_mesh.h"
#include "../support/scene_files.h"
#include "raytracer/explain/black_picture.h"
#include "raytracer/explain/scene_advice.h"
#include "raytracer/scene/mesh_file.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

using Type = ShapeType;
using Warnings = std::vector<std::string>;

// The camera is at the origin and looks along -z, 90 degrees wide and high; a light far behind it.
struct TestScene : SceneDescription {
    TestScene() {
        materials.resize(3);
        materials[mirror].reflective = true;
        materials[glass].refractive = true;
        lights.push_back({{0, 0, 100}, glm::dvec3(1), glm::dvec3(1)});
    }

    static constexpr std::size_t opaque = 0, mirror = 1, glass = 2;

    TestScene& orthographic() {
        camera.type = CameraDescription::Type::Orthographic;
        return *this;
    }

    TestScene& add(Type type, const glm::dvec3& translate, std::size_t material = opaque) {
        return add(type, translate, glm::dvec3(1), material);
    }

    TestScene& add(Type type, const glm::dvec3& translate, const glm::dvec3& scale,
                   std::size_t material = opaque) {
        TransformDescription transform;
        transform.translate = translate;
        transform.scale = scale;
        return add(type, transform, material);
    }

    TestScene& add(Type type, const TransformDescription& transform, std::size_t material = opaque) {
        shapes.push_back({type, transforms.size(), material, nullptr});
        transforms.push_back(transform);
        return *this;
    }

    // Everything `factor` times as large and as far away.
    TestScene& resize(double factor) {
        if (camera.type == CameraDescription::Type::Orthographic)
            for (double* edge :
                 {&camera.film_left, &camera.film_right, &camera.film_bottom, &camera.film_top})
                *edge *= factor;
        camera.eye *= factor;
        for (LightDescription& light : lights) light.position *= factor;
        for (TransformDescription& transform : transforms) {
            transform.translate = transform.translate.value_or(glm::dvec3(0)) * factor;
            transform.scale = transform.scale.value_or(glm::dvec3(1)) * factor;
        }
        return *this;
    }

    TestScene& light(const glm::dvec3& position) {
        lights[0].position = position;
        return *this;
    }
};

TransformDescription turned(const glm::dvec3& translate, double degrees, const glm::dvec3& axis) {
    TransformDescription transform;
    transform.translate = translate;
    transform.rotate = TransformDescription::Rotation{degrees, axis};
    return transform;
}

TransformDescription floorAt(double y) { return turned({0, y, 0}, -90, {1, 0, 0}); }

std::string unseen(int shape, const std::string& what) {
    return "/shapes/" + std::to_string(shape) + ": the " + what + ", so unseen but for its shadow: move it";
}

std::string blackReason(const SceneDescription& scene, Precision precision = Precision::Double) {
    const auto renderer = makeRenderer(scene, precision);
    const RenderOptions options = wholePicture(scene, 50);
    CHECK(isAllBlack(renderBytes(*renderer, options)));
    return whyBlack(scene, *renderer, options);
}

std::shared_ptr<MeshData> triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const auto mesh = std::make_shared<MeshData>();
    mesh->positions = {a, b, c};
    mesh->positionIndex = {0, 1, 2};
    mesh->findBounds();
    mesh->chooseUnit();
    return mesh;
}

}  // namespace

TEST_CASE("a camera whose frame is not of orthogonal unit vectors") {
    TestScene scene;
    const auto distorted = [](const std::string& found) {
        return Warnings{"/camera: look and up distort: lengths " + found + "\u00b0, not 1, 1 at 90\u00b0"};
    };
    SECTION("as it should be") { CHECK(sceneAdvice(scene).empty()); }
    SECTION("rounded to three decimals") {
        scene.camera.look = {-0.577, -0.577, -0.577};
        scene.camera.up = {-0.408, 0.816, -0.408};
        CHECK(sceneAdvice(scene).empty());
    }
    SECTION("too long") {
        scene.camera.look = {0, 0, -2};
        CHECK(sceneAdvice(scene) == distorted("2, 1 at 90"));
    }
    SECTION("too short") {
        scene.camera.up = {0, 0.99, 0};
        CHECK(sceneAdvice(scene) == distorted("1, 0.99 at 90"));
    }
    SECTION("not orthogonal") {
        scene.camera.look = {0, -0.6, -0.8};
        CHECK(sceneAdvice(scene) == distorted("1, 1 at 126.9"));
    }
    SECTION("of extreme length") {
        scene.camera.look = {0, 0, -1e-300};
        scene.camera.up = {0, 1e300, 0};
        CHECK(sceneAdvice(scene) == distorted("1e-300, 1e+300 at 90"));
    }
}

TEST_CASE("a shape that no ray of the view meets") {
    TestScene scene;
    const double factor = GENERATE(1.0, 1e-100, 1e100);
    const bool orthographic = GENERATE(false, true);
    if (orthographic) scene.orthographic();
    const auto adviceOn = [&] { return sceneAdvice(scene.resize(factor)); };
    SECTION("one in view gives none, nor one that reaches into it") {
        for (const Type type : {Type::Sphere, Type::Plane, Type::Cylinder, Type::Cone, Type::Cube})
            scene.add(type, {0, 0, -3}).add(type, {1.9, 0, -1});
        scene.add(Type::Sphere, glm::dvec3(0)).add(Type::Cube, {0, 0, 0.5});
        CHECK(adviceOn().empty());
    }
    SECTION("behind the camera") {
        scene.add(Type::Sphere, {0, 0, 2})
            .add(Type::Cylinder, {0, 0, 0.1})
            .add(Type::Cone, {0, 0, 0.1})
            .add(Type::Cube, {0, 0, 1.1});
        CHECK(adviceOn() ==
              Warnings{unseen(0, "sphere is behind the camera"), unseen(1, "cylinder is behind the camera"),
                       unseen(2, "cone is behind the camera"), unseen(3, "cube is behind the camera")});
    }
    SECTION("on each side") {
        scene.add(Type::Sphere, {-5, 0, -1})
            .add(Type::Cube, {5, 0, -1})
            .add(Type::Cone, {0, -5, -1})
            .add(Type::Cylinder, {0, 5, -1});
        CHECK(adviceOn() == Warnings{unseen(0, "sphere is to the left of the view"),
                                     unseen(1, "cube is to the right of the view"),
                                     unseen(2, "cone is below the view"),
                                     unseen(3, "cylinder is above the view")});
    }
    SECTION("planes: only where every ray runs away from them") {
        scene.add(Type::Plane, {0, 0, 1})
            .add(Type::Plane, {0, 0, -1})
            .add(Type::Plane, glm::dvec3(0))
            .add(Type::Plane, floorAt(-1));
        scene.add(Type::Plane, turned({0, 0, 1}, 20, {1, 2, 0}));
        CHECK(adviceOn() ==
              Warnings{unseen(0, "plane is behind the camera"), unseen(4, "plane is behind the camera")});
    }
}

TEST_CASE("nearly outside is in doubt, so nothing is said") {
    const double root = std::sqrt(2.0);
    for (double radius = 0.1; radius < 3; radius += 0.1) {  // rounding puts some on either side
        const glm::dvec3 touching(-1 - root * radius, 0, -1), clear = touching - glm::dvec3(1e-6, 0, 0);
        CHECK(sceneAdvice(TestScene().add(Type::Sphere, touching, glm::dvec3(radius))).empty());
        CHECK(sceneAdvice(TestScene().add(Type::Sphere, clear, glm::dvec3(radius))).size() == 1);
    }
}

TEST_CASE("left is where the picture's left is") {
    TestScene scene;
    std::swap(scene.camera.film_left, scene.camera.film_right);
    scene.add(Type::Sphere, {-5, 0, -1});
    CHECK(sceneAdvice(scene) == Warnings{unseen(0, "sphere is to the right of the view")});
}

TEST_CASE("a mesh is where its vertices are") {
    MeshData data;
    data.positions = {{10, 0, 0}, {11, 0, 0}, {10, 1, 0}};
    data.positionIndex = {0, 1, 2};
    data.findBounds();
    TestScene scene;
    scene.add(Type::Mesh, {0, 0, -3});
    scene.add(Type::Mesh, {-10, 0, -3});
    for (ShapeDescription& shape : scene.shapes) shape.mesh = std::make_shared<MeshData>(data);
    CHECK(sceneAdvice(scene) == Warnings{unseen(0, "mesh is to the right of the view")});
}

TEST_CASE("what mirrors and glass may show is not said to be unseen") {
    TestScene scene;
    scene.add(Type::Sphere, {0, 0, 2});
    SECTION("a mirror in view") {
        CHECK(sceneAdvice(scene.add(Type::Sphere, {0, 0, -3}, TestScene::mirror)).empty());
    }
    SECTION("glass in view") {
        CHECK(sceneAdvice(scene.add(Type::Sphere, {0, 0, -3}, TestScene::glass)).empty());
    }
    SECTION("a mirror that is not seen shows nothing") {
        scene.add(Type::Sphere, {0, 0, 4}, TestScene::mirror);
        CHECK(sceneAdvice(scene) ==
              Warnings{unseen(0, "sphere is behind the camera"), unseen(1, "sphere is behind the camera")});
    }
}

TEST_CASE("of very many warnings some are shown and the rest counted, for shapes too") {
    TestScene scene;
    for (int i = 0; i < 100; ++i) scene.add(Type::Cube, {0, 0, 5});
    const Warnings warnings = sceneAdvice(scene);
    REQUIRE(warnings.size() == 21);
    CHECK(warnings[19] == unseen(19, "cube is behind the camera"));
    CHECK(warnings[20] == "and 80 more");
}

TEST_CASE("a light inside of an opaque shape") {
    TestScene scene;
    const double factor = GENERATE(1.0, 1e-100, 1e100);
    const auto adviceOn = [&] { return sceneAdvice(scene.resize(factor)); };
    const auto inside = [](const std::string& type) {
        return Warnings{"/lights/0: hidden inside of /shapes/0, an opaque " + type + ": move the light out"};
    };
    SECTION("sphere") { CHECK(adviceOn().empty()); }
    SECTION("sphere") {
        scene.add(Type::Sphere, {0, 0, -5}).light({0.5, 0.5, -5.5});
        CHECK(adviceOn() == inside("sphere"));
    }
    SECTION("cylinder") {
        scene.add(Type::Cylinder, {0, 0, -5}).light({0.7, 0.7, -4.1});
        CHECK(adviceOn() == inside("cylinder"));
    }
    SECTION("cone") {
        scene.add(Type::Cone, {0, 0, -5}).light({0, 0.4, -4.5});
        CHECK(adviceOn() == inside("cone"));
    }
    SECTION("cube") {
        scene.add(Type::Cube, {0, 0, -5}).light({0.9, 0.9, -5.9});
        CHECK(adviceOn() == inside("cube"));
    }
    SECTION("outside, though within the box around") {
        scene.add(Type::Sphere, {0, 0, -5})
            .add(Type::Cylinder, {0, 0, -5})
            .add(Type::Cone, {0, 0, -5})
            .light({0.8, 0.8, -4.5});
        CHECK(adviceOn().empty());
    }
    SECTION("on the surface, but for rounding") {
        scene.add(Type::Sphere, {0, 0, -5});
        for (int degrees = 0; degrees < 90; ++degrees) {
            TestScene copy = scene;
            copy.light({std::cos(degrees * 0.01745), std::sin(degrees * 0.01745), -5});
            CHECK(sceneAdvice(copy.resize(factor)).empty());
        }
    }
    SECTION("on the surface") {
        scene.add(Type::Cube, {0, 0, -5}).light({0, 1, -5});
        CHECK(adviceOn().empty());
    }
    SECTION("in glass") {
        scene.add(Type::Cube, {0, 0, -5}, TestScene::glass).light({0, 0, -5});
        CHECK(adviceOn().empty());
    }
    SECTION("in a room with the camera") {
        scene.add(Type::Cube, glm::dvec3(0), glm::dvec3(9)).light({0, 8, 0});
        CHECK(adviceOn().empty());
    }
    SECTION("one that only has ambient light") {
        scene.add(Type::Cube, {0, 0, -5}).light({0, 0, -5}).lights[0].color = glm::dvec3(0);
        CHECK(adviceOn().empty());
    }
}

TEST_CASE("a mesh without an area is told") {
    const Warnings told{"/shapes/0/path: the mesh has no area: move corners of its triangles off their line"};
    const auto adviceOn = [](const std::shared_ptr<MeshData>& mesh) {
        TestScene scene;
        scene.add(Type::Mesh, {0, 0, -3}).shapes[0].mesh = mesh;
        return sceneAdvice(scene);
    };
    const glm::dvec3 zero(0), x(1, 0, 0), y(0, 1, 0), slant(1, 1, 0);
    CHECK(adviceOn(triangle(zero, zero, zero)) == told);
    CHECK(adviceOn(triangle(0.1 * slant, 0.2 * slant, 0.3 * slant)) == told);
    CHECK(adviceOn(triangle(0.1 * slant, 0.2 * slant, 0.3 * slant + 1e-15 * x)).empty());
    for (const double size : {1e-300, 1e-160, 1.0, 1e160, 1e300})
        CHECK(adviceOn(triangle(zero, size * x, size * y)) != told);
}

TEST_CASE("why a picture is all black") {
    TestScene scene;
    const Precision precision = GENERATE(Precision::Float, Precision::Double, Precision::Extended);
    const auto reason = [&] { return blackReason(scene, precision); };
    const std::string begin = "all black: ", end = ", or set /materials/0/color_ambient";
    SECTION("no shapes") { CHECK(reason() == begin + "the scene has no shapes: add one to \"shapes\""); }
    SECTION("no lights") {
        scene.add(Type::Sphere, {0, 0, -3}).lights.clear();
        CHECK(reason() == begin + "the scene has no lights: add one to \"lights\"");
    }
    SECTION("nothing hit") {
        scene.add(Type::Sphere, {0, 0, 3});
        CHECK(reason() == begin + "no ray through a pixel's centre hits a shape: turn or move the camera");
    }
    SECTION("nothing hit, but a shape lies between the rays") {
        scene.add(Type::Sphere, {0, 0, -3}, {1e-3, 1e-3, 1e-3});
        CHECK(reason() == begin +
                              "no ray through a pixel's centre hits a shape: "
                              "take more pixels, or turn or move the camera");
    }
    SECTION("all in the shadow of one shape") {
        scene.add(Type::Plane, {0, 0, -3}).add(Type::Plane, {0, 0, 5});
        CHECK(reason() == begin + "/shapes/1 shadows what is seen: move it" + end);
    }
    SECTION("all in the shadow of several") {
        scene.add(Type::Plane, {0, 0, -3})
            .add(Type::Cube, {-50, 0, 5}, {50, 50, 1})
            .add(Type::Cube, {50, 0, 5}, {50, 50, 1});
        CHECK(reason() == begin + "what is seen is in shadow: move a light" + end);
    }
    SECTION("lights behind all surfaces") {
        scene.add(Type::Plane, {0, 0, -3}).light({0, 0, -10});
        CHECK(reason() == begin + "what is seen faces no light: move one" + end);
    }
    SECTION("black materials") {
        scene.add(Type::Plane, {0, 0, -3}).materials[TestScene::opaque].color_diffuse = glm::dvec3(0);
        scene.materials[TestScene::opaque].color_specular = glm::dvec3(0);
        CHECK(reason() == begin + "what is seen is black: set /materials/0/color_diffuse");
    }
    SECTION("a negative light") {
        scene.add(Type::Plane, {0, 0, -3}).lights[0].color = {-1, -1, -1};
        CHECK(reason() == begin + "/lights/0/color is negative, which takes light away: write 0 or more");
    }
    SECTION("black lights") {
        scene.add(Type::Plane, {0, 0, -3}).lights[0].color = glm::dvec3(0);
        CHECK(reason() == begin + "what is seen has only black lights: set /lights/0/color");
        scene.materials[TestScene::opaque].color_diffuse = glm::dvec3(0);
        scene.materials[TestScene::opaque].color_specular = glm::dvec3(0);
        CHECK(reason() == begin +
                              "what is seen has only black lights: set /lights/0/color and "
                              "/materials/0/color_diffuse");
    }
    SECTION("a mesh without an area") {
        scene.add(Type::Mesh, {0, 0, -3}).shapes[0].mesh = triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
        CHECK(reason() == begin + "no mesh has an area: move corners of its triangles off their line");
    }
    SECTION("light that is too weak") {
        scene.add(Type::Plane, {0, 0, -3}).materials[TestScene::opaque].color_specular = glm::dvec3(0);
        scene.lights[0].color = glm::dvec3(0.001);
        CHECK(reason() == begin + "it is too dark: the largest channel is 0.001 of 1: brighten a light");
    }
    SECTION("lights without an ambient color") {
        scene.add(Type::Plane, {0, 0, -3}).light({0, 0, -10}).lights[0].color_ambient = glm::dvec3(0);
        CHECK(reason() == begin +
                              "what is seen faces no light: move one, or set color_ambient of "
                              "/lights/0 and /materials/0");
        scene.materials[TestScene::opaque].color_ambient = glm::dvec3(1);
        CHECK(reason() == begin + "what is seen faces no light: move one, or set /lights/0/color_ambient");
    }
    SECTION("inside of an opaque shape") {
        scene.add(Type::Plane, {0, 0, -3}).add(Type::Cube, {0, 0, 0});
        CHECK(reason() == begin + "the camera is inside of /shapes/1, a cube: move it out, or a light in");
    }
    SECTION("inside of one, among others, with an orthographic camera, too") {
        const bool orthographic = GENERATE(false, true);
        if (orthographic) scene.orthographic();
        const Type type = GENERATE(Type::Sphere, Type::Cylinder, Type::Cone, Type::Cube);
        scene.add(Type::Plane, {0, 0, -0.5})
            .add(Type::Cube, {0.5, 0, 0}, {0.1, 9, 9})
            .add(type, {0, 0, -1}, glm::dvec3(4));
        CHECK(reason() == begin + "the camera is inside of /shapes/2, a " + typeName(scene.shapes[2].type) +
                              ": move it out, or a light in");
    }
    SECTION("inside of a mesh") {
        scene.add(Type::Mesh, {0, 0, 0}).shapes[0].mesh = ballMesh(4, [](double, double) { return 2; });
        CHECK(reason() == begin + "the camera is inside of /shapes/0, a mesh: move it out, or a light in");
    }
    SECTION("inside of a room whose light is black") {
        scene.add(Type::Cube, {0, 0, 0}).lights[0] = {{0, 0, 0}, glm::dvec3(0), glm::dvec3(1)};
        CHECK(reason() == begin + "what is seen has only black lights: set /lights/0/color");
    }
    SECTION("inside of a room whose walls are black") {
        scene.add(Type::Cube, {0, 0, 0}).light({0, 0, 0.5});
        scene.materials[TestScene::opaque].color_diffuse = glm::dvec3(0);
        scene.materials[TestScene::opaque].color_specular = glm::dvec3(0);
        CHECK(reason() == begin + "what is seen is black: set /materials/0/color_diffuse");
    }
    SECTION("with the lights inside of shapes") {
        scene.add(Type::Sphere, {0, 0, -3}).light({0, 0, -3});
        CHECK(reason() == begin + "its lights are inside of opaque shapes: move one out");
    }
    SECTION("a bit of each") {
        scene.add(Type::Plane, {0, 0, -3})
            .add(Type::Plane, {0, 0, 5})
            .lights.push_back({{0, 0, -10}, glm::dvec3(1), glm::dvec3(0)});
        CHECK(reason() == begin + "no light reaches what is seen: move one" + end);
    }
    SECTION("what only a mirror shows counts too") {
        scene.add(Type::Plane, {0, 0, -3}, TestScene::mirror).add(Type::Plane, {0, 0, 5}).light({0, 0, 10});
        scene.materials[TestScene::mirror].color_diffuse = scene.materials[TestScene::mirror].color_specular =
            glm::dvec3(0);
        CHECK(reason() ==
              begin + "no light reaches what is seen: move one, or set /materials/1/color_ambient");
    }
}

TEST_CASE("no picture that shows something is all black") {
    ByteImage bytes;
    bytes.pixels = {0, 0, 0, 0, 0, 0};
    CHECK(isAllBlack(bytes));
    bytes.pixels[5] = 1;
    CHECK_FALSE(isAllBlack(bytes));
    FloatImage floats;
    floats.pixels = {0, 0, -1};
    CHECK(isAllBlack(floats));
    floats.pixels[1] = 1e-30f;
    CHECK_FALSE(isAllBlack(floats));
}
