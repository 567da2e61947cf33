// Scene files: what comes of good ones, and every word that is said about bad ones.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "raytracer/pictures/texture.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/error.h"

using namespace raytracer;
namespace fs = std::filesystem;

namespace {

// Messages name files as they were asked for: here, relative to the source folder.
class InSourceFolder {
  public:
    InSourceFolder() { fs::current_path(SOURCE_DIR); }
    ~InSourceFolder() { fs::current_path(before_); }

  private:
    fs::path before_ = fs::current_path();
};

// A scene of this text in a file that is gone with it.
class SceneText {
  public:
    explicit SceneText(const std::string& text) { std::ofstream(path_, std::ios::binary) << text; }
    ~SceneText() { fs::remove(path_); }
    const std::string& path() const { return path_; }

  private:
    std::string path_ = (fs::temp_directory_path() / "raytracer_unit_loader.json").string();
};

// What is said first with --strict.
std::string faultOf(const std::string& path) {
    try {
        const std::vector<std::string> warnings = loadScene(path).warnings;
        return warnings.empty() ? "no fault" : warnings[0];
    } catch (const Error& error) {
        return error.what();
    }
}

std::string contents(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> badScenes() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator("test/bad"))
        if (entry.path().extension() == ".json") found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

const std::string camera =
    R"("camera": {"type": "orthographic", "eye": [0, 0, 5], "look": [0, 0, -1], "up": [0, 1, 0],
    "film_left": -1, "film_right": 1, "film_bottom": -1, "film_top": 1})";

std::string sceneOf(const std::string& shapes) {
    const std::string rest =
        R"(, "materials": [{}], "lights": [], "transforms": [{"name": "i"}], "shapes": [)";
    return '{' + camera + rest + shapes + "]}";
}

}  // namespace

TEST_CASE("Every bad scene gets its one line") {
    const InSourceFolder here;
    const auto scenes = badScenes();
    REQUIRE(scenes.size() > 100);
    for (const fs::path& scene : scenes)
        CHECK(faultOf(scene.string()) + "\n" == contents(fs::path(scene).replace_extension(".txt")));
}

TEST_CASE("A scene file that cannot be read") {
    const InSourceFolder here;
    CHECK(faultOf("test/bad/nowhere.json") ==
          "test/bad/nowhere.json: cannot read: No such file or directory; looked in " +
              fs::current_path().string() + "/test/bad");
    CHECK(faultOf("test/bad") == "test/bad: cannot read: Is a directory; name a file in it");
    CHECK(faultOf("test/bad/files/check.png") ==
          "test/bad/files/check.png:1:1: expected JSON, found what is no text");
}

TEST_CASE("What is left out of materials and lights is as in defaults.json") {
    const InSourceFolder here;
    const SceneDescription scene = loadScene("test/good/defaults.json").description;
    const MaterialDescription& material = scene.materials[0];
    CHECK(material.name == "default");
    CHECK(material.color_ambient == glm::dvec3(0));
    CHECK(material.color_diffuse == glm::dvec3(1));
    CHECK(material.color_specular == glm::dvec3(1));
    CHECK(material.shininess == 10);
    CHECK_FALSE(material.reflective);
    CHECK(material.color_reflect == glm::dvec3(1));
    CHECK_FALSE(material.refractive);
    CHECK(material.color_refract == glm::dvec3(1));
    CHECK(material.index_of_refraction == 1);
    CHECK_FALSE(material.use_diffuse_texture);
    const LightDescription& light = scene.lights[0];
    CHECK(light.position == glm::dvec3(0));
    CHECK(light.color == glm::dvec3(1));
    CHECK(light.color_ambient == glm::dvec3(1));
    CHECK(scene.lights[1].position == glm::dvec3(1, 2, 3));
}

TEST_CASE("Every key arrives where it belongs") {
    const InSourceFolder here;
    const SceneDescription scene = loadScene("test/good/every_key.json").description;
    SECTION("camera") {
        CHECK(scene.camera.type == CameraDescription::Type::Perspective);
        CHECK(scene.camera.focal_length == 1);
        CHECK(scene.camera.eye == glm::dvec3(0, 0, 5));
        CHECK(scene.camera.look == glm::dvec3(0, 0, -1));
        CHECK(scene.camera.up == glm::dvec3(0, 1, 0));
        CHECK(scene.camera.film_left == -1);
        CHECK(scene.camera.film_right == 0.75);
        CHECK(scene.camera.film_bottom == -0.5);
        CHECK(scene.camera.film_top == 1.5);
    }
    SECTION("material") {
        const MaterialDescription& material = scene.materials.at(0);
        CHECK(material.name == "glass");
        CHECK(material.color_ambient == glm::dvec3(0, 0.1, 0));
        CHECK(material.color_diffuse == glm::dvec3(0.2, 0.3, 0.4));
        CHECK(material.color_specular == glm::dvec3(1, 1, 0.9));
        CHECK(material.shininess == 20);
        CHECK(material.reflective);
        CHECK(material.color_reflect == glm::dvec3(0.1, 0.1, 0.2));
        CHECK(material.refractive);
        CHECK(material.color_refract == glm::dvec3(0.8, 0.9, 0.8));
        CHECK(material.index_of_refraction == 1.5);
        CHECK(material.use_diffuse_texture);
        CHECK(material.diffuse_texture == "check");
    }
    SECTION("light") {
        CHECK(scene.lights.at(0).position == glm::dvec3(0, 5, 5));
        CHECK(scene.lights.at(0).color == glm::dvec3(1, 0.5, 1));
        CHECK(scene.lights.at(0).color_ambient == glm::dvec3(0.5, 1, 0.5));
    }
    SECTION("transform") {
        const TransformDescription& transform = scene.transforms.at(0);
        CHECK(transform.name == "everything");
        CHECK(transform.translate == glm::dvec3(0, 0, -1));
        CHECK(transform.rotate->degrees == 30);
        CHECK(transform.rotate->axis == glm::dvec3(1, 2, 3));
        CHECK(transform.scale == glm::dvec3(1, 2, 3));
        CHECK(transform.matrix == glm::dmat4({1, 0, 0, 0}, {0.5, 1, 0, 0}, {0, 0, 1, 0}, {3, 2, 1, 1}));
    }
    SECTION("shape, mesh and texture") {
        CHECK(scene.shapes.at(0).type == ShapeType::Mesh);
        CHECK(scene.shapes[0].mesh->triangleCount() == 1);
        CHECK(scene.textures.at(0).name == "check");
        CHECK(scene.textures[0].texture->width == 4);
        CHECK(scene.textures[0].texture->texels.at(0) == 255);
    }
}

