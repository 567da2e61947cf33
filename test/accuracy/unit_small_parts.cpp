// The extra samples of what is small in a picture (FirstSamples::extra).
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "../support/scene_files.h"
#include "raytracer/accuracy/picture_error.h"
#include "raytracer/pictures/color_sink.h"
#include "raytracer/scene/mesh_file.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

constexpr int edge = 40;  // pixels; the film is 40 units wide, so that a unit is a pixel

// Seen from (0, 0, 40) along -z: at z = 0 a unit is a pixel. Every shape shines by itself.
SceneDescription emptyScene(CameraDescription::Type type) {
    SceneDescription scene;
    scene.camera.type = type;
    scene.camera.eye = {0, 0, edge};
    scene.camera.focal_length = edge;
    setFilm(scene, -edge / 2, edge / 2);
    scene.lights.resize(1);
    scene.lights[0].color_ambient = glm::dvec3(1);
    return scene;
}

void add(SceneDescription& scene, ShapeType type, const glm::dvec3& place, const glm::dvec3& scale,
         double shine = 1) {
    MaterialDescription material;
    material.color_ambient = glm::dvec3(shine);
    material.color_diffuse = material.color_specular = glm::dvec3(0);
    TransformDescription transform;
    transform.translate = place;
    transform.scale = scale;
    scene.shapes.push_back({type, scene.transforms.size(), scene.materials.size(), nullptr});
    scene.transforms.push_back(transform);
    scene.materials.push_back(material);
}

std::vector<ExtraSample> extraOf(const SceneDescription& scene, Precision precision = Precision::Double) {
    FirstSamples first;
    makeRenderer(scene, precision)->renderFirst(wholePicture(scene, edge), first);
    return first.extra;
}

std::set<std::pair<int, int>> columnsAndRows(const std::vector<ExtraSample>& extra) {
    std::set<std::pair<int, int>> places;
    for (const ExtraSample& sample : extra) places.insert({sample.pixel().x, sample.pixel().y});
    return places;
}

std::set<int> columnsOf(const std::vector<ExtraSample>& extra) {
    std::set<int> columns;
    for (const ExtraSample& sample : extra) columns.insert(sample.pixel().x);
    return columns;
}

// Whether each of these columns, or the next one, is among them.
bool cover(const std::set<int>& columns, int first, int end) {
    for (int column = first; column < end; ++column)
        if (!columns.contains(column) && !columns.contains(column + 1)) return false;
    return true;
}

const auto cameras = {CameraDescription::Type::Perspective, CameraDescription::Type::Orthographic};

}  // namespace

TEST_CASE("small parts: a dot between the centres is seen, at its pixel") {
    for (const auto camera : cameras)
        for (const auto type : {ShapeType::Sphere, ShapeType::Cube, ShapeType::Cylinder, ShapeType::Cone})
            for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended}) {
                SceneDescription scene = emptyScene(camera);
                add(scene, type, {-3.1, 7.2, 0}, glm::dvec3(0.01), 0.25);
                const auto extra = extraOf(scene, precision);
                REQUIRE(extra.size() == 1);
                CHECK(extra[0].point.x == Approx(16.9).margin(0.02));
                CHECK(extra[0].point.y == Approx(12.8).margin(0.02));
                CHECK(extra[0].color.x == Approx(0.25));
            }
}

TEST_CASE("small parts: a wire has one in each of its pixels, to a cone's tip") {
    for (const auto camera : cameras)
        for (const auto type : {ShapeType::Cylinder, ShapeType::Cone, ShapeType::Cube, ShapeType::Sphere}) {
            SceneDescription scene = emptyScene(camera);
            const bool isCentred = type == ShapeType::Cube || type == ShapeType::Sphere;
            add(scene, type, {isCentred ? 0 : -15, 4.8, 0}, {0.02, 0.02, isCentred ? 15 : 30});
            scene.transforms[0].rotate = TransformDescription::Rotation{90, {0, 1, 0}};  // z becomes x
            const auto extra = extraOf(scene);
            std::set<std::pair<int, int>> expected;
            for (int x = 5; x < 35; ++x) expected.insert({x, 15});
            CHECK(columnsAndRows(extra) == expected);
            CHECK(std::ranges::all_of(extra, [](const ExtraSample& e) { return e.color == glm::dvec3(1); }));
        }
}

