// Every word about numbers that are hardly meant, and silence about the others.
#include <catch2/catch.hpp>

#include "raytracer/explain/scene_slips.h"
#include "raytracer/scene/mesh_file.h"

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
    scene.materials[0].color_ambient = {-200, 200, 0};
    scene.lights[0].color = {20, 20, 20};
    scene.lights[0].color_ambient = {1000, 1, 1};
    CHECK(sceneSlips(scene).empty());
    scene.materials[1].color_diffuse = {255, 128, 0};
    scene.materials[1].color_specular = {12, 0, 0};
    scene.materials[1].color_reflect = {127.5, 127.5, 127.5};
    scene.materials[1].color_refract = {200, 0.1, 0.1};
    scene.materials[1].color_ambient = {300, 300, 300};
    scene.lights[0].color = {256, 256, 256};
    scene.lights[0].color_ambient = {100, 100, 90.5};
    const std::string begin = ": colors end at 1: divide ";
    CHECK(sceneSlips(scene) == Slips{"/materials/1/color_ambient" + begin + "300 300 300 by 255",
                                     "/materials/1/color_diffuse" + begin + "255 128 0 by 255",
                                     "/materials/1/color_specular" + begin + "12 0 0 by 255",
                                     "/materials/1/color_reflect" + begin + "127.5 127.5 127.5 by 255",
                                     "/materials/1/color_refract" + begin + "200 0.1 0.1 by 255",
                                     "/lights/0/color" + begin + "256 256 256 by 255",
                                     "/lights/0/color_ambient" + begin + "100 100 90.5 by 255"});
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
          Slips{"/textures/stone: no material uses it: name it in a diffuse_texture, or delete it",
                "/materials/0/diffuse_texture: not shown without \"use_diffuse_texture\": true"});
    scene.materials[0].use_diffuse_texture = true;
    scene.textures.pop_back();
    CHECK(sceneSlips(scene).empty());
}

TEST_CASE("a mesh that is inside out is told once") {
    SceneDescription scene;
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
    CHECK(slips[20] == "80 more warnings");
}

TEST_CASE("colors without effect are told to who asks") {
    SceneDescription scene;
    scene.materials.resize(3);
    scene.materials[1].color_reflect = {0.5, 0.5, 0.5};
    scene.materials[1].color_refract = {0.5, 0.5, 1};
    scene.materials[2] = scene.materials[1];
    scene.materials[2].reflective = scene.materials[2].refractive = true;
    CHECK(colorsWithoutEffect(scene) ==
          Slips{"/materials/1/color_reflect: it has no effect without \"reflective\": true",
                "/materials/1/color_refract: it has no effect without \"refractive\": true"});
    CHECK(sceneSlips(scene).empty());
}
