#include "raytracer/shape_tree.h"

#include <algorithm>

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

// So many boxed shapes are as fast in a list (Notes.txt).
constexpr std::size_t listLimit = 3;

}  // namespace

ShapeTree::ShapeTree(const std::vector<std::unique_ptr<Shape>>& shapes, const BuildOptions& options) {
    std::vector<FloatBox> boxes;
    Real conditioning = 0;
    for (const auto& shape : shapes) {
        FloatBox box;
        if (!shape->bounds(box)) {
            list_.push_back(shape.get());
            continue;
        }
        boxed_.push_back(shape.get());
        boxes.push_back(box);
        conditioning = std::max(conditioning, shape->transform().conditioning());
    }
    if (options.accelerator == Accelerator::None || boxes.size() <= listLimit) {
        list_.clear(), boxed_.clear();
        for (const auto& shape : shapes) list_.push_back(shape.get());
        return;
    }
    bvh_ = Bvh::ofBoxes(boxes, options.threads);
    slackFactor_ = gamma(32) * conditioning;
}

void ShapeTree::intersect(const Ray& ray, HitQuery& query) const {
    for (const Shape* shape : list_) {
        shape->intersect(ray, query);
        if (query.done()) return;
    }
    if (bvh_.empty()) return;

    // The roundings of the way to object space and back, as far as they go with the distance from the ray's origin.
    const Real slack = slackFactor_ * (maxComponent(abs(ray.origin)) + static_cast<Real>(bvh_.frame().extent));
    BvhCursor cursor(bvh_, {glm::dvec3(ray.origin), glm::dvec3(ray.direction), static_cast<double>(slack)});
    if (!cursor.usable()) {
        for (const Shape* shape : boxed_) shape->intersect(ray, query);
        return;
    }
    while (!query.done() && cursor.next(static_cast<double>(query.limit())))
        for (const std::uint32_t shape : cursor.primitives()) boxed_[shape]->intersect(ray, query);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
