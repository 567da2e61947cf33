#include "scene_parts.h"

#include <array>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "raytracer/scene/affine.h"

namespace raytracer {
namespace {

using namespace std::string_view_literals;

void read(JsonView value, bool& out) { out = value.boolean(); }
void read(JsonView value, double& out) { out = value.number(); }
void read(JsonView value, glm::dvec3& out) { out = value.vec3(); }
void read(JsonView value, std::string& out) { out = value.string(); }

template <class Value>
void readOptional(const JsonObject& object, std::string_view key, Value& out) {
    if (const auto value = object.find(key)) read(*value, out);
}

double positive(JsonView value) {
    const double number = value.number();
    if (!(number > 0)) value.failExpected("a number above 0");
    return number;
}

double notNegative(JsonView value) {
    const double number = value.number();
    if (!(number >= 0)) value.failExpected("0 or a number above it");
    return number;
}

glm::dvec3 direction(JsonView value) {
    const glm::dvec3 vector = value.vec3();
    if (vector == glm::dvec3(0)) value.fail("expected a direction, found 0 0 0");
    return vector;
}

// The product of two doubles neither overflows nor underflows in long double.
bool areParallel(const glm::dvec3& a, const glm::dvec3& b) {
    using Wide = long double;
    const auto minor = [&](int i, int j) { return Wide(a[i]) * Wide(b[j]) - Wide(a[j]) * Wide(b[i]); };
    return minor(0, 1) == 0 && minor(1, 2) == 0 && minor(2, 0) == 0;
}

void readFilm(const JsonObject& json, CameraDescription& camera) {
    read(json["film_left"], camera.film_left);
    read(json["film_right"], camera.film_right);
    read(json["film_bottom"], camera.film_bottom);
    read(json["film_top"], camera.film_top);
    // A film may be mirrored or upside down.
    if (camera.film_left == camera.film_right)
        json["film_right"].failExpected("a number other than film_left");
    if (camera.film_bottom == camera.film_top)
        json["film_top"].failExpected("a number other than film_bottom");
}

void readFrame(const JsonObject& json, CameraDescription& camera) {
    read(json["eye"], camera.eye);
    camera.look = direction(json["look"]);
    camera.up = direction(json["up"]);
    if (!areParallel(camera.look, camera.up)) return;
    const glm::bvec3 areSame = glm::equal(glm::sign(camera.look), glm::sign(camera.up));
    json["up"].fail(std::string("expected another direction than look's, found ") +
                    (glm::all(areSame) ? "the same" : "its opposite"));
}

glm::dvec3 scaleFactors(JsonView scale) {
    const glm::dvec3 factors = scale.vec3();
    for (const JsonView factor : scale.elements())
        if (factor.number() == 0) factor.fail("expected a scale other than 0, found 0");
    return factors;
}

TransformDescription::Rotation readRotation(JsonView view, KnownKeys& keys) {
    static constexpr std::array known = {"degrees"sv, "axis"sv};
    if (view.kind() == JsonDocument::Kind::Array && view.size() > 0 &&
        view.element(0).kind() == JsonDocument::Kind::Object)
        view.failExpected("one rotation (a matrix takes more)");
    if (view.kind() != JsonDocument::Kind::Object)
        view.failExpected(R"({"degrees": 90, "axis": [0, 1, 0]})", JsonDocument::Kind::Object);
    const JsonObject json = keys.check(view, known);
    TransformDescription::Rotation rotation;
    read(json["degrees"], rotation.degrees);
    rotation.axis = direction(json["axis"]);
    return rotation;
}

glm::dvec4 readColumn(JsonView json, bool isLast) {
    double numbers[4];
    json.numbers(numbers);
    if (numbers[3] != (isLast ? 1 : 0))
        json.element(3).failExpected((isLast ? "1" : "0") +
                                     std::string(" in the bottom row (the lists are columns)"));
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

glm::dmat4 readMatrix(JsonView json) {
    constexpr int columns = 4;
    json.requireElements(columns, "4 columns");
    glm::dmat4 matrix;
    int i = 0;
    for (const JsonView column : json.elements()) {
        matrix[i] = readColumn(column, i == columns - 1);
        ++i;
    }
    return matrix;
}

// x y z, or homogeneous coordinates x y z 1.
glm::dvec3 readPosition(JsonView json) {
    double numbers[4] = {0, 0, 0, 1};
    const bool isHomogeneous = json.size() == 4;
    json.numbers(std::span(numbers).first(isHomogeneous ? 4 : 3), "3 numbers or 4");
    if (numbers[3] != 1) json.element(3).failExpected("1, as a point has");
    return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

CameraDescription readCamera(JsonView view, KnownKeys& keys) {
    static constexpr std::array known = {"type"sv,       "focal_length"sv, "eye"sv,
                                         "look"sv,       "up"sv,           "film_left"sv,
                                         "film_right"sv, "film_bottom"sv,  "film_top"sv};
    static constexpr std::array types = {"perspective"sv, "orthographic"sv};
    const JsonObject json = keys.check(view, known);
    CameraDescription camera;
    camera.type = static_cast<CameraDescription::Type>(json["type"].choice(types));
    if (camera.type == CameraDescription::Type::Perspective)
        camera.focal_length = positive(json["focal_length"]);
    else if (const auto unused = json.find("focal_length")) unused->number();
    readFrame(json, camera);
    readFilm(json, camera);
    return camera;
}

MaterialDescription readMaterial(JsonView view, KnownKeys& keys) {
    static constexpr std::array known = {
        "name"sv,          "color_ambient"sv,       "color_diffuse"sv,       "color_specular"sv,
        "shininess"sv,     "reflective"sv,          "color_reflect"sv,       "refractive"sv,
        "color_refract"sv, "index_of_refraction"sv, "use_diffuse_texture"sv, "diffuse_texture"sv};
    const JsonObject json = keys.check(view, known);
    MaterialDescription material;
    readOptional(json, "name", material.name);
    readOptional(json, "color_ambient", material.color_ambient);
    readOptional(json, "color_diffuse", material.color_diffuse);
    readOptional(json, "color_specular", material.color_specular);
    if (const auto shininess = json.find("shininess")) material.shininess = notNegative(*shininess);
    readOptional(json, "reflective", material.reflective);
    readOptional(json, "color_reflect", material.color_reflect);
    readOptional(json, "refractive", material.refractive);
    readOptional(json, "color_refract", material.color_refract);
    if (const auto index = json.find("index_of_refraction")) material.index_of_refraction = positive(*index);
    readOptional(json, "use_diffuse_texture", material.use_diffuse_texture);
    readOptional(json, "diffuse_texture", material.diffuse_texture);
    if (material.use_diffuse_texture) json["diffuse_texture"];  // throws where it is missing
    return material;
}

LightDescription readLight(JsonView view, KnownKeys& keys) {
    static constexpr std::array known = {"position"sv, "color"sv, "color_ambient"sv};
    const JsonObject json = keys.check(view, known);
    LightDescription light;
    if (const auto position = json.find("position")) light.position = readPosition(*position);
    readOptional(json, "color", light.color);
    readOptional(json, "color_ambient", light.color_ambient);
    return light;
}

TransformDescription readTransform(JsonView view, KnownKeys& keys) {
    static constexpr std::array known = {"name"sv, "translate"sv, "rotate"sv, "scale"sv, "matrix"sv};
    const JsonObject json = keys.check(view, known);
    TransformDescription transform;
    read(json["name"], transform.name);
    if (const auto translate = json.find("translate")) transform.translate = translate->vec3();
    if (const auto rotate = json.find("rotate")) transform.rotate = readRotation(*rotate, keys);
    if (const auto scale = json.find("scale")) transform.scale = scaleFactors(*scale);
    if (const auto matrix = json.find("matrix")) transform.matrix = readMatrix(*matrix);
    // Without a matrix there is always an inverse: scales are not 0.
    if (transform.matrix && !inverseLinear(compose(transform)))
        view.fail("expected a transform that has an inverse, found one that is singular");
    return transform;
}

}  // namespace raytracer
