#include "raytracer/geometry/shape_tree.h"

#include <algorithm>
#include <limits>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// Up to this many boxed shapes a list is as fast as a tree (Notes.txt).
constexpr std::size_t mostListedShapes = 3;

// Shadow rays from points farther away than this, in sizes of the scene, are tested with all shapes: the
// slack of a direction buffer grows with that distance.
constexpr Real farAway = 1024;

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
    slackFactor_ = gamma(32) * conditioning;
    if (options.accelerator == Accelerator::Bvh && shapes.size() <= DirectionBuffer::mostShapes) {
        unbounded_ = list_;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            few_.push_back({&shapes[boxed_[i]], boxes[i]});
            for (int axis = 0; axis < 3; ++axis)
                extent_ = std::max({extent_, static_cast<Real>(boxes[i].high[axis]),
                                    static_cast<Real>(-boxes[i].low[axis])});
        }
    }
    if (options.accelerator == Accelerator::None || boxes.size() <= mostListedShapes) {
        boxed_.clear();
        list_.clear();
        for (const Shape& shape : shapes) list_.push_back(&shape);
        return;
    }
    bvh_ = Bvh::ofBoxes(boxes, boxed_, options);
}

DirectionBuffer ShapeTree::fromEye(const Vec3& eye) const {
    const Real extent = maxComponent(abs(eye)) + extent_;
    if (few_.empty() || !(extent <= widestRange)) return {};
    return {eye, few_, unbounded_, std::numeric_limits<Real>::max(), slackFactor_ * extent};
}

DirectionBuffer ShapeTree::toLight(const Vec3& light) const {
    const Real extent = maxComponent(abs(light)) + extent_, reach = farAway * extent;
    if (few_.empty() || !(extent <= widestRange)) return {};
    return {light, few_, unbounded_, reach, slackFactor_ * (extent + reach)};
}

void ShapeTree::intersectBoxed(const Ray& ray, HitQuery& query) const { meetBoxed(ray, query); }

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
