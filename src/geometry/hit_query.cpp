#include "raytracer/geometry/hit_query.h"

#include <tuple>

#include "raytracer/geometry/shape.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

bool isListedBefore(const Hit& a, const Hit& b) {
    return std::tuple(a.shape->index(), a.primitive) < std::tuple(b.shape->index(), b.primitive);
}

void HitQuery::consider(const Hit& hit) {
    if (point_) return considerCoincident(hit);
    if (end_ && hit.t >= 1 - coincidenceWindow && hit.shape->touches(end_->position, Vec3(0), hit.primitive))
        return;
    if (found()) {
        const Real window = 1 + coincidenceWindow;
        if (hit.t <= nearest_.t * window && nearest_.t <= hit.t * window) contended_ = true;
        if (hit.t > nearest_.t || (hit.t == nearest_.t && !isListedBefore(hit, nearest_))) return;
    }
    nearest_ = hit;
    limit_ = std::min(limit_, hit.t * (1 + coincidenceWindow));
}

void HitQuery::considerCoincident(const Hit& hit) {
    if (isListedBefore(hit, nearest_) && hit.shape->touches(*point_, *pointError_, hit.primitive))
        nearest_ = hit;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
