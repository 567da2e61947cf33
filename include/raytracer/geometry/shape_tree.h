// Which shapes of a scene a ray has to be tried on: those whose boxes it meets, and those that have none.
#pragma once

#include <memory>
#include <vector>

#include "raytracer/bvh/build_options.h"
#include "raytracer/bvh/bvh.h"
#include "raytracer/geometry/shape.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

class ShapeTree {
  public:
    ShapeTree() = default;

    // Points to the shapes. Without a tree, or where it would not pay, they are a list.
    ShapeTree(const std::vector<std::unique_ptr<Shape>>& shapes, const BuildOptions& options);

    // Offers to the query every hit that could matter to it (Shape::intersect).
    void intersect(const Ray& ray, HitQuery& query) const;

    // What it is made of: shapes to be tried on every ray, and a tree (perhaps empty) of the others, which it
    // names.
    const std::vector<const Shape*>& list() const { return list_; }
    const Bvh& bvh() const { return bvh_; }
    const Shape& named(std::uint32_t name) const;
    void intersectBoxed(const Ray& ray, HitQuery& query) const;

    // BvhRay::slack for rays from no farther than this: the roundings of the way to object space and back, as
    // far as they go with the distance from the ray's origin.
    Real slackFrom(Real farthestOrigin) const {
        return slackFactor_ * (farthestOrigin + static_cast<Real>(bvh_.frame().extent));
    }

  private:
    BvhNames nameBoxed() const;

    std::vector<const Shape*> list_;  // first: what they hit shortens the ray for the tree
    std::vector<const Shape*> boxed_;
    Bvh bvh_;               // over boxed_, which it names by index or by place in memory
    Real slackFactor_ = 0;  // BvhRay::slack for a distance of 1
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
