// Renderer (renderer.h) for this precision: render.cpp, and explain.cpp.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

class SceneRenderer final : public Renderer {
  public:
    explicit SceneRenderer(std::unique_ptr<const Scene> scene) : scene_(std::move(scene)) {}

    Precision precision() const override {
        if constexpr (std::is_same_v<Real, float>) return Precision::Float;
        else if constexpr (std::is_same_v<Real, double>) return Precision::Double;
        else return Precision::Extended;
    }
    bool fits() const override { return scene_->fits; }

    RenderCounts render(const RenderOptions& options, PixelSink& sink, ProgressListener* progress,
                        const FirstSamples* first) const override;
    RenderCounts renderFirst(RenderOptions options, FirstSamples& first) const override;
    RenderCounts renderPoints(const RenderOptions& options, std::span<const glm::dvec2> points,
                              std::span<glm::dvec3> colors) const override;
    RenderCounts rayTrees(const RenderOptions& options, std::span<const glm::dvec2> points,
                          RayTrees& trees) const override;
    void prepare(const RenderOptions& options) const override;
    RayExplanation explain(const RenderOptions& options, int x, int y) const override;

  private:
    using Work = std::function<void(std::uint32_t job)>;

    // Does every job, on options.threads threads, with the stack that options.max_recursion needs. Each
    // thread makes its `work` by workOf(context), and calls work(job).
    RenderCounts shareOut(const RenderOptions& options, std::size_t jobs, ProgressListener* progress,
                          std::uint64_t mostRays,
                          const std::function<Work(const RenderContext&)>& workOf) const;

    // The small parts of the options' crop, or of more. They are kept for the next picture of that size.
    std::shared_ptr<const std::vector<glm::dvec2>> smallPartsOf(const RenderOptions& options) const;

    // Traces points, with the limit mostRays in all. `observer`: of all of them.
    RenderCounts tracePoints(const RenderOptions& options, std::span<const glm::dvec2> points,
                             std::span<glm::dvec3> colors, std::uint64_t mostRays,
                             Observer* observer = nullptr) const;

    std::unique_ptr<const Scene> scene_;
    mutable std::mutex mutex_;  // of what follows
    mutable ImageSize sizeOfParts_{0, 0};
    mutable PixelRectangle placeOfParts_{};
    mutable std::shared_ptr<const std::vector<glm::dvec2>> smallParts_;
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
