// Watches rayColor for some pixels and keeps what each ray brings.
#pragma once

#include "raytracer/followed_rays.h"
#include "raytracer/scene.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

class RayFollower final : public Observer {
  public:
    void enter(const Ray&, const RayPath& path) override {
        if (open_.empty()) max_recursion_ = path.max_recursion;
        open_.push_back(followed_.rays.size());
        FollowedRay ray;
        ray.weight = glm::dvec3(path.weight);
        ray.depth = static_cast<std::uint16_t>(max_recursion_ - path.max_recursion);
        followed_.rays.push_back(ray);
    }

    void meet(const ShadingPoint&) override {}

    void light(const DirectLight&, const Shadow* shadow, const Color& sum) override {
        FollowedRay& ray = followed_.rays[open_.back()];
        ray.light += ray.weight * glm::dvec3(sum);
        if (shadow) ++ray.shadows;
    }

    void notCast(RayKind, NotCast) override {}

    void leave(const Color&) override {
        open_.pop_back();
        if (open_.empty()) followed_.ends.push_back(followed_.rays.size());
    }

    FollowedRays take() { return std::move(followed_); }

  private:
    FollowedRays followed_;
    std::vector<std::size_t> open_;  // the ray being followed, after those that led to it
    int max_recursion_ = 0;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
