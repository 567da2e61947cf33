// A picture depends neither on the unit of length nor on where the origin lies; and no number that a scene may hold makes
// it anything but a picture.
#include <catch2/catch.hpp>

#include "described.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

constexpr const char* precisionName[] = {"float", "double", "extended"};

void checkPowersOfTwo(Precision precision, const std::vector<int>& exponents, int longEdge) {
    for (const std::string& file : sceneFiles()) {
        const SceneDescription scene = loadScene(file, true).description;
        const ByteImage plain = bytesOf(scene, longEdge, precision);
        for (const int exponent : exponents) {
            INFO(file << " times 2^" << exponent << " in " << precisionName[static_cast<int>(precision)]);
            CHECK(bytesOf(scaled(scene, std::ldexp(1.0, exponent)), longEdge, precision).pixels == plain.pixels);
        }
    }
}

// How far the scene reaches from the camera: what translations are measured in.
double sizeOf(const SceneDescription& scene) {
    double largest = 1e-3;
    for (const LightDescription& light : scene.lights)
        largest = std::max(largest, glm::distance(light.position, scene.camera.eye));
    return largest;
}

// Of 10,000 pixels, those in which double and extended differ by more than 1 of 255, on the very same numbers.
struct Tally {
    int wrong = 0, pixels = 0;

    void add(const SceneDescription& scene) {
        const ByteImage judge = bytesOf(scene, 60, Precision::Extended), image = bytesOf(scene, 60);
        wrong += differingPixels(image, judge, 1);
        pixels += image.width * image.height;
    }
    void check() const {
        INFO(wrong << " of " << pixels << " pixels");
        CHECK(wrong * 10000 <= pixels);
    }
};

}  // namespace

TEST_CASE("a scene times a power of two is the same picture to the byte") {
    checkPowersOfTwo(Precision::Double, {-300, -211, -100, -53, -17, -1, 1, 2, 23, 64, 130, 257, 300}, 40);
}

TEST_CASE("a scene times a power of two is the same picture in float") {
    std::vector<int> exponents;
    for (int exponent = -30; exponent <= 30; ++exponent) exponents.push_back(exponent);
    checkPowersOfTwo(Precision::Float, exponents, 16);
}

TEST_CASE("a scene times a power of ten is what extended precision makes of it") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file, true).description;
        Tally tally;
        for (int exponent = -12; exponent <= 12; ++exponent) tally.add(scaled(scene, std::pow(10, exponent)));
        tally.check();
    }
}

TEST_CASE("a scene moved far away is what extended precision makes of it") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file, true).description;
        Tally tally;
        for (int exponent = 0; exponent <= 8; ++exponent)
            tally.add(translated(scene, sizeOf(scene) * std::pow(10, exponent) * glm::dvec3(0.8, -0.31, 0.53)));
        tally.check();
    }
}
