// The whole range of double, and the corners of the light model: every pixel is a finite number, and the
// right one.
#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "../support/described.h"
#include "raytracer/scene/affine.h"
#include "raytracer/scene/mesh_file.h"

using namespace raytracer;
using namespace raytracer::test;
using Type = ShapeType;

namespace {

constexpr int edge = 60;

FloatImage floatsOf(const SceneDescription& scene, Precision precision = Precision::Double) {
    RenderOptions options = wholePicture(scene, edge);
    options.threads = 1;
    return renderFloats(*makeRenderer(scene, precision), options);
}

bool isFinite(const FloatImage& image) {
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](float x) { return std::isfinite(x); });
}

TransformDescription at(const glm::dvec3& place, const glm::dvec3& scale) {
    return {"", place, {}, scale, {}};
}

// A perspective camera at (0, 0, 4) that sees -2 to 2 at z = 0.
SceneMaker perspective() {
    SceneMaker maker;
    maker.scene.camera = CameraDescription{};
    maker.scene.camera.eye = {0, 0, 4};
    maker.scene.camera.film_left = maker.scene.camera.film_bottom = -0.5;
    maker.scene.camera.film_right = maker.scene.camera.film_top = 0.5;
    return maker;
}

// A ball, a mirroring cone, a glass cube and a cylinder before a wall, lit from the left.
void addStillLife(SceneMaker& maker, double size) {
    const auto diffuse = [&](const glm::dvec3& color) -> MaterialDescription& {
        MaterialDescription& m = maker.material(0.1 * color);
        m.color_diffuse = color;
        m.color_specular = glm::dvec3(0.5);
        return m;
    };
    diffuse({0.8, 0.3, 0.2});
    maker.shape(Type::Sphere, at(size * glm::dvec3(-0.8, 0.7, 0), size * glm::dvec3(0.6)));
    MaterialDescription& mirror = diffuse({0.1, 0.5, 0.3});
    mirror.reflective = true;
    mirror.color_reflect = glm::dvec3(0.6);
    maker.shape(Type::Cone, {"",
                             size * glm::dvec3(0.8, 0.4, 0),
                             TransformDescription::Rotation{-60, {1, 0.2, 0}},
                             size * glm::dvec3(0.6, 0.6, 1),
                             {}});
    maker.glass(glm::dvec3(0.8, 0.9, 1), 1.4);
    maker.shape(Type::Cube, {"",
                             size * glm::dvec3(-0.7, -0.8, 0.2),
                             TransformDescription::Rotation{30, {1, 2, 0}},
                             size * glm::dvec3(0.45),
                             {}});
    diffuse({0.2, 0.3, 0.9});
    maker.shape(Type::Cylinder, {"",
                                 size * glm::dvec3(0.6, -0.9, 0),
                                 TransformDescription::Rotation{50, {0, 1, 1}},
                                 size * glm::dvec3(0.4),
                                 {}});
    diffuse({0.7, 0.7, 0.7});
    maker.shape(Type::Cube, at(size * glm::dvec3(0, 0, -1.5), size * glm::dvec3(3, 3, 0.5)));
    maker.light(size * glm::dvec3(-4, 3, 6));
}

SceneDescription stillLife(double size) {
    SceneMaker maker = perspective();
    maker.scene.camera.eye *= size;
    addStillLife(maker, size);
    return maker.scene;
}

}  // namespace

// Around the camera and a still life of the size given, a sky of 1e100, dust of 1e-100 and a small moon out
// of sight: the picture of the still life must be as if it were alone.
TEST_CASE("range: sizes of 1e-100, 1 and 1e100 in one scene") {
    const ByteImage alone = bytesOf(stillLife(1), edge);
    for (const double size : {1e-100, 1e-30, 1., 1e30, 1e90}) {
        SceneMaker maker = perspective();
        maker.scene.camera.eye *= size;
        addStillLife(maker, size);
        maker.material(glm::dvec3(0));  // black, like nothing
        maker.shape(Type::Sphere, at({0, 0, 0}, glm::dvec3(1e100)));
        maker.shape(Type::Sphere, at({0, 0, 0}, glm::dvec3(1e-100, 1e-100, -1e-100) * 1e-4));
        maker.shape(Type::Cube, at({0, 0, 1e99}, glm::dvec3(1)));
        const ByteImage image = bytesOf(maker.scene, edge);
        INFO(size << ": " << differingPixels(alone, image, 0) << " pixels");
        CHECK(differingPixels(alone, image, 1) <= 1);
    }
}

