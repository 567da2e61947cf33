// Watches rayColor for a pixel and keeps what each ray brings.
#pragma once

#include "raytracer/tracer/ray_tree.h"
#include "raytracer/tracer/scene.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// Nothing is inline, since packet_tracer.cpp uses it.
class RayFollower final : public Observer {
  public:
    void enter(const RayPath& path);
    void light(bool castsShadowRay, const Color& sum);
    void leave();

    void enter(const Ray& ray, const RayPath& path) override;
    void meet(const ShadingPoint& point) override;
    void light(const DirectLight& direct, const Shadow* shadow, const Color& sum) override;
    void notCast(RayKind kind, NotCast reason) override;
    void leave(const Color& color) override;

    // The pixel's, to the end of what is there; another pixel comes next.
    void moveTo(RayTrees& followed);

  private:
    std::vector<RayTreeNode> rays_;
    std::vector<std::size_t> open_;  // the ray being followed, after those that led to it
    int max_recursion_ = 0;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
