// A pixel is a pure function of (scene, options, x, y): src/README.md, invariant 1.
#include <algorithm>

#include <catch2/catch.hpp>

#include "../support/described.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

constexpr int smallEdge = 75;  // pixels: not a multiple of the tile's edge

// Puts a crop's pixels into the whole picture.
void paste(ByteImage& whole, const ByteImage& part, const PixelRectangle& crop) {
    for (int y = 0; y < part.height; ++y) {
        const auto from = part.pixels.begin() + 3 * y * part.width;
        std::copy(from, from + 3 * part.width,
                  whole.pixels.begin() + 3 * ((crop.y0 + y) * whole.width + crop.x0));
    }
}

// Four uneven quarters.
std::vector<PixelRectangle> quarters(const ImageSize& size) {
    const int x = size.width / 3, y = (size.height + 1) / 2;
    return {{0, 0, x, y}, {x, 0, size.width, y}, {0, y, x, size.height}, {x, y, size.width, size.height}};
}

}  // namespace

TEST_CASE("pictures are the same bytes with any number of threads") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        const auto renderer = makeRenderer(scene, Precision::Double);
        RenderOptions options = wholePicture(scene, smallEdge);
        options.threads = 1;
        const ByteImage one = renderBytes(*renderer, options);
        for (const int threads : {2, 7}) {
            options.threads = threads;
            CHECK(renderBytes(*renderer, options).pixels == one.pixels);
        }
    }
}

TEST_CASE("crops put together are the whole picture") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        const auto renderer = makeRenderer(scene, Precision::Double);
        RenderOptions options = wholePicture(scene, smallEdge);
        const ByteImage whole = renderBytes(*renderer, options);
        ByteImage together = whole;
        std::fill(together.pixels.begin(), together.pixels.end(), std::uint8_t{1});
        for (const PixelRectangle& crop : quarters(options.size)) {
            options.crop = crop;
            paste(together, renderBytes(*renderer, options), crop);
        }
        CHECK(together.pixels == whole.pixels);
    }
}

TEST_CASE("the terms of the light model add up") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const auto floatsWith = [&](const Terms& terms) {
            SceneDescription scene = loadScene(file).description;
            keepTerms(scene, terms);
            RenderOptions options = wholePicture(scene, smallEdge);
            options.shadows = terms.shadows;
            options.refraction = terms.refraction;
            return renderFloats(*makeRenderer(scene, Precision::Double), options);
        };
        const Terms none{false, false, false, false, false, false, true};
        Terms ambient = none, diffuse = none, specular = none, all = none;
        ambient.ambient = diffuse.diffuse = specular.specular = true;
        all.ambient = all.diffuse = all.specular = true;
        const FloatImage a = floatsWith(ambient), d = floatsWith(diffuse), s = floatsWith(specular),
                         sum = floatsWith(all);
        bool equal = true;
        for (std::size_t i = 0; i < sum.pixels.size(); ++i)
            equal = equal && std::abs(a.pixels[i] + d.pixels[i] + s.pixels[i] - sum.pixels[i]) <=
                                 1e-5f * (1 + sum.pixels[i]);
        CHECK(equal);
    }
}

// Nothing bounds what a render may cast; pilot samples end where rays double and double.
TEST_CASE("pilot samples have a bound on the rays that they cast") {
    SceneMaker maker;
    MaterialDescription& glass = maker.glass(glm::dvec3(1), 1);
    glass.reflective = true;
    for (int z = -30; z < 40; ++z) maker.shape(ShapeType::Plane, {"", glm::dvec3(0, 0, z + 0.5), {}, {}, {}});
    maker.light({0, 0, 10});
    const auto renderer = makeRenderer(maker.scene, Precision::Double);
    RenderOptions options = wholePicture(maker.scene, 4);
    const std::vector<glm::dvec2> points(100, glm::dvec2(1));
    std::vector<glm::dvec3> colors(points.size());
    RayTrees trees;
    for (const int threads : {1, 3}) {
        options.threads = threads;
        options.max_recursion = 9;
        CHECK(renderer->renderPoints(options, points, colors).onwards() <= mostRaysOfSample * points.size());
        options.max_recursion = 1000;
        try {
            renderer->renderPoints(options, points, colors);
            CHECK(false);
        } catch (const TooManyRays& tooMany) {
            const std::uint64_t cast = tooMany.cast().onwards();
            CHECK(cast > mostRaysOfSample * points.size());
            CHECK(cast <= static_cast<unsigned>(threads) * (mostRaysOfSample * points.size() + 1000));
        }
        CHECK_THROWS_WITH(renderer->rayTrees(options, points, trees),
                          "more than 1024 reflected and refracted rays a sample: a lower --max-recursion or "
                          "a --cutoff bounds them");
    }
}