TEST_CASE("small parts: a wire that comes from behind the eye, and one that passes through its middle") {
    for (const int axis : {0, 1, 2})
        for (const double end : {100.0, 1000.0})
            for (const double begin :
                 {-end, -2 * end}) {  // in the middle of the first, all axes pass the eye
                SceneDescription scene = emptyScene(CameraDescription::Type::Perspective);
                const auto turned = [axis](double x, double y, double z) {
                    glm::dvec3 place;
                    place[axis] = -z, place[(axis + 1) % 3] = x, place[(axis + 2) % 3] = y;
                    return place;
                };
                scene.camera.eye = glm::dvec3(0);
                scene.camera.look = turned(0, 0, -1);
                scene.camera.up = turned(0, 1, 0);
                add(scene, ShapeType::Cube, turned(13, 3, -(begin + end) / 2),
                    turned(0.01, 0.01, -(end - begin) / 2));
                const auto extra = extraOf(scene);
                std::set<int> columns;
                for (const ExtraSample& sample : extra) {
                    CHECK(sample.color == glm::dvec3(1));
                    CHECK((20 - sample.point.y) / std::abs(sample.point.x - 20) ==
                          Approx(3.0 / 13).margin(1e-3));
                    columns.insert(std::abs(static_cast<int>(sample.point.x - 20)));
                }
                INFO(axis << " " << begin << " to " << end);
                CHECK(cover(columns, end == 100 ? 6 : 1, 19));
            }
}

TEST_CASE("small parts: what lies in the eye's plane, before and behind it by rounding") {
    for (const auto camera : cameras)
        for (int degrees = 0; degrees < 45; ++degrees) {
            SceneDescription scene = emptyScene(camera);
            const double angle = degrees * std::acos(-1.0) / 180;
            scene.camera.eye = glm::dvec3(0);
            scene.camera.look = {-std::sin(angle), 0, -std::cos(angle)};
            const glm::dvec3 u{std::cos(angle), 0, -std::sin(angle)};
            std::string text;
            for (int line = -9; line <= 9; ++line)
                for (const double x : {-20.0, 20.0})
                    for (const double y : {0.0, 0.01})
                        text += "v " + std::to_string(x * u.x) + " " + std::to_string(line + y) + " " +
                                std::to_string(x * u.z) + "\n";
            for (int i = 1; i <= 4 * 19; i += 4)
                text += "f " + std::to_string(i) + " " + std::to_string(i + 2) + " " + std::to_string(i + 3) +
                        "\n";
            add(scene, ShapeType::Mesh, {0, 0, 0}, glm::dvec3(1));
            auto mesh = parseObj(text);
            scene.shapes[0].mesh = std::make_shared<MeshData>(std::move(mesh));
            for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended})
                CHECK(extraOf(scene, precision).size() <= 40 * 40);
        }
}

TEST_CASE("small parts: a rail of two triangles, in depth and past the eye") {
    for (const auto camera : cameras)
        for (const double near : {20.0, 60.0}) {  // the eye is at 40
            SceneDescription scene = emptyScene(camera);
            add(scene, ShapeType::Mesh, {0, 0, 0}, glm::dvec3(1));
            const std::string a = std::to_string(near), b = std::to_string(-1000);
            scene.shapes[0].mesh =
                std::make_shared<MeshData>(parseObj("v 13 3 " + a + "\nv 13.02 3 " + a + "\nv 1.02 3 " + b +
                                                    "\nv 1 3 " + b + "\nf 1 2 3\nf 1 3 4\n"));
            const auto extra = extraOf(scene);
            CHECK(cover(columnsOf(extra), 21, 33));
        }
}

TEST_CASE("small parts: a plate that is seen from its edge, to its corners") {
    for (const auto camera : cameras)
        for (const double degrees : {45.0, 30.0, -60.0}) {
            SceneDescription scene = emptyScene(camera);
            add(scene, ShapeType::Cube, {0, 0.2, 0}, {8, 0.01, 8});
            scene.camera.eye.y = 0.2;
            scene.transforms[0].rotate = TransformDescription::Rotation{degrees, {0, 1, 0}};
            const std::set<int> columns = columnsOf(extraOf(scene));
            const double angle = degrees * std::acos(-1.0) / 180;
            const double reach = 8 * (std::abs(std::cos(angle)) + std::abs(std::sin(angle)));
            INFO(degrees << ", to " << reach);
            CHECK(cover(columns, static_cast<int>(20 - reach) + 2, static_cast<int>(std::ceil(18 + reach))));
        }
}

