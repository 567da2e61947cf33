// Mistakes are named, and right pictures never. What programs changed by hand are called is measured by
// bench/mistakes.py.
#include <random>

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "../support/described.h"
#include "../tracer/plain_tracer.h"
#include "raytracer/grading/diagnosis.h"
#include "raytracer/grading/grade.h"
#include "raytracer/pictures/color_sink.h"
#include "raytracer/tracer/term_names.h"
#include "raytracer/util/text.h"

using namespace raytracer;
using Catch::Matchers::Contains;
using namespace raytracer::test;

namespace {

constexpr int edge = 80;

SceneDescription courseScene(const std::string& name) {
    return loadScene(SOURCE_DIR "/scenes/" + name + ".json").description;
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

// The terms of the list alone.
ByteImage termsPicture(SceneDescription scene, const std::string& list) {
    const Terms terms = termsNamed(list);
    keepTerms(scene, terms);
    return bytesOf(scene, edge, Precision::Double, [&](RenderOptions& options) {
        options.shadows = terms.shadows;
        options.refraction = terms.refraction;
    });
}

ByteImage stagePicture(const SceneDescription& scene, const Stage& stage) {
    if (stage.pass == "color") return termsPicture(scene, std::string(stage.only));
    return bytesOf(scene, edge, Precision::Double,
                   [&](RenderOptions& options) { options.pass = passNamed(stage.pass); });
}

ByteImage normalsPicture(const SceneDescription& scene, glm::dvec3 (*change)(const glm::dvec3&)) {
    RenderOptions options = wholePicture(scene, edge);
    options.pass = Pass::Normals;
    ColorSink sink(options.crop);
    makeRenderer(scene, Precision::Double)->render(options, sink);
    ByteImage picture{options.size, {}};
    for (const glm::dvec3& color : sink.colors())
        for (int c = 0; c < 3; ++c) picture.pixels.push_back(toByte(change(color)[c]));
    return picture;
}

// The right picture with every other pixel, at random, as `speck` makes it of its ray tree.
ByteImage withSpecks(const SceneDescription& scene,
                     const std::function<glm::dvec3(const RayExplanation&)>& speck) {
    ByteImage picture = bytesOf(scene, edge);
    const RenderOptions options = wholePicture(scene, edge);
    const auto renderer = makeRenderer(scene, Precision::Double);
    std::mt19937 bits(1);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            if (bits() % 2 == 0) continue;
            const glm::dvec3 color = speck(renderer->explain(options, x, y));
            for (int c = 0; c < 3; ++c)
                picture.pixels[static_cast<std::size_t>(3 * (y * picture.width + x) + c)] = toByte(color[c]);
        }
    return picture;
}

glm::dvec3 inShadow(const RayExplanation& ray) {
    glm::dvec3 color = ray.color;
    for (const LightExplanation& light : ray.lights) color -= (light.diffuse + light.specular) * light.S_L;
    return color;
}

// The reflected ray meets the mirror from inside, where it has ambient light alone.
glm::dvec3 seesItself(const RayExplanation& ray) {
    glm::dvec3 color = ray.color;
    for (const RayExplanation& next : ray.rays) {
        color -= next.weight * next.color;
        for (const LightExplanation& light : ray.lights) color += next.weight * light.ambient;
    }
    return color;
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
        SceneDescription scene = courseScene(file);
        scene.camera.up *= 1.25;  // as in camera_test2
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

TEST_CASE("mistakes: a picture that is mirrored, of rays through corners") {
    const SceneDescription whole = courseScene("texture");
    SceneDescription scene = whole;
    const ImageSize size = wholePicture(scene, edge).size;
    const double half = (scene.camera.film_right - scene.camera.film_left) / size.width / 2;
    scene.camera.film_left -= half;
    scene.camera.film_right -= half;
    scene.camera.film_bottom += half;
    scene.camera.film_top += half;
    const ByteImage picture = moved(bytesOf(scene, edge), [](int x, int y) {
        return PixelPlace{edge - 1 - x, y};
    });
    CHECK(nameOf(whole, picture) ==
          "flipped left and right and whose rays go through the pixels' top right corners");
}

TEST_CASE("mistakes: two at once, each of which the picture may tell from few others") {
    SceneDescription scene = courseScene("spheres_cylinder");
    for (TransformDescription& transform : scene.transforms) transform.rotate = {};
    const SceneDescription whole = scene;
    for (TransformDescription& transform : scene.transforms) {
        glm::dmat4 matrix(1);
        if (transform.scale) matrix = glm::scale(matrix, *transform.scale);
        if (transform.translate) matrix = glm::translate(matrix, *transform.translate);
        transform.matrix = matrix;
        transform.scale.reset();
        transform.translate.reset();
    }
    const ByteImage picture =
        bytesOf(scene, edge, Precision::Double, [](RenderOptions& options) { options.max_recursion = 0; });
    CHECK(
        nameOf(whole, picture) ==
        "whose transforms are rotate * scale * translate, whose transforms are scale * rotate * translate or "
        "whose transforms are scale * translate * rotate, and without any reflected or refracted ray "
        "(max_recursion 0) or without reflections");
}

TEST_CASE("mistakes: more than three that make one picture, but of two kinds") {
    SceneDescription scene;  // a floor that a wrong order leaves at the origin's height, above the camera
    scene.camera.eye = {0, -0.5, 4};
    scene.camera.look = {0, 0, -1};
    scene.lights = {{{1, 3, 2}, {0.8, 0.7, 0.6}, {0.4, 0.3, 0.2}}};
    scene.materials.resize(1);
    scene.materials[0].color_ambient = glm::dvec3(0.5);
    TransformDescription floor;
    floor.translate = glm::dvec3(0, -2, 0);
    floor.rotate = TransformDescription::Rotation{-90, {1, 0, 0}};
    floor.scale = glm::dvec3(0.5, 0.25, 0.5);
    scene.transforms = {floor};
    scene.shapes = {{ShapeType::Plane, 0, 0, nullptr}};
    const SceneDescription whole = scene;
    scene.transforms[0].translate.reset();
    CHECK(nameOf(whole, bytesOf(scene, edge)) ==
          "whose transforms are rotate * scale * translate, rotate * translate * scale, scale * rotate * "
          "translate or scale * translate * rotate, or without translations");
}

TEST_CASE("mistakes: where rays are too many to follow, none is named") {
    SceneDescription scene;
    scene.camera.eye = {0, 0, 4};
    scene.camera.look = {0, 0, -1};
    scene.lights = {{{1, 3, 4}, {0.8, 0.7, 0.6}, {0.4, 0.3, 0.2}}};
    scene.materials.resize(1);
    scene.materials[0].reflective = scene.materials[0].refractive = true;
    scene.materials[0].index_of_refraction = 1.2;
    scene.transforms.resize(6);
    for (std::size_t i = 0; i < scene.transforms.size(); ++i) {
        scene.transforms[i].scale = glm::dvec3(2.5 - 0.2 * static_cast<double>(i));
        scene.shapes.push_back({ShapeType::Sphere, i, 0, nullptr});
    }
    RenderOptions options = wholePicture(scene, 10);
    options.max_recursion = 12;
    const ByteImage other =
        bytesOf(scene, 10, Precision::Double, [](RenderOptions& to) { to.max_recursion = 1; });
    CHECK(MistakeNamer(scene, options).diagnose(other).names() == "with max_recursion 1 instead of 12");
}

TEST_CASE("mistakes: one whose scene cannot be made explains no picture") {
    SceneDescription scene = courseScene("spheres_cylinder");
    scene.shapes.push_back(scene.shapes[0]);
    scene.shapes.back().transform = scene.transforms.size();
    for (const glm::dvec3& scale : {glm::dvec3(1, 1, 1.7e308), glm::dvec3(-6e100, 0.065, -1.79e308)}) {
        TransformDescription transform;  // in another order, its parts have an infinite product
        transform.translate = glm::dvec3(50, 1, 1);
        transform.rotate = TransformDescription::Rotation{40, {1, 1, 1}};
        transform.scale = scale;
        SceneDescription wide = scene;
        wide.transforms.push_back(transform);
        const ByteImage negative = changed(bytesOf(wide, edge), [](double c) { return 1 - c; });
        CHECK(nameOf(wide, negative).empty());
        CHECK(nameOf(wide, termsPicture(wide, "ambient,diffuse,shadows,reflections")) ==
              "without specular light");
    }
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

TEST_CASE("mistakes: why a wrong picture has no name") {
    const SceneDescription scene = courseScene("spheres_cylinder");
    const ByteImage right = bytesOf(scene, edge), ambient = termsPicture(scene, "ambient");
    const MistakeNamer namer(scene, wholePicture(scene, edge));
    CHECK(namer.diagnose(right).unnamed.empty());
    CHECK(namer.diagnose(ambient).unnamed.empty());
    CHECK(namer.diagnose(changed(right, [](double) { return 0.0; })).unnamed ==
          "one colour tells no mistake");
    CHECK(namer.diagnose(changed(right, [](double c) { return c * c * (3 - 2 * c); })).unnamed ==
          "no known mistake");
    ByteImage few = right;
    for (std::size_t i = 0, wrong = 0; wrong < 23; i += 3)
        if (largestDifference(&ambient.pixels[i], &right.pixels[i]) > 1 && ++wrong)
            std::copy_n(&ambient.pixels[i], 3, &few.pixels[i]);
    CHECK(namer.diagnose(few).unnamed == "too few wrong pixels to tell the mistake");
}

TEST_CASE("mistakes: another stage, or other terms, is named as what it is") {
    for (const char* file : {"refraction", "stress_test"}) {
        const SceneDescription scene = courseScene(file);
        for (const Stage& stage : stages()) {
            if (&stage == &completeStage()) continue;
            INFO(file << " " << stage.name);
            const std::string name = nameOf(scene, stagePicture(scene, stage));
            const std::string place = "the stage -" + std::string(stage.name);
            const bool isLight = !stage.only.empty() && stage.only.find(',') == stage.only.npos;
            CHECK(name ==
                  "that shows " +
                      (isLight ? std::string(stage.only) + " light alone, as " + place + " does" : place));
        }
    }
}

TEST_CASE("mistakes: of a stage") {
    const SceneDescription scene = courseScene("spheres_cylinder");
    const auto named = [&](std::size_t stage, const ByteImage& picture) {
        RenderOptions options = wholePicture(scene, edge);
        options.pass = passNamed(stages()[stage].pass);
        options.shadows = options.refraction = false;
        Terms terms = noTerms;
        terms.diffuse = true;
        return MistakeNamer(scene, options, options.pass == Pass::Color ? terms : Terms{})
            .diagnose(picture)
            .names();
    };
    constexpr std::size_t normals = 1, diffuse = 3;
    const ByteImage rightNormals = stagePicture(scene, stages()[normals]);
    CHECK(named(normals, stagePicture(scene, stages()[diffuse])) ==
          "that shows diffuse light alone, as the stage -diffuse does");
    CHECK(named(diffuse, rightNormals) == "that shows the stage -normals");
    CHECK(named(diffuse, termsPicture(scene, "diffuse,shadows")) == "with shadows");
    CHECK(named(normals, normalsPicture(scene, [](const glm::dvec3& c) { return 2.0 * c - 1.0; })) ==
          "whose normals are the colours themselves");
    const auto turned = [](const glm::dvec3& c) { return c == glm::dvec3(54 / 255.0) ? c : 1.0 - c; };
    CHECK(named(normals, normalsPicture(scene, turned)) == "whose normals point inwards");
}

TEST_CASE("mistakes: settings of a picture that is right otherwise") {
    const SceneDescription scene = courseScene("mirror_corridor"), textured = courseScene("texture");
    const auto named = [](const SceneDescription& one, const std::function<void(RenderOptions&)>& change) {
        return nameOf(one, bytesOf(one, edge, Precision::Double, change));
    };
    for (const auto& [bounces, said] : {std::pair{1, "1"}, {5, "5"}, {6, "6"}, {8, "8 or more"}})
        CHECK_THAT(named(scene, [depth = bounces](RenderOptions& options) { options.max_recursion = depth; }),
                   Contains(formatted("with max_recursion %s instead of 3", said)));
    constexpr int large = 2 * edge;  // so that two bounces change enough pixels
    RenderOptions ten = wholePicture(scene, large);
    ten.max_recursion = 10;
    const auto eight = [](RenderOptions& options) { options.max_recursion = 8; };
    CHECK(MistakeNamer(scene, ten).diagnose(bytesOf(scene, large, Precision::Double, eight)).names() ==
          "with max_recursion 8 instead of 10");
    CHECK(named(textured, [](RenderOptions& options) { options.bilinear = true; }) ==
          "with bilinear texture look-ups");
    for (const int samples : {4, 16})
        CHECK(named(textured, [=](RenderOptions& options) { options.samples = samples; }) ==
              "with " + std::to_string(samples) + " samples a pixel");
}

TEST_CASE("mistakes: specks that shadows or mirrors make are acne, others have no name") {
    const SceneDescription scene = courseScene("cone_cube");
    CHECK(nameOf(scene, withSpecks(scene, inShadow)) == "with specks on lit surfaces (shadow acne)");
    CHECK(nameOf(scene, withSpecks(scene, seesItself)) == "with specks on mirrors (reflection acne)");
    const auto both = [](const RayExplanation& ray) { return inShadow(ray) + seesItself(ray) - ray.color; };
    CHECK(nameOf(scene, withSpecks(scene, both)) ==
          "with specks on lit surfaces and on mirrors (shadow and reflection acne)");
    const auto brighter = [](const RayExplanation& ray) {
        return ray.rays.empty() ? ray.color : ray.color + ray.rays[0].weight * ray.rays[0].color;
    };
    CHECK(nameOf(scene, withSpecks(scene, brighter)).empty());
    CHECK(
        nameOf(scene, withSpecks(scene, [](const RayExplanation& ray) { return 0.5 * ray.color; })).empty());
}

// Turned the wrong way, the cone's and the cylinder's bases lie in the floor, and each program shows another
// one of the two. In the other order, walls stand where the eye is.
TEST_CASE("mistakes: what rounding decides in the wrong picture does not hide the mistake") {
    const auto plainly = [](const SceneDescription& scene) { return plain::Tracer(scene).render(edge); };
    for (const char* name : {"cone_cube", "camera_test1"}) {
        CAPTURE(name);
        const SceneDescription scene = courseScene(name);
        SceneDescription turned = scene;
        for (TransformDescription& transform : turned.transforms)
            if (transform.rotate) transform.rotate->degrees = -transform.rotate->degrees;
        const Diagnosis diagnosis = MistakeNamer(scene, wholePicture(scene, edge)).diagnose(plainly(turned));
        CHECK(diagnosis.names() == "whose rotations go in the other sense");
        CHECK_THAT(diagnosis.sentence(), Contains("pixels that rounding decides, the picture"));
    }
    const SceneDescription scene = courseScene("refraction");
    SceneDescription reordered = scene;
    for (TransformDescription& transform : reordered.transforms) {
        glm::dmat4 matrix(1);
        if (transform.rotate)
            matrix = glm::rotate(matrix, glm::radians(transform.rotate->degrees), transform.rotate->axis);
        if (transform.translate) matrix = glm::translate(matrix, *transform.translate);
        if (transform.scale) matrix = glm::scale(matrix, *transform.scale);
        transform.translate.reset();
        transform.rotate = {};
        transform.scale.reset();
        transform.matrix = matrix;
    }
    CHECK_THAT(nameOf(scene, plainly(reordered)), Contains("transforms are rotate * translate * scale"));
}

TEST_CASE("mistakes: few pixels that are off by one are rounding") {
    const SceneDescription scene = courseScene("spheres_cylinder");
    ByteImage picture = bytesOf(scene, edge);
    const MistakeNamer namer(scene, wholePicture(scene, edge));
    CHECK_FALSE(namer.diagnose(picture).isRounding);
    for (const std::size_t i : {3000, 3001, 9000}) picture.pixels[i] ^= 1;
    CHECK(namer.diagnose(picture).isRounding);
    picture.pixels[12000] ^= 2;
    CHECK_FALSE(namer.diagnose(picture).isRounding);
}

TEST_CASE("mistakes: what is said of a picture that is another one but for some pixels, or of a sample") {
    Diagnosis diagnosis{.pixels = 3600, .wrong = 500, .mistakes = {NamedMistake()}};
    NamedMistake& mistake = diagnosis.mistakes.front();
    mistake.what = "without shadows";
    mistake.explained = 1;
    mistake.off = 6;
    CHECK(diagnosis.sentence() ==
          "is, but for 6 of 3600 pixels, the picture without shadows (500 of 3600 "
          "pixels differ from the right one)");
    mistake.rounded = 20;
    CHECK(diagnosis.sentence() ==
          "is, but for 6 of 3600 pixels and 20 of 3600 pixels that rounding decides, the picture without "
          "shadows (500 of 3600 pixels differ from the right one)");
    mistake.off.reset();
    mistake.sampled = 640;
    CHECK(diagnosis.sentence() ==
          "is, in the 640 pixels looked at, the picture without shadows (500 of 3600 "
          "pixels differ from the right one)");
    mistake.unknown = 3;
    CHECK(diagnosis.sentence() ==
          "is, in the 640 pixels looked at, none of which shows glass, the picture "
          "without shadows (500 of 3600 pixels differ from the right one)");
    mistake.explained = 0.929;
    CHECK(diagnosis.sentence() ==
          "is wrong: 92 % of its 500 wrong pixels are as in the picture without shadows");
}