// Every shape stretched 1e6 : 1, sheared, mirrored and turned back and forth, before a wall: as extended
// precision has it.
TEST_CASE("range: anisotropy of 1e6, shear and mirroring") {
    int wrong = 0, pixels = 0;
    for (const Type type : {Type::Sphere, Type::Cylinder, Type::Cone, Type::Cube, Type::Plane})
        for (const glm::dvec3& scale : {glm::dvec3(1e3, 1, 1e-3), glm::dvec3(1e-3, 1e3, 1),
                                        glm::dvec3(1, -1e-6, 1), glm::dvec3(-1e6, 1, 1)})
            for (const double degrees : {0., 1e-3, 37., 90.}) {
                SceneMaker maker = perspective();
                addStillLife(maker, 1);
                MaterialDescription& m = maker.glass(glm::dvec3(0.5), 1.1);
                m.reflective = true;
                m.color_diffuse = glm::dvec3(0.3, 0.1, 0.2);
                maker.shape(
                    type, {"", glm::dvec3(0.1, 0.2, 0.3), TransformDescription::Rotation{degrees, {1, 2, 3}},
                           scale, glm::dmat4(1, 0.3, 0, 0, 0, 1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1)});
                const ByteImage image = bytesOf(maker.scene, edge);
                wrong += differingPixels(image, bytesOf(maker.scene, edge, Precision::Extended), 1);
                pixels += image.width * image.height;
            }
    INFO(wrong << " of " << pixels);
    CHECK(wrong * 10000 <= pixels);
}

// The frame's and the film's numbers as far from 1 as can be, the picture the same. (In float, whose range
// they leave: they are brought to the order of 1 before they become Real.)
TEST_CASE("range: a camera of very long and very short vectors") {
    const SceneDescription scene = stillLife(1);
    SceneDescription other = scene;
    CameraDescription& camera = other.camera;
    const auto setFilm = [&](double half) {
        camera.film_left = camera.film_bottom = -half, camera.film_right = camera.film_top = half;
    };
    SECTION("a small film nearby") { camera.focal_length = 1e-200, setFilm(0.5e-200); }
    SECTION("a large film far away") { camera.focal_length = 1e200, setFilm(0.5e200); }
    SECTION("a short frame and a large film") { camera.up = {0, 1e-200, 0}, setFilm(0.5e200); }
    SECTION("a long frame and a small film") { camera.up = {0, 1e200, 0}, setFilm(0.5e-200); }
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended}) {
        INFO(static_cast<int>(precision));
        CHECK(differingPixels(bytesOf(scene, edge, precision), bytesOf(other, edge, precision), 1) <= 1);
    }
}

// Of a line that passes by the apex, the textbook's discriminant is all but cancelled: to a root of the
// roundoff, which is more than a pixel here.
TEST_CASE("range: the tip of a cone, seen from very near") {
    for (const double size : {1e-3, 1e-6, 1e-9}) {
        SceneMaker maker = perspective();
        maker.scene.camera.eye *= size;
        MaterialDescription& m = maker.material(glm::dvec3(0.1));
        m.color_diffuse = glm::dvec3(0.7, 0.5, 0.3);
        const glm::dmat4 tipToOrigin(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1);
        maker.shape(Type::Cone, {"", {}, TransformDescription::Rotation{-60, {1, 0.2, 0}}, {}, tipToOrigin});
        maker.light(size * glm::dvec3(-4, 3, 6));
        INFO(size);
        CHECK(differingPixels(bytesOf(maker.scene, edge), bytesOf(maker.scene, edge, Precision::Extended),
                              1) <= 1);
    }
}

// However thin: one that is 1e-20 thick or less is farther from the camera than its own roundings.
TEST_CASE("range: a flat sphere, cylinder and cone are the discs that they look like") {
    const auto picture = [](Type type, double thickness, Precision precision) {
        SceneMaker maker = perspective();
        maker.material({0.2, 0.5, 0.9});
        maker.shape(type, {"",
                           glm::dvec3(0.1, 0.2, 0),
                           TransformDescription::Rotation{30, {1, 0, 0}},
                           type == Type::Cylinder ? glm::dvec3(thickness, 1, 1) : glm::dvec3(1, 1, thickness),
                           {}});
        maker.light({-4, 3, 6});
        return bytesOf(maker.scene, edge, precision);
    };
    for (const Type type : {Type::Sphere, Type::Cylinder, Type::Cone})
        for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended}) {
            const ByteImage flat = picture(type, 1e-6, precision);
            CHECK_FALSE(
                std::all_of(flat.pixels.begin(), flat.pixels.end(), [](auto byte) { return byte == 0; }));
            for (const double thickness : {1e-12, 1e-20, 1e-40, 1e-149, 1e-300, 1e-320}) {
                INFO(static_cast<int>(type) << ", " << static_cast<int>(precision) << ", " << thickness);
                CHECK(differingPixels(flat, picture(type, thickness, precision), 1) <= 8);
            }
        }
}

