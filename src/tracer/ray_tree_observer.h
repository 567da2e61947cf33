// Records what each ray behind a point contributes.
#pragma once

#include "raytracer/tracer/ray_tree.h"
#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

class RayTreeObserver final : public Observer {
  public:
    bool asksWhatShadows() const override { return false; }
    void enter(const Ray& ray, const RayPath& path) override;
    void meet(const Intersection&, const Color&) override {}
    void shadow(const Shape* by, const Color& S_L) override;
    void light(const DirectLight& direct, const Color& sum) override;
    void terminate(RayKind, TerminationReason) override {}
    void leave(const Color& color) override;

    // Appends the point's tree to `trees`, and is ready for another point.
    void moveTo(RayTrees& trees);

  private:
    std::vector<RayTreeNode> rays_;
    std::vector<std::size_t> open_;  // the ray in progress, after those that led to it
    int max_recursion_ = 0;
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