TEST_CASE("small parts: the sharp corners of a plate, and of a triangle, that are wide between them") {
    for (const auto camera : cameras)
        for (const auto type : {ShapeType::Cube, ShapeType::Mesh}) {
            SceneDescription scene = emptyScene(camera);
            // A square of 20 x 20, its corners to the left, to the right, near and far, seen from a little
            // above: 28 pixels long, 5.7 high.
            add(scene, type, {0, 0, 0}, {10, 0.001, 10});
            scene.shapes[0].mesh = std::make_shared<MeshData>(
                parseObj("v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3\nf 1 3 4\n"));
            scene.transforms[0].rotate = TransformDescription::Rotation{45, {0, 1, 0}};
            scene.camera.look = {0, -0.2, -std::sqrt(1 - 0.04)};
            scene.camera.up = {0, scene.camera.look.z * -1, -0.2};
            scene.camera.eye = -40.0 * scene.camera.look;
            std::set<int> columns;
            for (const ExtraSample& sample : extraOf(scene)) {
                CHECK(sample.color == glm::dvec3(1));
                if (std::abs(sample.point.y - 20) < 0.5)  // the others are on the plate's rim
                    columns.insert(std::abs(static_cast<int>(sample.point.x - 20)));
            }
            CHECK(cover(columns, 10, 13));
        }
}

TEST_CASE("small parts: a bright rim of a wide, black plate") {
    for (const auto camera : cameras) {
        SceneDescription scene = emptyScene(camera);
        add(scene, ShapeType::Cube, {0, 0, 0}, {10, 0.2, 10});
        scene.lights[0] = {};
        scene.lights[0].position = {0, 0, 1000};  // before the rim, and in the plane of the plate
        scene.lights[0].color = glm::dvec3(1);
        scene.materials[0].color_diffuse = glm::dvec3(1);
        scene.camera.look = {0, -0.6, -0.8};
        scene.camera.up = {0, 0.8, -0.6};
        scene.camera.eye = -40.0 * scene.camera.look;
        std::set<int> columns;
        for (const ExtraSample& sample : extraOf(scene))
            if (sample.color.x > 0.5) columns.insert(static_cast<int>(sample.point.x));
        CHECK(cover(columns, 11, 29));
    }
}

TEST_CASE("small parts: a board that gets thin far away") {
    SceneDescription scene = emptyScene(CameraDescription::Type::Perspective);
    add(scene, ShapeType::Cube, {1, -30, -60}, {3, 0.001, 60});
    // From 40 to 160 away. It is 6 to 1.5 pixels wide, and 2.4 in its middle.
    CHECK(columnsAndRows(extraOf(scene)).contains({20, 28}));
}

TEST_CASE("small parts: a sliver whose longest side in the picture is not the longest in the scene") {
    SceneDescription scene = emptyScene(CameraDescription::Type::Orthographic);
    add(scene, ShapeType::Mesh, {0, 0, 0}, glm::dvec3(1));
    // Seen almost along its two long sides it is 28 pixels long and 0.13 high.
    scene.shapes[0].mesh = std::make_shared<MeshData>(parseObj("v 0 0 0\nv 1 0 0\nv 40 0 -39.5\nf 1 2 3\n"));
    const double tilt = 6e-5, r = std::sqrt(0.5);
    setFilm(scene, -0.5, 0.5);
    scene.camera.look = {r, -tilt, -r};
    scene.camera.up = {tilt * r, 1, -tilt * r};
    scene.camera.eye = glm::dvec3(0.25, 0, 0.25) - 20.0 * scene.camera.look;
    CHECK(cover(columnsOf(extraOf(scene)), 8, 32));
}

TEST_CASE("small parts: a strip before and behind the plane of an orthographic camera") {
    for (const double middle : {-1000.0, 0.0, 39.0}) {
        SceneDescription scene = emptyScene(CameraDescription::Type::Orthographic);
        add(scene, ShapeType::Cube, {0, 9.6, middle}, {15, 0.01, 2000});
        CHECK(cover(columnsOf(extraOf(scene)), 6, 34));
    }
}

TEST_CASE("small parts: a wire along the view, also through the plane of an orthographic camera") {
    for (const double middle : {-1000.0, 0.0, 40.0}) {
        SceneDescription scene = emptyScene(CameraDescription::Type::Orthographic);
        add(scene, ShapeType::Cube, {0.5, 9.5, middle}, {0.01, 0.01, 2000});
        CHECK(columnsAndRows(extraOf(scene)) == std::set{std::pair(20, 10)});
    }
}

