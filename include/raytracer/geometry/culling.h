// How a query searches a tree: with which ray or beam, and how the rays of a packet go on alone.
#pragma once

#include "raytracer/bvh/bvh.h"
#include "raytracer/geometry/hit_query.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// What a tree is searched with: a ray, or for a packet the beam that bounds its rays. slackFrom(distance)
// gives BvhRay::slack for rays that start no farther than `distance` from zero along any axis.
template <class SlackFrom>
BvhRay cullingRay(const Vec3& origin, const Vec3& direction, SlackFrom slackFrom) {
    const auto slack = static_cast<double>(slackFrom(maxComponent(abs(origin))));
    return {glm::dvec3(origin), glm::dvec3(direction), slack};
}
template <class T, class SlackFrom>
BvhBeam cullingRay(const Vec3T<T>& origin, const Vec3T<T>& direction, SlackFrom slackFrom) {
    BvhBeam beam{};
    storeLeast(origin, beam.originLow);
    storeLeast(-origin, beam.originHigh);
    storeLeast(direction, beam.directionLow);
    storeLeast(-direction, beam.directionHigh);
    for (double& x : beam.originHigh) x = -x;
    for (double& x : beam.directionHigh) x = -x;
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis)
        farthest = std::max(farthest, std::max(-beam.originLow[axis], beam.originHigh[axis]));
    beam.slack = static_cast<double>(slackFrom(static_cast<Real>(farthest)));
    return beam;
}

// Moves on to the next primitives that could matter to the query; false where there are none.
template <class T>
bool nextPrimitives(BvhCursor& cursor, const HitQueryT<T>& query) {
    return !query.done() && cursor.next(static_cast<double>(greatest(query.limit())));
}

// Traces each lane's ray on its own, where the rays of a packet cannot go on together. Calls intersect(lane,
// ray, query of that ray).
template <class T, class Intersect>
void meetAlone(const RayT<T>& ray, HitQueryT<T>& query, Intersect intersect) {
    forEach<T>(query.active(), [&](int lane) {
        if (!(laneOf(query.limit(), lane) >= 0)) return;
        HitQuery alone(query, lane);
        intersect(lane, laneOf(ray, lane), alone);
        query.offer(lane, alone);
    });
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
