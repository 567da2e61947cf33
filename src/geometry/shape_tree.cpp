#include "raytracer/geometry/shape_tree.h"

#include <algorithm>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// Up to this many boxed shapes a list is as fast as a tree (Notes.txt).
constexpr std::size_t mostListedShapes = 3;

}  // namespace

ShapeTree::ShapeTree(std::span<const Shape> shapes, const BuildOptions& options) : shapes_(shapes.data()) {
    std::vector<FloatBox> boxes;
    Real conditioning = 0;
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        FloatBox box;
        if (!shapes[i].bounds(box)) {
            list_.push_back(&shapes[i]);
            continue;
        }
        boxed_.push_back(i);
        boxes.push_back(box);
        conditioning = std::max(conditioning, shapes[i].transform().conditioning());
    }
    if (options.accelerator == Accelerator::None || boxes.size() <= mostListedShapes) {
        boxed_.clear();
        list_.clear();
        for (const Shape& shape : shapes) list_.push_back(&shape);
        return;
    }
    bvh_ = Bvh::ofBoxes(boxes, boxed_, options);
    slackFactor_ = gamma(32) * conditioning;
}

void ShapeTree::intersectBoxed(const Ray& ray, HitQuery& query) const { meetBoxed(ray, query); }

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
