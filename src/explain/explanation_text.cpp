#include "raytracer/explain/explanation_text.h"

#include "raytracer/geometry/shapes.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

std::string number(double value) { return formatted("%.9g", value + 0.0); }  // no "-0"

std::string triple(const glm::dvec3& v) {
    return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
}

std::string bytes(const glm::dvec3& color) {
    return formatted("(%d, %d, %d)", toByte(color.x), toByte(color.y), toByte(color.z));
}

// Texts, in the order of TerminationReason.
constexpr const char* reasonTexts[] = {"left out", "no further ray: max_recursion is used up",
                                       "no further ray: its factor is black",
                                       "no further ray: it could change the pixel by less than the cutoff",
                                       "total internal reflection: adds nothing"};

// Writes lines, indented by the depth of the ray.
class Writer {
  public:
    Writer(const SceneDescription& scene, int depth) : scene_(scene), deepest_(depth) {}

    void ray(const RayExplanation& ray, int depth) {
        line(depth, heading(ray));
        line(depth, "  origin " + triple(ray.origin) + ", direction " + triple(ray.direction));
        if (!ray.hit) return line(depth, "  hits nothing: I = " + triple(ray.color));
        place(ray, depth);
        for (std::size_t i = 0; i < ray.lights.size(); ++i) light(ray, i, depth);
        const MaterialDescription& material = materialOf(scene_, ray.shape);
        std::string sum = "sum over lights";
        if (material.reflective) sum += onwards(ray, RayKind::Reflection, ray.reflection, depth);
        if (material.refractive) sum += onwards(ray, RayKind::Refraction, ray.refraction, depth);
        line(depth, "  I = " + sum + " = " + triple(ray.color));
    }

    void line(int depth, const std::string& text) {
        text_.append(4 * static_cast<std::size_t>(depth), ' ').append(text).append("\n");
    }

    const std::string& text() const { return text_; }

  private:
    std::string shapeName(std::size_t index) const {
        const ShapeDescription& shape = scene_.shapes[index];
        return "/shapes/" + std::to_string(index) + " (" + typeName(shape.type) + ", transform " +
               inQuotes(scene_.transforms[shape.transform].name) + ", material " +
               inQuotes(scene_.materials[shape.material].name) + ")";
    }

    static std::string heading(const RayExplanation& ray) {
        const std::string depth = " ray, max_recursion " + std::to_string(ray.max_recursion);
        if (ray.kind == RayKind::Primary) return "primary" + depth;
        return (ray.kind == RayKind::Reflection ? "reflected" : "refracted") + depth + ", weight " +
               triple(ray.weight) + " in the pixel";
    }

    void place(const RayExplanation& ray, int depth) {
        const std::string face = faceName(scene_.shapes[ray.shape].type, ray.primitive);
        line(depth, "  hits " + shapeName(ray.shape) + (face.empty() ? face : ", " + face) +
                        (ray.entering ? ", from outside" : ", from inside"));
        line(depth, "  t = " + number(ray.t) + ", position " + triple(ray.position));
        if (ray.entering) line(depth, "  N = " + triple(ray.normal));
        else line(depth, "  N = " + triple(-ray.normal) + ", turned to face the ray");
        if (ray.texCoord)
            line(depth, "  K_D = " + triple(ray.K_D) + ", the texture's at texCoord (" +
                            number(ray.texCoord->x) + ", " + number(ray.texCoord->y) +
                            ") with color_diffuse " + triple(materialOf(scene_, ray.shape).color_diffuse));
    }

    // A line "name = left right ... = result", with the equals signs aligned.
    void term(int depth, const std::string& name, const std::string& factors, const glm::dvec3& result) {
        constexpr std::size_t widest = 18;  // the longest name: K_S I_L (V.R)^1000
        const std::size_t padding = name.size() < widest ? widest - name.size() : 0;
        line(depth, "    " + name + std::string(padding, ' ') + " = " + factors + triple(result));
    }

    void light(const RayExplanation& ray, std::size_t index, int depth) {
        const LightExplanation& light = ray.lights[index];
        const LightDescription& given = scene_.lights[index];
        const MaterialDescription& material = materialOf(scene_, ray.shape);
        line(depth, "  light " + std::to_string(index) + ": " + verdict(light));
        term(depth, "K_A I_AL", triple(material.color_ambient) + " " + triple(given.color_ambient) + " = ",
             light.ambient);
        if (light.N_L > 0) {
            const std::string shininess = number(material.shininess);
            term(depth, "K_D I_L (N.L)",
                 triple(ray.K_D) + " " + triple(given.color) + " " + number(light.N_L) + " = ",
                 light.diffuse);
            term(depth, "K_S I_L (V.R)^" + shininess,
                 triple(material.color_specular) + " " + triple(given.color) + " " + number(light.V_R) + "^" +
                     shininess + " = ",
                 light.specular);
            term(depth, "S_L", "", light.S_L);
        }
        term(depth, "the light's sum", "", light.sum);
    }

    std::string verdict(const LightExplanation& light) const {
        if (!(light.N_L > 0)) return "behind the surface (N.L <= 0), so only ambient";
        const std::string angles = "N.L = " + number(light.N_L) + ", V.R = " + number(light.V_R) + ", ";
        if (!light.shadowRayCast)
            return angles + (light.diffuse + light.specular == glm::dvec3(0) ? "nothing to be shadowed"
                                                                             : "shadows are off");
        if (!light.shadowedBy) return angles + "nothing in between";
        const bool clear = materialOf(scene_, *light.shadowedBy).refractive;
        return angles + (clear ? "coloured by " : "in the shadow of ") + shapeName(*light.shadowedBy);
    }

    // Writes the reflected or refracted ray; returns its term of the sum's formula.
    std::string onwards(const RayExplanation& ray, RayKind kind, TerminationReason reason, int depth) {
        const bool mirror = kind == RayKind::Reflection;
        const std::string term = mirror ? "K_R I_R" : "K_T I_T";
        const glm::dvec3& factor = mirror ? materialOf(scene_, ray.shape).color_reflect
                                          : materialOf(scene_, ray.shape).color_refract;
        for (const RayExplanation& next : ray.rays) {
            if (next.kind != kind) continue;
            line(depth, "  " + term + " = " + triple(factor) + " " + triple(next.color) + " = " +
                            triple(next.brought));
            if (depth < deepest_) this->ray(next, depth + 1);
            return " + " + term;
        }
        line(depth, "  " + term + ": " + reasonTexts[static_cast<int>(reason)]);
        return "";
    }

    const SceneDescription& scene_;
    int deepest_;
    std::string text_;
};

}  // namespace

std::string faceName(ShapeType type, std::size_t primitive) {
    return visit(type, [&](auto kind) { return kind.faceName(primitive); });
}

std::string explanationText(const RayExplanation& explanation, const SceneDescription& scene, int depth) {
    Writer writer(scene, depth);
    writer.ray(explanation, 0);
    writer.line(0, "clamped " + triple(glm::clamp(explanation.color, 0.0, 1.0)) + ", bytes " +
                       bytes(explanation.color));
    return writer.text();
}

}  // namespace raytracer
