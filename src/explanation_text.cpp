#include "raytracer/explanation_text.h"

#include <cstdio>

#include "raytracer/image.h"

namespace raytracer {

namespace {

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

std::string triple(const glm::dvec3& v) { return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")"; }

const char* kindName(RayKind kind) {
    return kind == RayKind::Primary ? "primary" : kind == RayKind::Reflection ? "reflected" : "refracted";
}

const char* reasonText(NotCast reason) {
    switch (reason) {
        case NotCast::MaxRecursion: return "no further ray: max_recursion is used up";
        case NotCast::Black: return "no further ray: its factor is black";
        case NotCast::Cutoff: return "no further ray: it could change the pixel by less than the cutoff";
        case NotCast::TotalInternalReflection: return "total internal reflection: adds nothing";
        case NotCast::Nothing: break;
    }
    return "";
}

// Lines that are indented by the depth of the ray.
class Writer {
  public:
    explicit Writer(const SceneDescription& scene) : scene_(&scene) {}

    void ray(const RayExplanation& ray, int depth) {
        line(depth, std::string(kindName(ray.kind)) + " ray, weight " + triple(ray.weight) + ", max_recursion " +
                        std::to_string(ray.max_recursion));
        line(depth, "  origin " + triple(ray.origin) + ", direction " + triple(ray.direction));
        if (ray.hit)
            hit(ray, depth);
        else
            line(depth, "  hits nothing: black");
        line(depth, "  I = " + triple(ray.color));
    }

    void line(int depth, const std::string& text) { text_ += std::string(static_cast<std::size_t>(4 * depth), ' ') + text + "\n"; }

    std::string text_;

  private:
    std::string shapeName(std::size_t index) const {
        const ShapeDescription& shape = scene_->shapes[index];
        return "/shapes/" + std::to_string(index) + " (" + typeName(shape.type) + ", transform \"" +
               scene_->transforms[shape.transform].name + "\", material \"" + scene_->materials[shape.material].name + "\")";
    }

    void hit(const RayExplanation& ray, int depth) {
        const MaterialDescription& material = scene_->materials[scene_->shapes[ray.shape].material];
        line(depth, "  hits " + shapeName(ray.shape) + ", part " + std::to_string(ray.primitive) +
                        (ray.entering ? ", from outside" : ", from inside"));
        line(depth, "  t = " + number(ray.t) + ", position " + triple(ray.position) + ", normal " + triple(ray.normal));
        if (ray.texCoord)
            line(depth, "  texCoord (" + number(ray.texCoord->x) + ", " + number(ray.texCoord->y) + "), K_D = " + triple(ray.K_D));
        for (std::size_t i = 0; i < ray.lights.size(); ++i) light(ray.lights[i], i, material, depth);
        onwards(ray, RayKind::Reflection, material.reflective, ray.reflection, "K_R I_R", material.color_reflect, depth);
        onwards(ray, RayKind::Refraction, material.refractive, ray.refraction, "K_T I_T", material.color_refract, depth);
    }

    void light(const LightExplanation& light, std::size_t index, const MaterialDescription& material, int depth) {
        line(depth, "  light " + std::to_string(index) + ": N.L = " + number(light.N_L) + ", V.R = " + number(light.V_R) +
                        ", " + verdict(light));
        line(depth, "    K_A I_AL            = " + triple(light.ambient));
        line(depth, "    K_D I_L (N.L)       = " + triple(light.diffuse));
        line(depth, "    K_S I_L (V.R)^" + number(material.shininess) + " = " + triple(light.specular));
        if (light.asked) line(depth, "    S_L                 = " + triple(light.S_L));
        line(depth, "    the light's sum     = " + triple(light.sum));
    }

    std::string verdict(const LightExplanation& light) const {
        if (light.N_L <= 0) return "behind the surface";
        if (!light.asked) return "no shadow asked for";
        if (!light.shadowedBy) return "nothing in between";
        const bool clear = scene_->materials[scene_->shapes[*light.shadowedBy].material].refractive;
        return (clear ? "coloured by " : "in the shadow of ") + shapeName(*light.shadowedBy);
    }

    void onwards(const RayExplanation& ray, RayKind kind, bool wanted, NotCast reason, const char* term,
                 const glm::dvec3& factor, int depth) {
        if (!wanted) return;
        if (reason != NotCast::Nothing) return line(depth, "  " + std::string(term) + ": " + reasonText(reason));
        for (const RayExplanation& next : ray.rays) {
            if (next.kind != kind) continue;
            line(depth, "  " + std::string(term) + " = " + triple(factor * next.color) + ", the factor " + triple(factor) + " times");
            this->ray(next, depth + 1);
        }
    }

    const SceneDescription* scene_;
};

std::string bytes(const glm::dvec3& color) {
    return "(" + std::to_string(toByte(color.x)) + ", " + std::to_string(toByte(color.y)) + ", " +
           std::to_string(toByte(color.z)) + ")";
}

}  // namespace

std::string explanationText(const RayExplanation& explanation, const SceneDescription& scene) {
    Writer writer(scene);
    writer.ray(explanation, 0);
    writer.line(0, "clamped " + triple(glm::clamp(explanation.color, 0.0, 1.0)) + ", bytes " + bytes(explanation.color));
    return writer.text_;
}

}  // namespace raytracer
