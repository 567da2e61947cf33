#include <array>

#include "raytracer/explain/explanation_text.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/pictures/image.h"

namespace raytracer {

namespace {

constexpr const char* kindNames[] = {"primary", "reflection", "refraction"};
constexpr const char* reasonNames[] = {"", "max_recursion", "black", "cutoff", "total_internal_reflection"};

void writeVector(JsonWriter& json, const char* key, const glm::dvec3& v) {
    json.key(key).values(std::array{v.x, v.y, v.z});
}

void writeShape(JsonWriter& json, std::size_t index, const SceneDescription& scene) {
    const ShapeDescription& shape = scene.shapes[index];
    json.beginObject();
    json.key("index").value(index);
    json.key("type").value(typeName(shape.type));
    json.key("transform").value(scene.transforms[shape.transform].name);
    json.key("material").value(scene.materials[shape.material].name);
    json.endObject();
}

void writeLight(JsonWriter& json, const LightExplanation& light, const SceneDescription& scene) {
    json.beginObject();
    json.key("N.L").value(light.N_L);
    json.key("V.R").value(light.V_R);
    writeVector(json, "ambient", light.ambient);
    writeVector(json, "diffuse", light.diffuse);
    writeVector(json, "specular", light.specular);
    json.key("shadow_ray").value(light.shadowRayCast);
    if (light.shadowedBy) {
        json.key("shadowed_by");
        writeShape(json, *light.shadowedBy, scene);
    }
    writeVector(json, "S_L", light.S_L);
    writeVector(json, "sum", light.sum);
    json.endObject();
}

void writeRay(JsonWriter& json, const RayExplanation& ray, const SceneDescription& scene);

void writeHit(JsonWriter& json, const RayExplanation& ray, const SceneDescription& scene) {
    json.key("shape");
    writeShape(json, ray.shape, scene);
    json.key("part").value(ray.primitive);
    if (const std::string face = faceName(scene.shapes[ray.shape].type, ray.primitive); !face.empty())
        json.key("face").value(face);
    json.key("from_outside").value(ray.entering);
    json.key("t").value(ray.t);
    writeVector(json, "position", ray.position);
    writeVector(json, "normal", ray.normal);
    if (ray.texCoord) json.key("texCoord").values(std::array{ray.texCoord->x, ray.texCoord->y});
    writeVector(json, "K_D", ray.K_D);
    json.key("lights").array(ray.lights, [&](const auto& light) { writeLight(json, light, scene); });
    if (ray.reflection != TerminationReason::None)
        json.key("no_reflection").value(reasonNames[static_cast<int>(ray.reflection)]);
    if (ray.refraction != TerminationReason::None)
        json.key("no_refraction").value(reasonNames[static_cast<int>(ray.refraction)]);
    json.key("rays").array(ray.rays, [&](const auto& next) { writeRay(json, next, scene); });
}

void writeRay(JsonWriter& json, const RayExplanation& ray, const SceneDescription& scene) {
    json.beginObject();
    json.key("kind").value(kindNames[static_cast<int>(ray.kind)]);
    writeVector(json, "origin", ray.origin);
    writeVector(json, "direction", ray.direction);
    writeVector(json, "weight", ray.weight);
    json.key("max_recursion").value(ray.max_recursion);
    json.key("hit").value(ray.hit);
    if (ray.hit) writeHit(json, ray, scene);
    writeVector(json, "color", ray.color);
    json.endObject();
}

}  // namespace

std::string explanationJson(const RayExplanation& explanation, const SceneDescription& scene,
                            const std::function<void(JsonWriter&)>& before) {
    JsonWriter json;
    json.beginObject();
    if (before) before(json);
    json.key("sentence").value(explanationSentence(explanation, scene));
    json.key("ray");
    writeRay(json, explanation, scene);
    writeVector(json, "clamped", glm::clamp(explanation.color, 0.0, 1.0));
    const glm::dvec3& color = explanation.color;
    json.key("bytes").values(std::array{toByte(color.r), toByte(color.g), toByte(color.b)});
    json.endObject();
    return json.text() + "\n";
}

}  // namespace raytracer