TEST_CASE("A material knows the place of its texture") {
    const InSourceFolder here;
    const SceneDescription scene = loadScene("scenes/lantern_lake.json").description;
    REQUIRE(scene.textures.size() > 1);
    for (const MaterialDescription& material : scene.materials)
        if (material.use_diffuse_texture)
            CHECK(scene.textures.at(material.texture).name == material.diffuse_texture);
}

TEST_CASE("A texture that no shape uses is not read") {
    const InSourceFolder here;
    const SceneDescription scene = loadScene("test/good/defaults.json").description;
    REQUIRE(scene.textures.size() == 1);
    CHECK(scene.textures[0].texture == nullptr);
}

TEST_CASE("Shapes that name the same file share its mesh") {
    const std::string file = fs::absolute(SOURCE_DIR "/test/bad/files/triangle.obj").string();
    const std::string mesh =
        R"({"type": "mesh", "transform": "i", "material": "default", "path": ")" + file + "\"}";
    const SceneText text(sceneOf(mesh + "," + mesh));
    const SceneDescription scene = loadScene(text.path()).description;
    CHECK(scene.shapes.at(0).mesh == scene.shapes.at(1).mesh);
}

TEST_CASE("A byte order mark, CRLF and names in UTF-8 are welcome") {
    const InSourceFolder here;
    CHECK(loadScene("test/good/byte_order_mark.json").description.materials.at(1).name == "schlicht, größer");
}

TEST_CASE("Unknown keys are warnings") {
    const InSourceFolder here;
    const std::string file = "test/lenient/comments.json";
    CHECK(loadScene(file).warnings ==
          std::vector<std::string>{
              file + ":2:5: unknown key \"comment\": delete it",
              file + ":5:77: /camera: unknown key \"film_center\": delete it",
              file + ":7:21: /materials/0: unknown key \"colour_diffuse\"; did you mean \"color_diffuse\"?",
              file + ":8:18: /lights/0: unknown key \"colour\"; did you mean \"color\"?",
              file + ":9:80: /transforms/0/rotate: unknown key \"unit\": delete it",
              file + ":10:75: /shapes/0: unknown key \"path\": only a mesh has one; delete it",
          });
}

TEST_CASE("Of very many warnings some are shown and the rest counted") {
    std::string shapes = R"({"type": "cone", "transform": "i", "material": "default", "id": 0})";
    const std::string another = ',' + shapes;
    for (int i = 1; i < 100; ++i) shapes += another;
    const SceneText text(sceneOf(shapes));
    const std::vector<std::string> warnings = loadScene(text.path()).warnings;
    REQUIRE(warnings.size() == 21);
    CHECK(warnings[19] == text.path() + ":2:1480: /shapes/19: unknown key \"id\": delete it");
    CHECK(warnings[20] == text.path() + ": 80 more unknown keys");
}

TEST_CASE("A key that is missing is found under its misspelled name") {
    const InSourceFolder here;
    const std::string file = "test/bad/schema/misspelled_focal_length.json";
    CHECK(faultOf(file) ==
          file + ":4:32: /camera: expected the key \"focal_length\", found \"focal_lenght\"");
}

TEST_CASE("A message stays one short line, whatever is in the file") {
    SECTION("a long name with line ends") {
        const std::string begin = R"("\u001b[2J\n)";
        const SceneText text(sceneOf(R"({"type": "cone", "transform": "i", "material": )" + begin +
                                     std::string(100'000, 'x') + "\"}"));
        CHECK(faultOf(text.path()) == text.path() + ":2:196: /shapes/0/material: no material named " + begin +
                                          std::string(55, 'x') + "\"...; /materials/0 has no name");
    }
    SECTION("a long string that does not end") {
        const SceneText text("{\"" + std::string(100'000, 'x'));
        CHECK(faultOf(text.path()) == text.path() + ":1:2: a text has no end: \" is missing");
    }
    SECTION("no recursion: a million brackets") {
        const SceneText text(std::string(1'000'000, '['));
        CHECK(faultOf(text.path()) ==
              text.path() + ":1:257: expected at most 256 lists and objects inside of each other");
    }
}
