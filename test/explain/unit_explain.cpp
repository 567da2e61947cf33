// What `explain` says of a pixel is what the render did for it, to the bit, and what it is called.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>

#include "../support/scene_files.h"
#include "raytracer/explain/explanation_text.h"
#include "raytracer/pictures/color_sink.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

using Type = ShapeType;

// The formula, in rayColor's order: the light's sum, the sum over lights, then K_R I_R, then K_T I_T.
bool addsUp(const RayExplanation& ray, const SceneDescription& scene) {
    if (!ray.hit) return ray.color == glm::dvec3(0) && ray.lights.empty() && ray.rays.empty();
    const MaterialDescription& material = scene.materials[scene.shapes[ray.shape].material];
    glm::dvec3 color(0);
    bool good = ray.lights.size() == scene.lights.size();
    for (const LightExplanation& light : ray.lights) {
        good = good && light.sum == light.ambient + (light.diffuse + light.specular) * light.S_L;
        color += light.sum;
    }
    for (const RayExplanation& next : ray.rays) {
        const bool mirror = next.kind == RayKind::Reflection;
        const glm::dvec3& factor = mirror ? material.color_reflect : material.color_refract;
        good = good && next.weight == ray.weight * factor && next.max_recursion == ray.max_recursion - 1 &&
               (mirror ? material.reflective : material.refractive) && addsUp(next, scene);
        good = good && next.brought == factor * next.color;
        color += next.brought;
    }
    return good && color == ray.color;
}

// Camera at the origin, looking along -z; one light; shapes are added.
struct ExplainedScene : SceneDescription {
    ExplainedScene() {
        materials.resize(1);
        materials[0].name = "red";
        materials[0].color_ambient = {0.25, 0, 0};
        materials[0].color_diffuse = {0.5, 0, 0};
        materials[0].color_specular = glm::dvec3(0.5);
        materials[0].shininess = 2;
        lights.push_back({{0, 3, 0}, glm::dvec3(1), {1, 0.5, 0.5}});
    }

    ExplainedScene& add(const std::string& name, Type type, const glm::dvec3& translate,
                        const glm::dvec3& scale, std::size_t material = 0) {
        shapes.push_back({type, transforms.size(), material, nullptr});
        transforms.push_back({name, translate, {}, scale, {}});
        return *this;
    }

    std::size_t addMaterial(const std::string& name) {
        materials.push_back(materials[0]);
        materials.back().name = name;
        return materials.size() - 1;
    }

    std::size_t glass(double ior) {
        const std::size_t index = addMaterial("glass");
        materials[index].refractive = true;
        materials[index].color_refract = {1, 0.5, 0.25};
        materials[index].index_of_refraction = ior;
        return index;
    }

    RayExplanation explain(int x, int y, int longEdge, int max_recursion = 3) const {
        RenderOptions options = wholePicture(*this, longEdge);
        options.max_recursion = max_recursion;
        return makeRenderer(*this, Precision::Double)->explain(options, x, y);
    }
    RayExplanation explainCentre() const { return explain(0, 0, 1); }
};

const RayExplanation& onwards(const RayExplanation& ray, RayKind kind) {
    for (const RayExplanation& next : ray.rays)
        if (next.kind == kind) return next;
    throw std::runtime_error("no such ray");
}

// Everything 2^exponent times as large and as far away; a perspective camera's film is no length.
SceneDescription resized(SceneDescription scene, int exponent) {
    const double factor = std::ldexp(1.0, exponent);
    CameraDescription& camera = scene.camera;
    camera.eye *= factor;
    if (camera.type == CameraDescription::Type::Orthographic)
        for (double* edge : {&camera.film_left, &camera.film_right, &camera.film_bottom, &camera.film_top})
            *edge *= factor;
    for (LightDescription& light : scene.lights) light.position *= factor;
    for (TransformDescription& transform : scene.transforms) {
        if (transform.translate) *transform.translate *= factor;
        transform.scale = transform.scale.value_or(glm::dvec3(1)) * factor;
    }
    return scene;
}

