// Mistakes are named, and right pictures never. What programs changed by hand are called is measured by
// bench/mistakes.py.
#include <catch2/catch.hpp>

#include "../support/described.h"
#include "raytracer/grading/diagnosis.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

constexpr int edge = 80;

SceneDescription courseScene(const std::string& name) {
    return loadScene(SOURCE_DIR "/scenes/" + name + ".json", false).description;
}

std::string nameOf(const SceneDescription& scene, const ByteImage& picture) {
    return MistakeNamer(scene, wholePicture(scene, edge)).diagnose(picture).names();
}

using Mapping = PixelPlace (*)(int x, int y);

// The picture whose pixel (x, y) is that of `from` at mapping(x, y).
ByteImage moved(const ByteImage& from, Mapping mapping) {
    ByteImage result = from;
    for (int y = 0; y < from.height; ++y)
        for (int x = 0; x < from.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const PixelPlace at = mapping(x, y);
                result.pixels[static_cast<std::size_t>(3 * (y * from.width + x) + c)] =
                    from.pixels[static_cast<std::size_t>(3 * (at.y * from.width + at.x) + c)];
            }
    return result;
}

ByteImage changed(ByteImage picture, double (*change)(double)) {
    for (std::uint8_t& byte : picture.pixels) byte = toByte(change(byte / 255.0));
    return picture;
}

}  // namespace

TEST_CASE("mistakes: pictures that are turned and mirrored") {
    constexpr int last = edge - 1;
    const std::pair<Mapping, const char*> cases[] = {
        {[](int x, int y) {
             return PixelPlace{last - x, y};
         },
         "flipped left and right"},
        {[](int x, int y) {
             return PixelPlace{x, last - y};
         },
         "flipped up and down"},
        {[](int x, int y) {
             return PixelPlace{last - x, last - y};
         },
         "turned by 180 degrees"},
        {[](int x, int y) {
             return PixelPlace{y, last - x};
         },
         "turned clockwise by 90 degrees"},
        {[](int x, int y) {
             return PixelPlace{last - y, x};
         },
         "turned counter-clockwise by 90 degrees"},
        {[](int x, int y) {
             return PixelPlace{y, x};
         },
         "with rows and columns exchanged"},
    };
    for (const char* file : {"spheres_cylinder", "orthographic_test1"}) {
        const SceneDescription scene = courseScene(file);
        const ByteImage right = bytesOf(scene, edge);
        if (right.width != right.height) continue;
        for (const auto& [mapping, name] : cases) {
            INFO(file << " " << name);
            CHECK(nameOf(scene, moved(right, mapping)) == name);
        }
    }
}

TEST_CASE("mistakes: two at once, and how much they explain") {
    SceneDescription scene = courseScene("spheres_cylinder");
    const SceneDescription whole = scene;
    for (MaterialDescription& material : scene.materials) material.color_specular = glm::dvec3(0);
    const ByteImage picture = moved(bytesOf(scene, edge), [](int x, int y) {
        return PixelPlace{edge - 1 - x, y};
    });
    const Diagnosis diagnosis = MistakeNamer(whole, wholePicture(whole, edge)).diagnose(picture);
    CHECK(diagnosis.sentence() ==
          "equals the picture flipped left and right and without specular light (0 of 6400 pixels differ; " +
              std::to_string(differingPixels(picture, bytesOf(whole, edge), 0)) +
              " differ from the right one)");
}

TEST_CASE("mistakes: right pictures have none, with any rounding") {
    for (const char* file : {"spheres_cylinder", "refraction", "texture", "mirror_corridor"}) {
        const SceneDescription scene = courseScene(file);
        for (const Precision precision : {Precision::Float, Precision::Extended}) {
            INFO(file);
            CHECK(nameOf(scene, bytesOf(scene, edge, precision)).empty());
        }
    }
}

TEST_CASE("mistakes: what none explains has no name") {
    const SceneDescription scene = courseScene("spheres_cylinder");
    const ByteImage right = bytesOf(scene, edge);
    CHECK(nameOf(scene, changed(right, [](double c) { return c * c * (3 - 2 * c); })).empty());
    CHECK(nameOf(scene, changed(right, [](double) { return 0.0; })).empty());
    CHECK(nameOf(scene, moved(right, [](int x, int y) { return PixelPlace{(x + 7) % edge, y}; })).empty());
    CHECK(nameOf(scene, bytesOf(courseScene("texture"), edge)).empty());
}
