// What a traversal is looking for, and the best it has seen.
//
// A query's answer is a function of the set of hits offered, never of their order, so that a tree, a list and
// any number of lanes give the same picture.
#pragma once

#include <cstdint>

#include "raytracer/geometry/ray.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// A hit as the traversal carries it.
template <class T>
struct HitT {
    T t = infinity;
    const Shape* shape = nullptr;  // null: nothing hit
    Primitive<T> primitive{};
    bool entering =
        false;  // it meets the exterior side: known by the shape's geometry, not by a rounded normal
};
using Hit = HitT<Real>;

// Whether a's shape stands first in the scene file, or within one shape a's primitive first.
bool isListedBefore(const Hit& a, const Hit& b);

// The end of a shadow ray: the light, at t = 1. Surfaces that the light itself lies on cast no shadow.
struct RayEnd {
    Vec3 position{0};
};

class HitQuery {
  public:
    // The nearest hit of all.
    HitQuery() = default;

    // The nearest hit before t = 1; with `any`, any of them.
    HitQuery(const RayEnd& end, bool any) : limit_(1 - unitRoundoff), end_(&end), any_(any) {}

    // What a packet of rays asks of one of them: hits up to a limit, before an end if there is one.
    HitQuery(const RayEnd* end, bool any, Real limit) : limit_(limit), end_(end), any_(any) {}

    // The first shape in the scene file, and of it the first primitive, that goes through `point` (known to
    // within pointError) and is hit at the t of `nearest`, but for rounding. Starts from `nearest` itself.
    HitQuery(const Hit& nearest, const Vec3& point, const Vec3& pointError)
        : nearest_(nearest),
          limit_(nearest.t * (1 + coincidenceWindow)),
          point_(&point),
          pointError_(&pointError) {}

    // Hits beyond this t are of no interest: what a traversal may cull by.
    Real limit() const { return limit_; }

    // The answer.
    const Hit& nearest() const { return nearest_; }
    bool found() const { return nearest_.shape != nullptr; }

    // No further hit can change the answer.
    bool done() const { return any_ && found(); }

    // Another hit lies so near to the nearest one that the two might coincide: ask for the first of them.
    bool contended() const { return contended_; }

    void offer(bool hit, Real t, const Shape& shape, std::uint32_t primitive, bool entering) {
        if (hit && t <= limit_) consider(Hit{t, &shape, primitive, entering});
    }
    void offerFace(bool hit, Real t, const Shape& shape, Real face, bool entering) {
        offer(hit, t, shape, static_cast<std::uint32_t>(face), entering);
    }

    // Intersection tests made, for --stats.
    std::uint64_t tests = 0;
    void count() { ++tests; }

  private:
    void consider(const Hit& hit);
    void considerCoincident(const Hit& hit);

    Hit nearest_;
    Real limit_ = std::numeric_limits<Real>::max();  // a t that overflows is no hit
    const RayEnd* end_ = nullptr;
    const Vec3* point_ = nullptr;
    const Vec3* pointError_ = nullptr;
    bool any_ = false;
    bool contended_ = false;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