bool equalButForUnit(const RayExplanation& a, const RayExplanation& b, double unit) {
    bool equal = a.hit == b.hit && a.color == b.color && a.weight == b.weight &&
                 a.lights.size() == b.lights.size() && a.rays.size() == b.rays.size() &&
                 a.origin * unit == b.origin && a.direction == b.direction;
    if (a.hit)
        equal = equal && a.shape == b.shape && a.primitive == b.primitive && a.t * unit == b.t &&
                a.position * unit == b.position && a.normal == b.normal && a.texCoord == b.texCoord;
    for (std::size_t i = 0; equal && i < a.lights.size(); ++i)
        equal = a.lights[i].sum == b.lights[i].sum && a.lights[i].shadowedBy == b.lights[i].shadowedBy;
    for (std::size_t i = 0; equal && i < a.rays.size(); ++i)
        equal = equalButForUnit(a.rays[i], b.rays[i], unit);
    return equal;
}

}  // namespace

TEST_CASE("an explanation's colours are the render's, and add up, to the bit") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        const auto renderer = makeRenderer(scene, Precision::Double);
        const RenderOptions options = wholePicture(scene, 40);
        ColorSink sink(options.crop);
        renderer->render(options, sink);
        auto rendered = sink.colors().begin();
        int wrong = 0;
        for (int y = 0; y < options.size.height; ++y)
            for (int x = 0; x < options.size.width; ++x) {
                const RayExplanation ray = renderer->explain(options, x, y);
                wrong += !(ray.color == *rendered++ && addsUp(ray, scene));
            }
        CHECK(wrong == 0);
    }
}

TEST_CASE("an explanation's colours are the render's in every precision") {
    const SceneDescription scene = loadScene(SOURCE_DIR "/scenes/nested_glass.json").description;
    for (const Precision precision : {Precision::Float, Precision::Extended}) {
        const auto renderer = makeRenderer(scene, precision);
        const RenderOptions options = wholePicture(scene, 40);
        ColorSink sink(options.crop);
        renderer->render(options, sink);
        auto rendered = sink.colors().begin();
        int wrong = 0;
        for (int y = 0; y < options.size.height; ++y)
            for (int x = 0; x < options.size.width; ++x)
                wrong += renderer->explain(options, x, y).color != *rendered++;
        CHECK(wrong == 0);
    }
}

TEST_CASE("an explanation is the same in any unit of length") {
    for (const std::string& file : sceneFiles()) {
        INFO(file);
        const SceneDescription scene = loadScene(file).description;
        const RenderOptions options = wholePicture(scene, 16);
        const auto renderer = makeRenderer(scene, Precision::Double);
        for (const int exponent : {-300, 7, 300}) {
            const auto other = makeRenderer(resized(scene, exponent), Precision::Double);
            int wrong = 0;
            for (int y = 0; y < options.size.height; ++y)
                for (int x = 0; x < options.size.width; ++x)
                    wrong += !equalButForUnit(renderer->explain(options, x, y), other->explain(options, x, y),
                                              std::ldexp(1.0, exponent));
            CHECK(wrong == 0);
        }
    }
}

TEST_CASE("the ray, the place and the normal are in the file's own units") {
    ExplainedScene scene;
    scene.camera.eye = {1, 2, 3};
    scene.camera.focal_length = 2;
    scene.add("ball", Type::Sphere, {1, 2, -7}, glm::dvec3(2));
    const RayExplanation ray = scene.explainCentre();
    CHECK(ray.origin == glm::dvec3(1, 2, 3));
    CHECK(ray.direction == glm::dvec3(0, 0, -2));
    REQUIRE(ray.hit);
    CHECK(ray.t == 4);
    CHECK(ray.position == glm::dvec3(1, 2, -5));
    CHECK(ray.normal == glm::dvec3(0, 0, 1));
}

