#include "raytracer/tracer/explain.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

class Recorder final : public Observer {
  public:
    explicit Recorder(const Scene& scene) : scene_(&scene) {}

    bool asksWhatShadows() const override { return true; }

    void enter(const Ray& ray, const RayPath& path) override {
        RayExplanation explanation;
        explanation.kind = path.kind;
        explanation.origin = pointInFile(ray.origin);
        explanation.direction = scaled(ray.direction, directionExponent(path.kind));
        explanation.weight = glm::dvec3(path.weight);
        explanation.max_recursion = path.max_recursion;
        open_.push_back(std::move(explanation));
    }

    void meet(const ShadingPoint& point) override {
        RayExplanation& ray = open_.back();
        const Intersection& hit = *point.hit;
        ray.hit = true;
        ray.shape = hit.shape->index();
        ray.primitive = hit.primitive;
        ray.entering = point.entering;
        ray.t = static_cast<double>(std::scalbn(hit.t, scene_->frame.exponent - directionExponent(ray.kind)));
        ray.position = pointInFile(hit.position);
        ray.normal = glm::dvec3(hit.normal);
        if (hit.material->diffuse_texture) ray.texCoord = glm::dvec2(hit.texCoord);
        ray.K_D = glm::dvec3(point.K_D);
    }

    void light(const DirectLight& direct, const Shadow* shadow, const Color& sum) override {
        LightExplanation light;
        light.ambient = glm::dvec3(direct.ambient);
        light.N_L = static_cast<double>(direct.N_L);
        light.V_R = static_cast<double>(direct.V_R);
        light.diffuse = glm::dvec3(direct.diffuse);
        light.specular = glm::dvec3(direct.specular);
        light.asked = shadow != nullptr;
        if (shadow && shadow->by) light.shadowedBy = shadow->by->index();
        if (shadow) light.S_L = glm::dvec3(shadow->factor);
        light.sum = glm::dvec3(sum);
        open_.back().lights.push_back(light);
    }

    void notCast(RayKind kind, NotCast reason) override {
        (kind == RayKind::Reflection ? open_.back().reflection : open_.back().refraction) = reason;
    }

    void leave(const Color& color) override {
        open_.back().color = glm::dvec3(color);
        if (open_.size() == 1) return;
        RayExplanation done = std::move(open_.back());
        open_.pop_back();
        open_.back().rays.push_back(std::move(done));
    }

    RayExplanation take() { return std::move(open_.front()); }

  private:
    // Primary rays keep the file's direction but for a power of two; secondary ones are of unit length.
    int directionExponent(RayKind kind) const {
        return kind == RayKind::Primary ? scene_->camera.directionExponent() : 0;
    }

    static glm::dvec3 scaled(const Vec3& v, int exponent) {
        return {static_cast<double>(std::scalbn(v.x, exponent)),
                static_cast<double>(std::scalbn(v.y, exponent)),
                static_cast<double>(std::scalbn(v.z, exponent))};
    }

    glm::dvec3 pointInFile(const Vec3& point) const {
        const SceneFrame& frame = scene_->frame;
        glm::dvec3 result;
        for (int axis = 0; axis < 3; ++axis) {
            const long double fromOrigin = std::scalbn(static_cast<long double>(point[axis]), frame.exponent);
            result[axis] = static_cast<double>(fromOrigin + frame.origin[axis]);
        }
        return result;
    }

    const Scene* scene_;
    std::vector<RayExplanation> open_;  // the ray being followed, under those that led to it
};

}  // namespace

RayExplanation explainPixel(const Scene& scene, const RenderOptions& options, int x, int y) {
    Recorder recorder(scene);
    RenderOptions once = options;
    once.samples = 1;
    once.pass = Pass::Color;
    const auto brightest = scene.brightestColors(options.max_recursion);
    RenderContext context{&once, options.cutoff > 0 ? brightest.data() : nullptr, &recorder};
    const PixelPlace pixel{x, y};
    Color color;
    scene.pixelColors({&pixel, 1}, {&color, 1}, context);
    return recorder.take();
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
