// Every word about numbers that are hardly meant, and silence about the others.
#include <catch2/catch.hpp>

#include "raytracer/explain/scene_advice.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/util/text.h"

using namespace raytracer;

namespace {

using Slips = std::vector<std::string>;

// A tetrahedron far from its origin, with its triangles counter-clockwise seen from outside, or clockwise.
ShapeDescription tetrahedron(bool insideOut, bool open = false) {
    auto mesh = std::make_shared<MeshData>();
    mesh->positions = {{100, 0, 0}, {101, 0, 0}, {100, 1, 0}, {100, 0, 1}};
    mesh->positionIndex = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    if (open) mesh->positionIndex.resize(9);
    for (std::size_t i = 0; insideOut && i < mesh->positionIndex.size(); i += 3)
        std::swap(mesh->positionIndex[i], mesh->positionIndex[i + 1]);
    mesh->findBounds();
    return {ShapeType::Mesh, 0, 0, mesh};
}

}  // namespace

TEST_CASE("colors of 0 to 255 are told, bright ones are not") {
    SceneDescription scene;
    scene.materials.resize(2);
    scene.lights.resize(1);
    CHECK(sceneSlips(scene).empty());
    scene.materials[0].color_diffuse = {1.6, 2, 0};
    scene.materials[0].color_specular = {3, 2, 1};
    scene.materials[0].color_ambient = {9.9, 9.9, 0};
    scene.lights[0].color = {19.9, 10, 19.9};
    CHECK(sceneSlips(scene).empty());
    scene.materials[1].color_diffuse = {255, 128, 0};
    scene.materials[1].color_specular = {12, 0, 0};
    scene.materials[1].color_reflect = {127.5, 127.5, 127.5};
    scene.materials[1].color_refract = {200, 0.1, 0.1};
    scene.materials[1].color_ambient = {300, 300, 300};
    scene.lights[0].color = {256, 256, 256};
    scene.lights[0].color_ambient = {51, 20, 20};
    const std::string begin = ": colors end at 1: divide ";
    CHECK(sceneSlips(scene) ==
          Slips{"/materials/1/color_ambient" + begin + "300 300 300 by 255",
                "/materials/1/color_diffuse" + begin + "255 128 0 by 255",
                "/materials/1/color_specular" + begin + "12 0 0 by 255",
                "/materials/1/color_reflect" + begin + "127.5 127.5 127.5 by 255",
                "/materials/1/color_refract" + begin + "200 0.1 0.1 by 255",
                "/lights/0/color: white is 1 1 1: if this is in bytes, divide it by 255",
                "/lights/0/color_ambient: white is 1 1 1: if this is in bytes, divide it by 255"});
}

TEST_CASE("colors that are too bright in any unit are told") {
    for (const double bright : {511.0, 1000.0, 2500.0, 131071.0, 1e300}) {
        SceneDescription scene;
        scene.materials.resize(1);
        scene.lights.resize(1);
        scene.materials[0].color_reflect = {bright, 1, 1};
        scene.lights[0].color = glm::dvec3(bright);
        const std::string number = formatted("%.6g", bright);
        CHECK(sceneSlips(scene) ==
              Slips{"/materials/0/color_reflect: colors end at 1: divide " + number + " 1 1 by " + number,
                    "/lights/0/color: white is 1 1 1, since no distance dims light: divide " + number + " " +
                        number + " " + number + " by " + number});
    }
}

TEST_CASE("colors of 16 bits and negative ones are told") {
    SceneDescription scene;
    scene.materials.resize(1);
    scene.lights.resize(1);
    scene.materials[0].color_diffuse = {65535, 2600, 0};
    scene.materials[0].color_specular = {-0.1, 255, 0};
    scene.lights[0].color = {65535, 65535, 65535};
    scene.lights[0].color_ambient = {1, 1, -1};
    const std::string negative = ": a negative color takes light away: write 0 or more";
    CHECK(sceneSlips(scene) ==
          Slips{"/materials/0/color_diffuse: colors end at 1: divide 65535 2600 0 by 65535",
                "/materials/0/color_specular" + negative,
                "/lights/0/color: white is 1 1 1: if this is in 16 bits, divide it by 65535",
                "/lights/0/color_ambient" + negative});
}

