// Renderer (renderer.h) for this precision.
#include "raytracer/tracer/explain.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene_builder.h"

#include "render.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

class SceneRenderer final : public Renderer {
  public:
    SceneRenderer(const SceneDescription& description, const BuildOptions& options)
        : scene_(buildScene(description, options)) {}

    Precision precision() const override {
        if constexpr (std::is_same_v<Real, float>) return Precision::Float;
        else if constexpr (std::is_same_v<Real, double>) return Precision::Double;
        else return Precision::Extended;
    }
    bool fits() const override { return scene_->fits; }

    RenderCounts render(const RenderOptions& options, PixelSink& sink, ProgressListener* progress,
                        const FirstSamples* first) const override {
        return renderPicture(*scene_, options, sink, progress, first);
    }

    RenderCounts renderPoints(const RenderOptions& options, std::span<const glm::dvec2> points,
                              std::span<glm::dvec3> colors) const override {
        return raytracer::renderPoints(*scene_, options, points, colors);
    }

    RenderCounts rayTrees(const RenderOptions& options, std::span<const glm::dvec2> points,
                          RayTrees& trees) const override {
        return traceRayTrees(*scene_, options, points, trees);
    }

    RayExplanation explain(const RenderOptions& options, int x, int y) const override {
        return explainPixel(*scene_, options, x, y);
    }

  private:
    std::unique_ptr<const Scene> scene_;
};

}  // namespace

std::unique_ptr<Renderer> makeCoreRenderer(const SceneDescription& description, const BuildOptions& options) {
    return std::make_unique<SceneRenderer>(description, options);
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
