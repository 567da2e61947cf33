// Surfaces that coincide are one surface, and the shape listed first has it: no speckle, in any pose.
#include <catch2/catch.hpp>

#include "../support/described.h"
#include "raytracer/scene/affine.h"

using namespace raytracer;
using namespace raytracer::test;
using Type = ShapeType;

namespace {

const glm::dvec3 red(1, 0, 0), green(0, 1, 0), blue(0, 0, 1);

// Poses whose numbers are no binary fractions.
std::vector<TransformDescription> awkwardPoses() {
    const TransformDescription::Rotation odd{37, {1, 2, 3}};
    return {{"plain", {}, {}, {}, {}},
            {"moved", glm::dvec3(0.1, 0.2, 0.3), {}, {}, {}},
            {"turned", glm::dvec3(0.1, -0.7, 0.3), odd, {}, {}},
            {"far", glm::dvec3(1e4 / 3, -1e5 / 7, 1e3 / 9), odd, glm::dvec3(0.1, 0.1, 0.1), {}}};
}

// The camera and every transform of the scene, put into the world by the pose: rotate first, then move.
SceneDescription posed(SceneDescription scene, const TransformDescription& pose) {
    const Affine map = compose(pose);
    const auto point = [&](const glm::dvec3& p) {
        glm::dvec3 out;
        for (int row = 0; row < 3; ++row)
            out[row] = static_cast<double>(map.linear[row][0] * p.x + map.linear[row][1] * p.y +
                                           map.linear[row][2] * p.z + map.translation[row]);
        return out;
    };
    const glm::dvec3 origin = point(glm::dvec3(0));
    CameraDescription& camera = scene.camera;
    camera.eye = point(camera.eye);
    camera.look =
        glm::normalize(point(camera.look) - origin);  // u = up x -look: only one of them has the scale
    camera.up = point(camera.up) - origin;
    for (LightDescription& light : scene.lights) light.position = point(light.position);
    for (TransformDescription& transform : scene.transforms) {
        const Affine own = compose(transform);
        glm::dmat4 matrix(1);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                matrix[column][row] = static_cast<double>(own.linear[row][column]);
            matrix[3][row] = static_cast<double>(own.translation[row]);
        }
        transform = pose;
        transform.matrix = matrix;
    }
    return scene;
}

void lookFrom(SceneDescription& scene, const glm::dvec3& eye, const glm::dvec3& look, const glm::dvec3& up,
              double film) {
    scene.camera.eye = eye, scene.camera.look = look, scene.camera.up = up;
    setFilm(scene, -film, film);
}

// How many pixels of the picture show each colour.
struct Colors {
    int red = 0, green = 0, blue = 0, other = 0;
};

Colors colorsOf(const ByteImage& image) {
    Colors colors;
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        const auto is = [&](int r, int g, int b) {
            return image.pixels[i] == r && image.pixels[i + 1] == g && image.pixels[i + 2] == b;
        };
        ++(is(255, 0, 0)   ? colors.red
           : is(0, 255, 0) ? colors.green
           : is(0, 0, 255) ? colors.blue
                           : colors.other);
    }
    return colors;
}

constexpr int posedEdge = 64;

}  // namespace

// A red plane and a green cylinder of radius 1 on it, over a film of +-0.7: all of the picture is within the
// base.
TEST_CASE("coincidence: a cylinder on a plane") {
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended})
        for (const TransformDescription& pose : awkwardPoses())
            for (const bool planeFirst : {true, false})
                for (const double side : {1.0, -1.0}) {
                    SceneMaker maker;
                    const auto plane = [&] { maker.material(red), maker.shape(Type::Plane, {}); };
                    if (planeFirst) plane();
                    maker.material(green);
                    maker.shape(Type::Cylinder, {});
                    if (!planeFirst) plane();
                    maker.light({0, 0, 20});
                    lookFrom(maker.scene, {0, 0, 10 * side}, {0, 0, -side}, {0, 1, 0}, 0.7);
                    const Colors colors = colorsOf(bytesOf(posed(maker.scene, pose), posedEdge, precision));
                    INFO(pose.name << (planeFirst ? ", plane first" : ", cylinder first")
                                   << (side > 0 ? ", from above" : ", from below"));
                    CHECK((side > 0 || !planeFirst ? colors.green : colors.red) == posedEdge * posedEdge);
                }
}

