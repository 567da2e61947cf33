#include "raytracer/geometry/shape_tree.h"

#include <algorithm>
#include <functional>
#include <numeric>

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
    bvh_ = Bvh::ofBoxes(boxes, nameBoxed(), options);
    slackFactor_ = gamma(32) * conditioning;
}

// By place, unless they are too far apart for that.
BvhNames ShapeTree::nameBoxed() const {
    const auto address = [](const Shape* shape) { return reinterpret_cast<std::uintptr_t>(shape); };
    const std::uintptr_t first = address(*std::min_element(boxed_.begin(), boxed_.end(), std::less<>()));
    BvhNames names;
    bool fits = true;
    for (const Shape* shape : boxed_) {
        const std::uintptr_t distance = address(shape) - first;
        fits = fits && distance % BvhNames::unit == 0 && distance / BvhNames::unit < BvhNames::limit;
        names.names.push_back(static_cast<std::uint32_t>(distance / BvhNames::unit));
    }
    if (fits) names.start = reinterpret_cast<const char*>(first);
    else std::iota(names.names.begin(), names.names.end(), 0u);
    return names;
}

const Shape& ShapeTree::named(std::uint32_t name) const {
    const char* start = bvh_.frame().objects;
    return start ? *reinterpret_cast<const Shape*>(start + name * BvhNames::unit) : *boxed_[name];
}

void ShapeTree::intersect(const Ray& ray, HitQuery& query) const {
    for (const Shape* shape : list_) {
        shape->intersect(ray, query);
        if (query.done()) return;
    }
    if (!bvh_.empty()) intersectBoxed(ray, query);
}

void ShapeTree::intersectBoxed(const Ray& ray, HitQuery& query) const {
    const auto slack = static_cast<double>(slackFrom(maxComponent(abs(ray.origin))));
    BvhCursor cursor(bvh_, {glm::dvec3(ray.origin), glm::dvec3(ray.direction), slack});
    if (!cursor.usable()) {
        for (const Shape* shape : boxed_) shape->intersect(ray, query);
        return;
    }
    while (!query.done() && cursor.next(static_cast<double>(query.limit())))
        for (const std::uint32_t name : cursor.primitives()) named(name).intersect(ray, query);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