TEST_CASE("a shadow, and by whom") {
    ExplainedScene scene;
    const std::size_t glass = scene.glass(1);
    scene.lights.push_back({{0, -3, 0}, glm::dvec3(1), glm::dvec3(0)});
    scene.lights.push_back({{3, 0, 0}, glm::dvec3(1), glm::dvec3(0)});
    scene.lights.push_back({{0, 0, -9}, glm::dvec3(1), glm::dvec3(0)});
    scene.add("wall", Type::Plane, {0, 0, -3}, glm::dvec3(1));
    scene.add("far from the wall", Type::Sphere, {0, 2, -1}, glm::dvec3(0.5))
        .add("near the wall", Type::Sphere, {0, 1, -2}, glm::dvec3(0.5));
    scene.add("clear", Type::Cube, {0, -1, -2}, glm::dvec3(0.5), glass)
        .add("opaque beyond", Type::Cube, {0, -2, -1}, glm::dvec3(0.25));
    const RayExplanation ray = scene.explainCentre();
    REQUIRE(ray.shape == 0);
    REQUIRE(ray.lights.size() == 4);
    CHECK(ray.lights[0].shadowRayCast);
    CHECK(ray.lights[0].shadowedBy == std::size_t{2});  // the nearest to the wall
    CHECK(ray.lights[0].S_L == glm::dvec3(0));
    CHECK(ray.lights[1].shadowedBy == std::size_t{3});  // glass, though something opaque follows
    CHECK(ray.lights[1].S_L == glm::dvec3(1, 0.5, 0.25));
    CHECK(ray.lights[2].shadowRayCast);
    CHECK_FALSE(ray.lights[2].shadowedBy);
    CHECK(ray.lights[2].S_L == glm::dvec3(1));
    CHECK_FALSE(ray.lights[3].shadowRayCast);  // behind the wall
    CHECK(ray.lights[3].N_L == 0);
    CHECK(ray.lights[3].V_R == 0);
    CHECK(ray.lights[3].sum == glm::dvec3(0));
}

TEST_CASE("total internal reflection, from inside, and the end of the recursion") {
    ExplainedScene scene;
    scene.add("block", Type::Cube, {0, 0, -3}, glm::dvec3(1), scene.glass(1.5));
    SECTION("straight through: in from outside, out from inside") {
        const RayExplanation ray = scene.explainCentre();
        CHECK(ray.entering);
        const RayExplanation& inside = onwards(ray, RayKind::Refraction);
        CHECK_FALSE(inside.entering);
        CHECK(inside.normal == glm::dvec3(0, 0, -1));
        const RayExplanation& beyond = onwards(inside, RayKind::Refraction);
        CHECK_FALSE(beyond.hit);
        CHECK(beyond.weight == glm::dvec3(1, 0.25, 0.0625));
        CHECK(beyond.max_recursion == 1);
    }
    SECTION("max_recursion") {
        CHECK(scene.explain(0, 0, 1, 0).refraction == TerminationReason::MaxRecursion);
        const RayExplanation ray = scene.explain(0, 0, 1, 1);
        CHECK(ray.refraction == TerminationReason::None);
        CHECK(onwards(ray, RayKind::Refraction).refraction == TerminationReason::MaxRecursion);
    }
    SECTION("a black factor") {
        scene.materials[1].color_refract = glm::dvec3(0);
        CHECK(scene.explainCentre().refraction == TerminationReason::Black);
    }
    SECTION("total internal reflection") {
        scene.transforms[0].translate = glm::dvec3(0);
        scene.camera.eye = {0, 0.5, 0};  // inside, looking at the face at 60 degrees
        scene.camera.look = {0, -std::sqrt(0.75), -0.5};
        scene.camera.up = {0, 0.5, -std::sqrt(0.75)};
        scene.materials[1].index_of_refraction = 4;
        const RayExplanation ray = scene.explainCentre();
        CHECK_FALSE(ray.entering);
        CHECK(ray.refraction == TerminationReason::TotalInternalReflection);
        CHECK(ray.rays.empty());
    }
}

TEST_CASE("an explanation of a direction beyond double has no number that is not finite") {
    ExplainedScene scene;
    scene.camera.film_left = 1.4e308, scene.camera.film_right = 1.7e308;
    scene.camera.look = {0, 0, -1};
    scene.camera.up = {0, 4, 0};  // twice as far along u
    scene.add("", Type::Plane, {2, 0, 0}, glm::dvec3(1), scene.glass(1));
    scene.transforms.back().rotate = {-90, {0, 1, 0}};
    const RenderOptions options = wholePicture(scene, 1);
    const RayExplanation ray = makeRenderer(scene, Precision::Double)->explain(options, 0, 0);
    const std::string text = explanationText(ray, scene);
    INFO(text);
    CHECK(text.find("inf") == std::string::npos);
    CHECK(explanationJson(ray, scene).find("null") == std::string::npos);
}