// Rays that start on a surface leave their packet; many surfaces are met at t = 0, in the tree's order.
TEST_CASE("coincidence: of balls that touch the eye, the one listed first is seen") {
    constexpr int balls = 48;
    for (int first = 0; first < balls; first += 5) {
        SceneMaker maker;
        for (int i = 0; i < balls; ++i) {
            const double angle = (first + i) % balls * (2 * 3.14159265358979 / balls);
            maker.material(i == 0 ? red : green);
            maker.shape(Type::Sphere, {"", glm::dvec3(std::cos(angle), std::sin(angle), 0), {}, {}, {}});
        }
        maker.light({0, 0, 20});
        maker.scene.camera = CameraDescription{};
        INFO("ball " << first);
        CHECK(colorsOf(bytesOf(maker.scene, posedEdge)).red == posedEdge * posedEdge);
    }
}

// Planes nearer to each other than t can tell, from afar: the near one is seen, and nothing shadows it.
TEST_CASE("coincidence: planes that lie apart by less than a rounded t") {
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended})
        for (const double gap : {1e-20, 1e-30})
            for (const double side : {1.0, -1.0}) {
                SceneMaker maker;
                for (const int layer : {1, 0, 2, -1}) {
                    MaterialDescription& material = maker.material(glm::dvec3(0));
                    material.color_diffuse = layer == (side > 0 ? 2 : -1) ? green : red;
                    maker.shape(Type::Plane, {"", glm::dvec3(0, 0, gap * layer), {}, {}, {}});
                }
                maker.light({0, 0, 1000 * side});
                lookFrom(maker.scene, {0.1, 0.2, 4 * side}, {0, 0, -side}, {0, 1, 0}, 0.3);
                INFO(gap << (side > 0 ? ", from above" : ", from below"));
                CHECK(colorsOf(bytesOf(maker.scene, posedEdge, precision)).green == posedEdge * posedEdge);
            }
}

// The same from aslant, where pixels beside the base must be the plane's and no pixel of the base may be
// both.
TEST_CASE("coincidence: a cylinder on a plane, from aslant below") {
    for (const TransformDescription& pose : awkwardPoses())
        for (const bool planeFirst : {true, false}) {
            SceneMaker maker;
            const auto plane = [&] { maker.material(red), maker.shape(Type::Plane, {}); };
            if (planeFirst) plane();
            maker.material(green);
            maker.shape(Type::Cylinder, {});
            if (!planeFirst) plane();
            maker.light({0, 0, 20});
            lookFrom(maker.scene, {0, -6, -8}, {0, 0.6, 0.8}, {0, 0.8, -0.6}, 2);
            const ByteImage image = bytesOf(posed(maker.scene, pose), posedEdge);
            const Colors colors = colorsOf(image);
            INFO(pose.name << (planeFirst ? ", plane first" : ", cylinder first"));
            CHECK(colors.red + colors.green == posedEdge * posedEdge);
            // The base is a disc seen at 0.8 of its height: pi * 16 * 16 * 0.8 pixels.
            if (planeFirst) CHECK(colors.green == 0);
            if (!planeFirst) CHECK(std::abs(colors.green - 643) < 20);
        }
}

// 0.3 + 0.1 is not 0.4 in binary: the cube's top and the plane are as close as the file's numbers can say.
TEST_CASE("coincidence: faces that decimal numbers put together") {
    for (const Precision precision : {Precision::Float, Precision::Double})
        for (const TransformDescription& pose : awkwardPoses())
            for (const bool planeFirst : {true, false}) {
                SceneMaker maker;
                const auto plane = [&] {
                    maker.material(red), maker.shape(Type::Plane, {"", glm::dvec3(0, 0, 0.4), {}, {}, {}});
                };
                if (planeFirst) plane();
                maker.material(green);
                maker.shape(Type::Cube, {"", glm::dvec3(0, 0, 0.3), {}, glm::dvec3(0.1, 0.1, 0.1), {}});
                if (!planeFirst) plane();
                maker.light({0, 0, 20});
                lookFrom(maker.scene, {0, 0, 10}, {0, 0, -1}, {0, 1, 0}, 0.09);
                const Colors colors = colorsOf(bytesOf(posed(maker.scene, pose), posedEdge, precision));
                INFO(pose.name << (planeFirst ? ", plane first" : ", cube first"));
                CHECK((planeFirst ? colors.red : colors.green) == posedEdge * posedEdge);
            }
}

