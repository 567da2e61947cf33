#include "raytracer/geometry/hit_query.h"

#include <tuple>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

bool isListedBefore(const Hit& a, const Hit& b) {
    return std::tuple(a.shape->index(), a.primitive) < std::tuple(b.shape->index(), b.primitive);
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