TEST_CASE("an explanation of colours beyond double has no number that is not finite") {
    for (const double huge : {1e300, -1e300}) {
        ExplainedScene scene;
        const std::size_t glass = scene.glass(1);
        scene.materials[glass].color_diffuse = scene.materials[glass].color_ambient = {1e300, 1e-300, 1};
        scene.materials[glass].color_refract = {1e300, 0, huge};
        scene.lights[0] = {{0, 0, 3}, {1e300, 1e-300, huge}, {huge, 0, 1e-300}};
        for (const double z : {-2, -4, -6, -8}) scene.add("", Type::Plane, {0, 0, z}, glm::dvec3(1), glass);
        for (const Precision precision : {Precision::Float, Precision::Double, Precision::Extended}) {
            RenderOptions options = wholePicture(scene, 1);
            const RayExplanation ray = makeRenderer(scene, precision)->explain(options, 0, 0);
            const std::string text = explanationSentence(ray, scene) + "\n" + explanationText(ray, scene);
            INFO(text);
            CHECK(text.find("nan") == std::string::npos);
            CHECK(text.find("inf") == std::string::npos);
            CHECK(explanationJson(ray, scene).find("null") == std::string::npos);
        }
    }
}

TEST_CASE("the names of faces") {
    CHECK(faceName(Type::Sphere, 0).empty());
    CHECK(faceName(Type::Plane, 0).empty());
    CHECK(faceName(Type::Cylinder, 0) == "body");
    CHECK(faceName(Type::Cylinder, 1) == "top");
    CHECK(faceName(Type::Cylinder, 2) == "bottom");
    CHECK(faceName(Type::Cone, 0) == "body");
    CHECK(faceName(Type::Cone, 1) == "bottom");
    CHECK(faceName(Type::Mesh, 17) == "triangle 17");
    const glm::dvec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const char* names[] = {"x = 1", "x = -1", "y = 1", "y = -1", "z = 1", "z = -1"};
    for (std::size_t face = 0; face < 6; ++face) {  // seen from that side
        ExplainedScene scene;
        const glm::dvec3 side = (face % 2 ? -1.0 : 1.0) * axes[face / 2];
        scene.camera.eye = 5.0 * side;
        scene.camera.look = -side;
        scene.camera.up = axes[(face / 2 + 1) % 3];
        scene.add("cube", Type::Cube, glm::dvec3(0), glm::dvec3(1));
        CHECK(faceName(Type::Cube, scene.explainCentre().primitive) == names[face]);
    }
}

