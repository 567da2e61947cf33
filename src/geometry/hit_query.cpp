#include "raytracer/geometry/hit_query.h"

#include <tuple>

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

bool isListedBefore(const Hit& a, const Hit& b) {
    return std::tuple(a.shape->index(), a.primitive) < std::tuple(b.shape->index(), b.primitive);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