TEST_CASE("a focal length in millimetres is told") {
    SceneDescription scene;
    scene.camera.focal_length = 17;
    CHECK(sceneSlips(scene).empty());
    scene.camera.focal_length = 50;
    CHECK(sceneSlips(scene) == Slips{"/camera/focal_length: 50 is long for a film of 2: "
                                     "if in mm, write 2.778"});
    for (const double longest : {324.0, 323.9999, 1000.0, 1e300}) {  // followed, it would be told again
        scene.camera.focal_length = longest;
        CHECK(sceneSlips(scene).empty());
    }
    scene.camera.film_right = 35;
    CHECK(sceneSlips(scene).empty());
    scene.camera.film_right = 1;
    scene.camera.focal_length = 50;
    scene.camera.type = CameraDescription::Type::Orthographic;
    CHECK(sceneSlips(scene).empty());
}

TEST_CASE("a textured mesh without texture coordinates is told, wherever it is used") {
    SceneDescription scene;
    scene.materials.resize(2);
    scene.materials[1].use_diffuse_texture = true;
    scene.materials[1].diffuse_texture = "wood";
    scene.textures = {{"wood", nullptr}};
    scene.shapes = {tetrahedron(false)};
    scene.shapes.push_back(scene.shapes[0]);
    CHECK(sceneSlips(scene).empty());
    scene.shapes[1].material = 1;
    CHECK(sceneSlips(scene) ==
          Slips{"/shapes/1/path: the mesh has no vt, so shows one texel: save it with texture coordinates"});
}

TEST_CASE("a film that mirrors is told") {
    SceneDescription scene;
    std::swap(scene.camera.film_left, scene.camera.film_right);
    std::swap(scene.camera.film_bottom, scene.camera.film_top);
    CHECK(sceneSlips(scene) ==
          Slips{"/camera/film_left: the picture is mirrored: swap it with film_right",
                "/camera/film_bottom: the picture is upside down: swap it with film_top"});
}

TEST_CASE("textures that are not shown are told") {
    SceneDescription scene;
    scene.textures = {{"wood", nullptr}, {"stone", nullptr}};
    scene.materials.resize(1);
    scene.materials[0].diffuse_texture = "wood";
    CHECK(sceneSlips(scene) ==
          Slips{"/textures/stone: no diffuse_texture names it: name it, or delete it",
                "/materials/0/diffuse_texture: not shown without \"use_diffuse_texture\": true"});
    scene.materials[0].use_diffuse_texture = true;
    scene.textures.pop_back();
    CHECK(sceneSlips(scene).empty());
}

TEST_CASE("a mesh that is inside out is told once") {
    SceneDescription scene;
    scene.materials.resize(1);
    scene.shapes = {tetrahedron(false), tetrahedron(true, true), tetrahedron(false, true)};
    CHECK(sceneSlips(scene).empty());
    scene.shapes.push_back(tetrahedron(true));
    scene.shapes.push_back(scene.shapes.back());
    CHECK(sceneSlips(scene) ==
          Slips{"/shapes/3/path: the mesh is inside out: turn its clockwise triangles round"});
}

TEST_CASE("of very many slips some are shown and the rest counted") {
    SceneDescription scene;
    scene.lights.resize(100, {glm::dvec3(0), glm::dvec3(255), glm::dvec3(0)});
    const Slips slips = sceneSlips(scene);
    REQUIRE(slips.size() == 21);
    CHECK(slips[20] == "and 80 more");
}

TEST_CASE("of very many notes some are shown and the rest counted") {
    SceneDescription scene;
    scene.lights.resize(21);
    CHECK(sceneNotes(scene).back() == "and 1 more");
}

TEST_CASE("what the course's own scenes do is told to who asks") {
    SceneDescription scene;
    scene.materials.resize(4);
    scene.materials[1].color_reflect = {0.5, 0.5, 0.5};
    scene.materials[1].color_refract = {0.5, 0.5, 1};
    scene.materials[2] = scene.materials[1];
    scene.materials[2].reflective = scene.materials[2].refractive = true;
    scene.materials[2].index_of_refraction = 1.5;
    scene.materials[3].refractive = true;
    scene.lights = {{glm::dvec3(1), glm::dvec3(1), glm::dvec3(1)}, {}};
    CHECK(sceneNotes(scene) ==
          Slips{"/materials/1/color_reflect: it has no effect without \"reflective\": true",
                "/materials/1/color_refract: it has no effect without \"refractive\": true",
                "/materials/3/index_of_refraction: 1 bends no ray: glass has 1.5",
                "/lights/1: it stands at 0 0 0, as one without a position does: set its position"});
    CHECK(sceneSlips(scene).empty());
}