TEST_CASE("range: a flat sphere of a few pixels is the disc that it looks like") {
    const auto picture = [](double thickness, Precision precision) {
        SceneMaker maker;
        maker.scene.camera.type = CameraDescription::Type::Perspective;
        maker.scene.camera.eye = {0.1, 0.2, 4};
        maker.material(glm::dvec3(0)).color_diffuse = {0.7, 0.6, 0.5};
        maker.shape(Type::Sphere,
                    {"", glm::dvec3(0.55, 0.65, 0.995), {}, glm::dvec3(0.05, 0.05, thickness), {}});
        maker.light({2, 3, 5});
        return bytesOf(maker.scene, 400, precision);
    };
    for (const Precision precision : {Precision::Float, Precision::Double})
        for (const double thickness : {5e-16, 5e-17})
            CHECK(differingPixels(picture(1e-7, Precision::Double), picture(thickness, precision), 1) == 0);
}

// A mirroring octahedron one of whose corners is moved far behind the others, on a floor that mirrors it.
// That corner is the last of its triangles, or the first or the middle one.
TEST_CASE("range: a mesh that reaches very far is right where it is small") {
    const auto picture = [](double farthest, Precision precision, bool glass, int turn = 0) {
        SceneMaker maker = perspective();
        maker.scene.camera.eye = {0.1, 1, 4};
        MaterialDescription& m = maker.material(glm::dvec3(0.1));
        m.color_diffuse = glm::dvec3(0.7, 0.5, 0.3);
        m.reflective = true;
        m.color_reflect = glm::dvec3(0.5);
        m.refractive = glass;
        m.color_refract = glm::dvec3(0.5);
        m.index_of_refraction = 1.3;
        MeshData mesh;
        mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -farthest}};
        mesh.positionIndex = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
        for (auto corner = mesh.positionIndex.begin(); corner != mesh.positionIndex.end(); corner += 3)
            std::rotate(corner, corner + turn, corner + 3);
        mesh.findBounds();
        mesh.chooseUnit();
        maker.shape(Type::Mesh, {"", {}, {}, {}, {}});
        maker.scene.shapes[0].mesh = std::make_shared<const MeshData>(mesh);
        maker.shape(Type::Plane,
                    {"", glm::dvec3(0, -1.5, 0), TransformDescription::Rotation{-90, {1, 0, 0}}, {}, {}});
        maker.light({-4, 3, 6});
        maker.light({0, -1, 3});
        return bytesOf(maker.scene, edge, precision);
    };
    for (const bool glass : {false, true}) {
        const ByteImage expected = picture(1e6, Precision::Extended, glass);
        for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended})
            for (const double farthest : {1e6, 1e9, 1e12, 1e16, 1e18, 1e30, 1e119})
                for (const int turn : {0, 1, 2}) {
                    const int differing =
                        differingPixels(expected, picture(farthest, precision, glass, turn), 5);
                    INFO((glass ? "glass, " : "mirror, ") << static_cast<int>(precision) << ", " << farthest
                                                          << ": " << differing << " pixels");
                    CHECK(differing <= 3);
                }
    }
}

// A shadow that is 10^15 times as large as what casts it: the way back to the light has to be known as well
// as the picture is.
TEST_CASE("range: a shadow on a wall that is far away") {
    const auto picture = [](double distance, Precision precision) {
        SceneMaker maker = perspective();
        maker.scene.camera.eye = {3, 0, 5};
        maker.material(glm::dvec3(0.1)).color_diffuse = glm::dvec3(0.8);
        maker.shape(Type::Cube, {"", {}, TransformDescription::Rotation{37, {1, 2, 3}}, {}, {}});
        maker.shape(Type::Plane, {"", glm::dvec3(0, 0, -distance), {}, {}, {}});
        maker.light({0.1, 0.2, 5});
        return bytesOf(maker.scene, edge, precision);
    };
    const ByteImage expected = picture(1e5, Precision::Extended);
    for (const double distance : {1e7, 1e11, 1e13, 1e15})
        for (const Precision precision : {Precision::Float, Precision::Double}) {
            INFO(distance << ", " << static_cast<int>(precision));
            CHECK(differingPixels(expected, picture(distance, precision), 1) <= 1);
        }
}

