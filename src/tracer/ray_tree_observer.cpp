#include "ray_tree_observer.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

void RayTreeObserver::enter(const Ray&, const RayPath& path) {
    if (open_.empty()) max_recursion_ = path.max_recursion;
    open_.push_back(rays_.size());
    RayTreeNode ray;
    ray.weight = asDouble(path.weight);
    ray.depth = static_cast<std::uint16_t>(max_recursion_ - path.max_recursion);
    rays_.push_back(ray);
}

void RayTreeObserver::shadow(const Shape*, const Color&) { ++rays_[open_.back()].shadows; }

void RayTreeObserver::light(const DirectLight&, const Color& sum) {
    RayTreeNode& ray = rays_[open_.back()];
    ray.light += ray.weight * asDouble(sum);
}

void RayTreeObserver::leave(const Color&) { open_.pop_back(); }

void RayTreeObserver::moveTo(RayTrees& trees) {
    trees.rays.insert(trees.rays.end(), rays_.begin(), rays_.end());
    trees.ends.push_back(trees.rays.size());
    rays_.clear();
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