TEST_CASE("the long edge goes to the longer film side") {
    CameraDescription camera;
    camera.film_left = -2, camera.film_right = 2, camera.film_bottom = -1, camera.film_top = 1;
    CHECK(imageSize(camera, 600).width == 600);
    CHECK(imageSize(camera, 600).height == 300);
    camera.film_left = -0.001, camera.film_right = 0.001;
    CHECK(imageSize(camera, 600).width == 1);  // lround(0.6)
    CHECK(imageSize(camera, 600).height == 600);
    CHECK(imageSize(camera, 100).width == 1);  // at least 1
    for (const auto& [halfWidth, halfHeight] : {std::pair{0.4, 0.3}, {4.0, 3.0}, {0.04, 0.03}}) {
        camera.film_left = -halfWidth, camera.film_right = halfWidth;
        camera.film_bottom = -halfHeight, camera.film_top = halfHeight;
        CHECK(imageSize(camera, 750).height == 563);  // lround(562.5)
    }
    camera.film_left = camera.film_bottom, camera.film_right = camera.film_top;
    CHECK(imageSize(camera, 7).width == 7);
    CHECK(imageSize(camera, 7).height == 7);
}

namespace {

std::shared_ptr<const Texture> diagonals(int shift) {
    constexpr std::uint8_t greys[] = {0, 250, 90, 170};
    auto texture = std::make_shared<Texture>();
    texture->width = texture->height = 4;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            for (int channel = 0; channel < 3; ++channel)
                texture->texels.push_back(greys[(column + row + 4 - shift) % 4]);
    return texture;
}

// The shape seen from the side, so that no cap is; the light shines from there.
SceneDescription striped(ShapeType type, const TransformDescription& transform, int shift) {
    SceneMaker make;
    if (type != ShapeType::Plane) {
        make.scene.camera.eye = {10, 0, 0};
        make.scene.camera.look = {-1, 0, 0};
        make.scene.camera.up = {0, 0, 1};
    }
    MaterialDescription& material = make.material(glm::dvec3(0));
    material.color_diffuse = glm::dvec3(1);
    material.use_diffuse_texture = true;
    make.scene.textures.push_back({"diagonals", diagonals(shift)});
    make.shape(type, transform);
    make.light(10.0 * make.scene.camera.eye);
    return make.scene;
}

ByteImage bilinear(ShapeType type, const TransformDescription& transform, int shift) {
    return bytesOf(striped(type, transform, shift), 60, Precision::Double,
                   [](RenderOptions& options) { options.bilinear = true; });
}

}  // namespace

TEST_CASE("bilinear look-ups go round: a seam is like any place between two columns") {
    for (const ShapeType type : {ShapeType::Sphere, ShapeType::Cylinder, ShapeType::Cone})
        for (const int quarters : {1, 2, 3}) {
            INFO(static_cast<int>(type) << ", " << quarters << " quarters");
            TransformDescription turned;
            turned.rotate = {{90.0 * quarters, {0, 0, 1}}};
            CHECK(differingPixels(bilinear(type, turned, 0), bilinear(type, {}, quarters), 1) == 0);
        }
    TransformDescription right, up;
    right.translate = {0.5, 0, 0};  // a quarter of the period
    up.translate = {0, 0.5, 0};
    const ByteImage still = bilinear(ShapeType::Plane, {}, 0);
    CHECK(differingPixels(bilinear(ShapeType::Plane, right, 3), still, 1) == 0);
    CHECK(differingPixels(bilinear(ShapeType::Plane, up, 1), still, 1) == 0);
}