// An octahedron whose vertices are of this size and whose transform takes it back, and one tiny triangle.
TEST_CASE("range: a mesh of any unit is the same picture to the byte") {
    const auto picture = [](int exponent, Precision precision) {
        SceneMaker maker = perspective();
        MaterialDescription& m = maker.material(glm::dvec3(0.1));
        m.color_diffuse = glm::dvec3(0.7, 0.5, 0.3);
        m.reflective = true;
        m.color_reflect = glm::dvec3(0.5);
        MeshData mesh;
        for (int i = 0; i < 6; ++i) {
            glm::dvec3 p(0);
            p[i / 2] = std::ldexp(i % 2 == 0 ? 1.0 : -1.0, exponent);
            mesh.positions.push_back(p);
        }
        for (std::uint32_t octant = 0; octant < 8; ++octant) {
            const std::uint32_t x = octant & 1, y = 2 + (octant >> 1 & 1), z = 4 + (octant >> 2);
            const bool turned = (x + y + z) % 2 == 1;
            for (const std::uint32_t corner : {x, turned ? z : y, turned ? y : z})
                mesh.positionIndex.push_back(corner);
        }
        mesh.findBounds();
        mesh.chooseUnit();
        maker.shape(Type::Mesh,
                    {"", glm::dvec3(0.1, 0.2, 0), TransformDescription::Rotation{30, {1, 2, 3}},
                     glm::dvec3(std::ldexp(1.0, -exponent / 2)),
                     glm::scale(glm::dmat4(1), glm::dvec3(std::ldexp(1.0, exponent / 2 - exponent)))});
        maker.scene.shapes[0].mesh = std::make_shared<const MeshData>(mesh);
        maker.light({-4, 3, 6});
        return bytesOf(maker.scene, edge, precision);
    };
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended}) {
        const ByteImage plain = picture(0, precision);
        for (const int exponent : {-1022, -400, -60, 44, 60, 400, 1022}) {
            INFO(static_cast<int>(precision) << ", 2^" << exponent);
            CHECK(picture(exponent, precision).pixels == plain.pixels);
        }
    }
}

TEST_CASE("range: a film whose width is beyond double") {
    CameraDescription camera;
    camera.film_left = -1.7e308, camera.film_right = 1.7e308;
    camera.film_bottom = -0.85e308, camera.film_top = 0.85e308;
    CHECK(imageSize(camera, 100).width == 100);
    CHECK(imageSize(camera, 100).height == 50);
}

TEST_CASE("range: colours of any size, and mirrors that brighten a thousand times") {
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended}) {
        SceneDescription scene = stillLife(1);
        const ByteImage plain = bytesOf(scene, edge, precision);
        for (MaterialDescription& m : scene.materials) m.color_ambient *= 1e-200, m.color_diffuse *= 1e-200;
        for (MaterialDescription& m : scene.materials) m.color_specular *= 1e-200;
        for (LightDescription& light : scene.lights) light.color *= 1e200, light.color_ambient *= 1e200;
        CHECK(differingPixels(plain, bytesOf(scene, edge, precision), 1) <= 1);
        for (MaterialDescription& m : scene.materials) {
            m.reflective = true;
            m.color_reflect = glm::dvec3(0, 3, 1e9);
        }
        SceneMaker maker = perspective();
        maker.scene.materials = scene.materials;
        maker.shape(Type::Plane, at({0, 0, -1}, glm::dvec3(1)));
        maker.scene.materials[0].color_reflect = glm::dvec3(1, 0, 1);
        maker.scene.shapes.push_back({Type::Plane, 1, 0, nullptr});
        maker.scene.transforms.push_back(at({0, 0, 5}, glm::dvec3(1)));
        maker.light({0, 0, 10}, glm::dvec3(1e3));
        RenderOptions options = wholePicture(maker.scene, 4);
        options.max_recursion = 1000;
        CHECK(isFinite(renderFloats(*makeRenderer(maker.scene, precision), options)));
        options.cutoff = 1e-9;
        CHECK(isFinite(renderFloats(*makeRenderer(maker.scene, precision), options)));
    }
}

TEST_CASE("range: shininess and indices of refraction") {
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended})
        for (const double shininess : {0., 1e-300, 0.5, 1., 1e6, 1e300})
            for (const double index : {1 - 1e-15, 1., 1 + 1e-15, 0.1, 10.}) {
                SceneDescription scene = stillLife(1);
                for (MaterialDescription& material : scene.materials) material.shininess = shininess;
                for (MaterialDescription& material : scene.materials) material.index_of_refraction = index;
                INFO(shininess << ", " << index);
                CHECK(isFinite(floatsOf(scene, precision)));
            }
}