TEST_CASE("small parts: where rounding moves a wire by pixels, the search ends") {
    SceneDescription scene = emptyScene(CameraDescription::Type::Orthographic);
    setFilm(scene, -0.1, 0.1);
    scene.camera.look = {-0.3, -0.5, -0.8};
    for (int i = 0; i < 20; ++i) add(scene, ShapeType::Cube, {0, 0, i * 1e-3}, {0.01, 0.01, 1e6});
    TransformDescription::Rotation turn{std::acos(0.8 / std::sqrt(0.98)) * 180 / std::acos(-1.0),
                                        {-0.5, 0.3, 0}};
    for (TransformDescription& transform : scene.transforms) transform.rotate = turn;
    CHECK(extraOf(scene, Precision::Float).size() <= 40 * 40);
}

TEST_CASE("small parts: none of what is wide, infinite, beside the picture or behind the eye") {
    for (const auto camera : cameras) {
        SceneDescription scene = emptyScene(camera);
        for (const auto type : {ShapeType::Sphere, ShapeType::Cube, ShapeType::Cylinder, ShapeType::Cone})
            add(scene, type, {0, 0, 0}, glm::dvec3(3));
        add(scene, ShapeType::Plane, {0, -5, 0}, glm::dvec3(1));
        add(scene, ShapeType::Sphere, {30, 0, 0}, glm::dvec3(0.1));
        add(scene, ShapeType::Sphere, {0, -20.2, 0}, glm::dvec3(0.1));
        add(scene, ShapeType::Sphere, {0, 0, 60}, glm::dvec3(0.1));
        CHECK(extraOf(scene).empty());
    }
}

TEST_CASE("small parts: the nearest of those in a pixel, with the colour that is seen there") {
    SceneDescription scene = emptyScene(CameraDescription::Type::Orthographic);
    for (const double z : {1.0, 3.0, 2.0})
        add(scene, ShapeType::Sphere, {2.1, 2.2 + z / 10, z}, glm::dvec3(0.01), z);
    add(scene, ShapeType::Sphere, {-6.1, 2.2, 1}, glm::dvec3(0.01), 7);
    add(scene, ShapeType::Cube, {-6.1, 2.2, 9}, {4, 4, 1}, 0.5);  // before the dot
    const auto extra = extraOf(scene);
    REQUIRE(extra.size() == 2);
    CHECK(extra[0].color == glm::dvec3(0.5));
    CHECK(extra[1].color == glm::dvec3(3));
}

TEST_CASE("small parts: thin triangles of a mesh, and small ones") {
    SceneDescription scene = emptyScene(CameraDescription::Type::Orthographic);
    add(scene, ShapeType::Mesh, {0, 0, 0}, glm::dvec3(1));
    const auto meshOf = [&](const std::string& text) {
        scene.shapes[0].mesh = std::make_shared<MeshData>(parseObj(text));
        return columnsAndRows(extraOf(scene));
    };
    std::set<std::pair<int, int>> blade;
    for (int x = 10; x < 20; ++x) blade.insert({x, 14});
    for (const std::string face : {"1 2 3", "2 3 1", "3 1 2", "2 1 3"})
        CHECK(meshOf("v -10 5.1 0\nv 0 5.2 0\nv -2 5.3 0\nf " + face + "\n") == blade);
    CHECK(meshOf("v -10 5.1 0\nv -9.8 5.1 0\nv -10 5.3 0\nf 3 1 2\n") == std::set{std::pair(10, 14)});
    CHECK(meshOf("v -10 5 0\nv 0 5 0\nv -5 13.5 0\nf 1 2 3\n").empty());
}

TEST_CASE("adaptive: wires and dots that no centre meets are drawn") {
    SceneDescription scene = emptyScene(CameraDescription::Type::Perspective);
    for (int i = 0; i < 8; ++i) {
        add(scene, ShapeType::Cube, {0, 2 * i - 8.0, 0}, {15, 0.06, 0.06}, 0.9);
        for (int k = 0; k < 9; ++k)
            add(scene, ShapeType::Sphere, {k - 4.0, 2 * i - 9.0, 0}, glm::dvec3(0.2), 3);
    }
    const auto renderer = makeRenderer(scene, Precision::Double);
    const auto picture = [&](int samples, double adaptive) {
        RenderOptions options = wholePicture(scene, edge);
        options.samples = samples;
        options.adaptive = adaptive;
        ColorSink sink(options.crop);
        renderer->render(options, sink);
        return sink.colors();
    };
    const auto truth = picture(4096, 0), centres = picture(1, 0);
    CHECK(std::ranges::all_of(centres, [](const glm::dvec3& color) { return color == glm::dvec3(0); }));
    for (const double adaptive : {0.05, 0.02, 0.01}) {
        CHECK(pictureError(centres, truth).rmse > adaptive);
        CHECK(pictureError(picture(4096, adaptive), truth).rmse < adaptive);
    }
}
