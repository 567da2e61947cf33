// The shapes of a scene that a ray must be tested with: those whose boxes it meets, and those without a box.
#pragma once

#include <span>
#include <vector>

#include "raytracer/bvh/build_options.h"
#include "raytracer/geometry/direction_buffer.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

class ShapeTree {
  public:
    ShapeTree() = default;

    // Keeps pointers to the shapes. Without a tree, or where it would not pay, they are a list.
    ShapeTree(std::span<const Shape> shapes, const BuildOptions& options);

    // Offers to the query every hit that could matter to it (Shape::intersect); for one ray or several.
    template <class T>
    void meet(const RayT<T>& ray, HitQueryT<T>& query) const;

    // For the rays from a perspective camera's eye, and for those to a light. Empty where there are many
    // shapes, or no tree is wanted, or the point is so far away that the buffer's numbers could overflow.
    DirectionBuffer fromEye(const Vec3& eye) const;
    DirectionBuffer toLight(const Vec3& light) const;

  private:
    void intersectBoxed(const Ray& ray, HitQuery& query) const;
    template <class T>
    void meetBoxed(const RayT<T>& ray, HitQueryT<T>& query) const;

    // BvhRay::slack for rays that start no farther than this from zero: a bound on the rounding errors of the
    // transforms to object space and back, as far as they grow with the distance from the ray's origin.
    Real slackFrom(Real farthestOrigin) const {
        return slackFactor_ * (farthestOrigin + static_cast<Real>(bvh_.frame().extent));
    }

    const Shape* shapes_ = nullptr;
    // For direction buffers, where there are few shapes: those with a box, and those without; and a bound on
    // the coordinates of the boxes.
    std::vector<BoxedShape> few_;
    std::vector<const Shape*> unbounded_;
    Real extent_ = 0;
    std::vector<const Shape*> list_;    // tested first: their hits shorten the ray for the tree
    std::vector<std::uint32_t> boxed_;  // indices in shapes_ of the others: their names in the tree
    Bvh bvh_;
    Real slackFactor_ = 0;  // BvhRay::slack for a distance of 1
};

template <class T>
void ShapeTree::meet(const RayT<T>& ray, HitQueryT<T>& query) const {
    for (const Shape* shape : list_) {
        shape->meet(ray, query);
        if (query.done()) return;
    }
    if (!bvh_.empty()) meetBoxed(ray, query);
}

template <class T>
void ShapeTree::meetBoxed(const RayT<T>& ray, HitQueryT<T>& query) const {
    const auto slack = [this](Real farthest) { return slackFrom(farthest); };
    BvhCursor cursor(bvh_, cullingRay(ray.origin, ray.direction, slack));
    if (cursor.usable()) {
        while (nextPrimitives(cursor, query))
            for (const std::uint32_t name : cursor.primitives()) shapes_[name].meet(ray, query);
    } else if constexpr (laneCountOf<T> == 1) {
        for (const std::uint32_t name : boxed_) shapes_[name].meet(ray, query);
    } else {
        meetAlone(ray, query, [this](int, const Ray& one, HitQuery& alone) { intersectBoxed(one, alone); });
    }
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
