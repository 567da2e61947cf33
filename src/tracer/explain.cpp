#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene_renderer.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

class Recorder final : public Observer {
  public:
    explicit Recorder(const Scene& scene) : scene_(&scene) {}

    bool asksWhatShadows() const override { return true; }

    void enter(const Ray& ray, const RayPath& path) override {
        RayExplanation explanation;
        explanation.kind = path.kind;
        explanation.origin = pointInFile(ray.origin);
        const int exponent = directionExponent(path.kind, ray.direction);
        explanation.direction = scaled(ray.direction, exponent);
        explanation.weight = asDouble(path.weight);
        explanation.max_recursion = path.max_recursion;
        open_.push_back({std::move(explanation), exponent, nullptr});
    }

    void meet(const Intersection& hit, const Color& K_D) override {
        open_.back().material = hit.material;
        RayExplanation& ray = open_.back().ray;
        ray.hit = true;
        ray.shape = hit.shape->index();
        ray.primitive = hit.primitive;
        ray.entering = hit.entering;
        const int exponent = scene_->frame.exponent - open_.back().directionExponent;
        ray.t = inRange(std::scalbn(static_cast<long double>(hit.t), exponent));
        ray.position = pointInFile(hit.position);
        ray.normal = glm::dvec3(hit.normal);
        if (hit.material->diffuse_texture) ray.texCoord = glm::dvec2(hit.texCoord);
        ray.K_D = asDouble(K_D);
    }

    void shadow(const Shape* by, const Color& S_L) override {
        light_.shadowRayCast = true;
        if (by) light_.shadowedBy = by->index();
        light_.S_L = asDouble(S_L);
    }

    void light(const DirectLight& direct, const Color& sum) override {
        light_.ambient = asDouble(direct.ambient);
        light_.N_L = static_cast<double>(direct.N_L);
        light_.V_R = static_cast<double>(direct.V_R);
        light_.diffuse = asDouble(direct.diffuse);
        light_.specular = asDouble(direct.specular);
        light_.sum = asDouble(sum);
        open_.back().ray.lights.push_back(light_);
        light_ = {};
    }

    void terminate(RayKind kind, TerminationReason reason) override {
        RayExplanation& ray = open_.back().ray;
        (kind == RayKind::Reflection ? ray.reflection : ray.refraction) = reason;
    }

    void leave(const Color& color) override {
        open_.back().ray.color = asDouble(color);
        if (open_.size() == 1) return;
        RayExplanation done = std::move(open_.back().ray);
        open_.pop_back();
        const Material& from = *open_.back().material;
        const bool mirror = done.kind == RayKind::Reflection;
        done.brought = asDouble((mirror ? from.color_reflect : from.color_refract) * withinBrightest(color));
        open_.back().ray.rays.push_back(std::move(done));
    }

    RayExplanation take() { return std::move(open_.front().ray); }

  private:
    struct OpenRay {
        RayExplanation ray;
        int directionExponent;
        const Material* material;  // of what it hits
    };

    // Primary rays have the file's direction, up to a power of two, and one that double has. Secondary rays
    // have unit length.
    int directionExponent(RayKind kind, const Vec3& direction) const {
        if (kind != RayKind::Primary) return 0;
        const int own = std::ilogb(std::max(maxComponent(abs(direction)), std::numeric_limits<Real>::min()));
        return std::min(scene_->camera.directionExponent(),
                        std::numeric_limits<double>::max_exponent - 2 - own);
    }

    // The nearest that double has.
    static double inRange(long double x) {
        constexpr long double most = std::numeric_limits<double>::max();
        return static_cast<double>(std::clamp(x, -most, most));
    }

    glm::dvec3 pointInFile(const Vec3& point) const {
        const ExtendedVec p = scaled(point, scene_->frame.exponent) + scene_->frame.origin;
        return {inRange(p.x), inRange(p.y), inRange(p.z)};
    }

    const Scene* scene_;
    LightExplanation light_;     // the light in progress: `shadow` comes before `light`
    std::vector<OpenRay> open_;  // the ray in progress, after those that led to it
};

}  // namespace

RayExplanation SceneRenderer::explain(const RenderOptions& options, int x, int y) const {
    Recorder recorder(*scene_);
    RenderOptions shaded = options;
    shaded.pass = Pass::Color;
    glm::dvec3 color;
    tracePoints(shaded, std::array{glm::dvec2(x + 0.5, y + 0.5)}, {&color, 1},
                std::numeric_limits<std::uint64_t>::max(), &recorder);
    return recorder.take();
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
