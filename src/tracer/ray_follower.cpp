#include "ray_follower.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

void RayFollower::enter(const RayPath& path) {
    if (open_.empty()) max_recursion_ = path.max_recursion;
    open_.push_back(rays_.size());
    RayTreeNode ray;
    ray.weight = glm::dvec3(path.weight);
    ray.depth = static_cast<std::uint16_t>(max_recursion_ - path.max_recursion);
    rays_.push_back(ray);
}

void RayFollower::light(bool castsShadowRay, const Color& sum) {
    RayTreeNode& ray = rays_[open_.back()];
    ray.light += ray.weight * glm::dvec3(sum);
    if (castsShadowRay) ++ray.shadows;
}

void RayFollower::leave() { open_.pop_back(); }

void RayFollower::enter(const Ray&, const RayPath& path) { enter(path); }
void RayFollower::meet(const ShadingPoint&) {}
void RayFollower::light(const DirectLight&, const Shadow* shadow, const Color& sum) {
    light(shadow != nullptr, sum);
}
void RayFollower::notCast(RayKind, NotCast) {}
void RayFollower::leave(const Color&) { leave(); }

void RayFollower::moveTo(RayTrees& followed) {
    followed.rays.insert(followed.rays.end(), rays_.begin(), rays_.end());
    followed.ends.push_back(followed.rays.size());
    rays_.clear();
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