TEST_CASE("the text, in whole") {
    ExplainedScene scene;
    const std::size_t mirror = scene.addMaterial("mirror"), glass = scene.glass(2);
    scene.materials[mirror].reflective = true;
    scene.materials[mirror].color_reflect = glm::dvec3(0.5);
    scene.materials[glass].color_specular = glm::dvec3(0);
    scene.lights[0].position = {0, 4, 0};
    scene.add("floor", Type::Cube, {0, -4, -2}, glm::dvec3(1), mirror)
        .add("pane", Type::Cylinder, {0, 0, -2}, glm::dvec3(1), glass);
    scene.add("lid", Type::Plane, {0, 0, 1}, glm::dvec3(1));
    scene.camera.focal_length = 0.5;
    SECTION("straight into the glass") {
        CHECK(explanationSentence(scene.explain(0, 0, 1, 1), scene) ==
              "cylinder \"pane\", lit by the light: 56 % of the red is what is seen through it, 30 % ambient "
              "light, "
              "14 % diffuse light");
        CHECK(explanationText(scene.explain(0, 0, 1, 1), scene, 0).find("refracted ray") ==
              std::string::npos);
        CHECK(explanationText(scene.explain(0, 0, 1, 1), scene) == R"(primary ray, max_recursion 1
  origin (0, 0, 0), direction (0, 0, -0.5)
  hits /shapes/1 (cylinder, transform "pane", material "glass"), top, from outside
  t = 2, position (0, 0, -1)
  N = (0, 0, 1)
  light 0: N.L = 0.242535625, V.R = 0.242535625, nothing in between
    K_A I_AL           = (0.25, 0, 0) (1, 0.5, 0.5) = (0.25, 0, 0)
    K_D I_L (N.L)      = (0.5, 0, 0) (1, 1, 1) 0.242535625 = (0.121267813, 0, 0)
    K_S I_L (V.R)^2    = (0, 0, 0) (1, 1, 1) 0.242535625^2 = (0, 0, 0)
    S_L                = (1, 1, 1)
    the light's sum    = (0.371267813, 0, 0)
  K_T I_T = (1, 0.5, 0.25) (0.473606798, 0, 0) = (0.473606798, 0, 0)
    refracted ray, max_recursion 0, weight (1, 0.5, 0.25) in the pixel
      origin (0, 0, -1), direction (0, 0, -1)
      hits /shapes/1 (cylinder, transform "pane", material "glass"), bottom, from inside
      t = 1, position (0, 0, -2)
      N = (0, 0, 1), turned to face the ray
      light 0: N.L = 0.447213595, V.R = 0.447213595, coloured by /shapes/1 (cylinder, transform "pane", material "glass")
        K_A I_AL           = (0.25, 0, 0) (1, 0.5, 0.5) = (0.25, 0, 0)
        K_D I_L (N.L)      = (0.5, 0, 0) (1, 1, 1) 0.447213595 = (0.223606798, 0, 0)
        K_S I_L (V.R)^2    = (0, 0, 0) (1, 1, 1) 0.447213595^2 = (0, 0, 0)
        S_L                = (1, 0.5, 0.25)
        the light's sum    = (0.473606798, 0, 0)
      K_T I_T: no further ray: max_recursion is used up
      I = sum over lights = (0.473606798, 0, 0)
  I = sum over lights + K_T I_T = (0.84487461, 0, 0)
clamped (0.84487461, 0, 0), bytes (215, 0, 0)
)");
    }
    SECTION("down onto the mirror") {
        scene.camera.look = {0, -1, 0};
        scene.camera.up = {0, 0, -1};
        scene.camera.eye = {0, -2, -2.5};
        const RayExplanation seen = scene.explain(0, 0, 1, 1);
        CHECK(explanationSentence(seen, scene) ==
              "cube \"floor\", lit through the cylinder \"pane\" by the light: 40 % of the red is diffuse "
              "light, 38 % "
              "specular light, 21 % ambient light");
        const auto missing = [&](const std::array<std::uint8_t, 3>& bytes) {
            return missingTerms(seen, bytes.data());
        };
        CHECK(missing({233, 57, 28}) == std::vector<std::string>{"its ambient light"});
        CHECK(missing({255, 113, 113}) == std::vector<std::string>{"the shadow from light 0"});
        CHECK(missing({1, 2, 3}).empty());
        CHECK(explanationText(scene.explain(0, 0, 1, 1), scene) == R"(primary ray, max_recursion 1
  origin (0, -2, -2.5), direction (0, -0.5, 0)
  hits /shapes/0 (cube, transform "floor", material "mirror"), y = 1, from outside
  t = 2, position (0, -3, -2.5)
  N = (0, 1, 0)
  light 0: N.L = 0.941741912, V.R = 0.941741912, coloured by /shapes/1 (cylinder, transform "pane", material "glass")
    K_A I_AL           = (0.25, 0, 0) (1, 0.5, 0.5) = (0.25, 0, 0)
    K_D I_L (N.L)      = (0.5, 0, 0) (1, 1, 1) 0.941741912 = (0.470870956, 0, 0)
    K_S I_L (V.R)^2    = (0.5, 0.5, 0.5) (1, 1, 1) 0.941741912^2 = (0.443438914, 0.443438914, 0.443438914)
    S_L                = (1, 0.5, 0.25)
    the light's sum    = (1.16430987, 0.221719457, 0.110859729)
  K_R I_R = (0.5, 0.5, 0.5) (0, 0, 0) = (0, 0, 0)
    reflected ray, max_recursion 0, weight (0.5, 0.5, 0.5) in the pixel
      origin (0, -3, -2.5), direction (0, 1, 0)
      hits nothing: I = (0, 0, 0)
  I = sum over lights + K_R I_R = (1.16430987, 0.221719457, 0.110859729)
clamped (1, 0.221719457, 0.110859729), bytes (255, 57, 28)
)");
    }
    SECTION("past everything") {
        scene.camera.look = {1, 0, 0};
        CHECK(explanationSentence(scene.explainCentre(), scene) == "nothing is hit: black");
        CHECK(explanationText(scene.explainCentre(), scene) == R"(primary ray, max_recursion 3
  origin (0, 0, 0), direction (0.5, 0, 0)
  hits nothing: I = (0, 0, 0)
clamped (0, 0, 0), bytes (0, 0, 0)
)");
    }
}