TEST_CASE("range: an index of refraction of all but 1 bends nothing") {
    SceneDescription scene = stillLife(1);
    const auto withIndex = [&](double index) {
        for (MaterialDescription& material : scene.materials) material.index_of_refraction = index;
        return bytesOf(scene, edge);
    };
    const ByteImage straight = withIndex(1);
    for (const double index : {1 - 1e-15, 1 + 1e-15})
        CHECK(differingPixels(straight, withIndex(index), 1) <= 1);
}

TEST_CASE("range: lights on surfaces, at the eye, at a point that is seen, and very bright") {
    for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended}) {
        SceneDescription scene = stillLife(1);
        const glm::dvec3 places[] = {{0, 0, -1}, {-0.8, 1.3, 0},         {-0.8, 0.7, 0.6},
                                     {0, 0, 4},  {1. / 60, 1. / 60, -1}, {0.6, -0.9, 0}};
        for (const glm::dvec3& place : places) {
            scene.lights[0].position = place;
            CHECK(isFinite(floatsOf(scene, precision)));
        }
        scene.lights[0].position = {-4, 3, 6};
        scene.lights[0].color = scene.lights[0].color_ambient = glm::dvec3(1e300, 0, 1e30);
        for (MaterialDescription& material : scene.materials)
            material.color_specular = glm::dvec3(1e300, 1e300, 0);
        bool number = true;
        for (const float x : floatsOf(scene, precision).pixels) number = number && !std::isnan(x);
        CHECK(number);
    }
}

// A light that lies on the wall lights no point of the wall, and its highlight must not speckle it.
TEST_CASE("range: a light on a surface leaves that surface to its ambient colour") {
    // Not in extended precision, which can tell the plane from a light whose place is rounded to double.
    for (const Precision precision : {Precision::Float, Precision::Double})
        for (const double degrees : {0., 10., 37.}) {
            SceneMaker maker = perspective();
            MaterialDescription& m = maker.material(glm::dvec3(0.25));
            m.color_diffuse = m.color_specular = glm::dvec3(1);
            m.shininess = 0;  // any light at all would be seen in full
            const TransformDescription wall{
                "", glm::dvec3(0.1, 0.2, 0.3), TransformDescription::Rotation{degrees, {1, 2, 3}}, {}, {}};
            maker.shape(Type::Plane, wall);
            const Affine map = compose(wall);
            glm::dvec3 place;
            for (int row = 0; row < 3; ++row)
                place[row] = static_cast<double>(0.3L * map.linear[row][0] - 0.7L * map.linear[row][1] +
                                                 map.translation[row]);
            maker.light(place);
            const ByteImage image = bytesOf(maker.scene, edge, precision);
            INFO(degrees << " degrees, " << static_cast<int>(precision));
            CHECK(std::all_of(image.pixels.begin(), image.pixels.end(),
                              [](std::uint8_t byte) { return byte == 64; }));
        }
}

// The floor that the light lies on is behind the camera: it must not be seen in the light that falls on what
// is before it.
TEST_CASE("range: a surface that the light lies on casts no shadow") {
    for (const Type type : {Type::Plane, Type::Cylinder, Type::Cone, Type::Cube, Type::Sphere})
        for (const double degrees : {0., 10., 37.}) {
            SceneMaker maker = perspective();
            addStillLife(maker, 1);
            TransformDescription floor{"",
                                       glm::dvec3(0.1, 0.2, 7),
                                       TransformDescription::Rotation{degrees, {1, 2, 3}},
                                       glm::dvec3(0.3),
                                       {}};
            const Affine map = compose(floor);
            const bool centred =
                type == Type::Cube || type == Type::Sphere;  // the side towards the still life is z = -1
            const glm::dvec3 place(type == Type::Sphere ? 0 : 0.6, 0, centred ? -1 : 0);
            for (int row = 0; row < 3; ++row)
                maker.scene.lights[0].position[row] =
                    static_cast<double>(map.linear[row][0] * place.x + map.linear[row][1] * place.y +
                                        map.linear[row][2] * place.z + map.translation[row]);
            const ByteImage without = bytesOf(maker.scene, edge);
            maker.material(glm::dvec3(0));
            maker.shape(type, floor);
            INFO(static_cast<int>(type) << " turned by " << degrees);
            CHECK(differingPixels(without, bytesOf(maker.scene, edge), 0) == 0);
        }
}
