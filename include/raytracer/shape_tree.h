// Which shapes of a scene a ray has to be tried on: those whose boxes it meets, and those that have none.
#pragma once

#include <memory>
#include <vector>

#include "raytracer/bvh.h"
#include "raytracer/render_options.h"
#include "raytracer/shape.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

class ShapeTree {
  public:
    ShapeTree() = default;

    // Points to the shapes. Without a tree, or where it would not pay, they are a list.
    ShapeTree(const std::vector<std::unique_ptr<Shape>>& shapes, const BuildOptions& options);

    // Offers to the query every hit that could matter to it (Shape::intersect).
    void intersect(const Ray& ray, HitQuery& query) const;

  private:
    BvhNames nameBoxed() const;
    const Shape& named(std::uint32_t name) const;

    std::vector<const Shape*> list_;  // first: what they hit shortens the ray for the tree
    std::vector<const Shape*> boxed_;
    Bvh bvh_;                         // over boxed_, which it names by index or by place in memory
    Real slackFactor_ = 0;            // BvhRay::slack for a distance of 1
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