// Seen from within the red one, through the face that it shares with the green one.
TEST_CASE("coincidence: two cubes that share a face, from inside one") {
    for (const TransformDescription& pose : awkwardPoses())
        for (const bool insideFirst : {true, false}) {
            SceneMaker maker;
            const TransformDescription here{"", {}, {}, glm::dvec3(0.3), {}},
                there{"", glm::dvec3(0, 0, -0.6), {}, glm::dvec3(0.3), {}};
            maker.material(insideFirst ? red : green);
            maker.shape(Type::Cube, insideFirst ? here : there);
            maker.material(insideFirst ? green : red);
            maker.shape(Type::Cube, insideFirst ? there : here);
            maker.light({0, 0, 20});
            lookFrom(maker.scene, {0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 0.25);
            const Colors colors = colorsOf(bytesOf(posed(maker.scene, pose), posedEdge));
            INFO(pose.name << (insideFirst ? ", the camera's first" : ", the other one first"));
            CHECK((insideFirst ? colors.red : colors.green) == posedEdge * posedEdge);
        }
}

// Straight down through glass on water onto a floor: at the shared face the first listed counts, once.
TEST_CASE("coincidence: glass that touches water") {
    for (const TransformDescription& pose : awkwardPoses())
        for (const bool glassFirst : {true, false}) {
            SceneMaker maker;
            const double glassColor = 0.5, waterColor = 0.75;
            const auto glass = [&] {
                maker.glass(glm::dvec3(glassColor), 1.5),
                    maker.shape(Type::Cube, {"", glm::dvec3(0, 0, 0.3), {}, glm::dvec3(0.3), {}});
            };
            if (glassFirst) glass();
            maker.glass(glm::dvec3(waterColor), 1.33);
            maker.shape(Type::Cylinder, {"", glm::dvec3(0, 0, -0.7), {}, glm::dvec3(1, 1, 0.7), {}});
            if (!glassFirst) glass();
            maker.material(glm::dvec3(1));
            maker.shape(Type::Plane, {"", glm::dvec3(0, 0, -1), {}, {}, {}});
            maker.light({0, 0, 20});
            lookFrom(maker.scene, {0, 0, 10}, {0, 0, -1}, {0, 1, 0}, 0.25);
            const ByteImage image = bytesOf(posed(maker.scene, pose), posedEdge);
            const double through = glassColor * waterColor * (glassFirst ? glassColor : waterColor);
            const int expected = static_cast<int>(std::lround(255 * through));
            bool all = true;
            for (const std::uint8_t byte : image.pixels) all = all && std::abs(byte - expected) <= 1;
            INFO(pose.name << (glassFirst ? ", glass first" : ", water first") << ": " << int(image.pixels[0])
                           << ", not " << expected);
            CHECK(all);
        }
}

// Every shape lies exactly on its double, which must never shade, hide or be seen.
TEST_CASE("coincidence: every shape of every scene listed twice") {
    for (const std::string& file : sceneFiles())
        for (const Precision precision : {Precision::Float, Precision::Double}) {
            SceneDescription scene = loadScene(file).description;
            const ByteImage once = bytesOf(scene, 60, precision);
            const auto shapes = scene.shapes;
            scene.shapes.insert(scene.shapes.end(), shapes.begin(), shapes.end());
            INFO(file << (precision == Precision::Float ? " in float" : ""));
            CHECK(differingPixels(once, bytesOf(scene, 60, precision), 0) == 0);
        }
}

// A double that is the same surface by other numbers: turned about its own axis. Its colour must not show.
TEST_CASE("coincidence: shapes and their doubles, turned about the axis") {
    for (const Type type : {Type::Sphere, Type::Cylinder, Type::Cone, Type::Plane, Type::Cube})
        for (const TransformDescription& pose : awkwardPoses()) {
            SceneMaker maker;
            MaterialDescription& own = maker.material(glm::dvec3(0.1));
            own.color_diffuse = red;
            own.reflective = true;
            maker.shape(type, {"", {}, {}, glm::dvec3(0.3), {}});
            maker.light({3, -2, 4});
            lookFrom(maker.scene, {0, -6, 8}, {0, 0.6, -0.8}, {0, 0.8, 0.6}, 0.5);
            const ByteImage alone = bytesOf(posed(maker.scene, pose), posedEdge);
            maker.material(blue);
            maker.shape(type, {"",
                               {},
                               TransformDescription::Rotation{type == Type::Cube ? 90. : 29., {0, 0, 1}},
                               glm::dvec3(0.3),
                               {}});
            const ByteImage both = bytesOf(posed(maker.scene, pose), posedEdge);
            INFO(static_cast<int>(type) << ", " << pose.name);
            CHECK(differingPixels(alone, both, 1) <= 1);  // a silhouette's pixel may meet only one of the two
        }
}
