// What a traversal is looking for, and the hit that it has so far: for one ray, or for each ray of a packet.
//
// The picture does not depend on the order in which hits are offered, so a tree, a list and any number of
// lanes give the same one. Of two hits with exactly the same t, the one listed first in the scene file wins.
// A query for any hit keeps the first one offered: only its existence counts. Hits whose t differ by no more
// than rounding are decided afterwards, by Scene::firstOfCoincident: the nearest of them wins, and where
// their surfaces coincide the one listed first.
#pragma once

#include "raytracer/geometry/shape.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Whether `a` comes before `b` in the scene file: by shape, and within one shape by primitive.
bool isListedBefore(const Hit& a, const Hit& b);

template <class T>
class HitQueryT {
  public:
    // Asks for the nearest hit, in the active lanes.
    explicit HitQueryT(LaneBits active = allLanesOf<T>)
        : active_(active), limit_(select(maskOf<T>(active), T(std::numeric_limits<Real>::max()), T(-1))) {}

    // Asks for the nearest hit before t = 1, where the light `end` is; with `any`, for any such hit. A
    // surface that the light lies on casts no shadow there.
    HitQueryT(const Vec3& end, bool any, LaneBits active = allLanesOf<T>)
        : active_(active),
          limit_(select(maskOf<T>(active), T(1 - unitRoundoff), T(-1))),
          end_(&end),
          any_(any) {}

    // For a single ray: what `query` still asks in one of its lanes.
    template <class U>
    HitQueryT(const HitQueryT<U>& query, int lane)
        : active_(1), limit_(laneOf(query.limit_, lane)), end_(query.end_), any_(query.any_) {}

    // For a single ray: of all hits that have the t of `nearest`, up to rounding, and whose surfaces go
    // through `point` (known to within pointError), the one listed first in the scene file. `nearest` itself
    // is the first candidate.
    HitQueryT(const Hit& nearest, const Vec3& point, const Vec3& pointError)
        : active_(1), limit_(nearest.t * (1 + coincidenceWindow)), point_(&point), pointError_(&pointError) {
        set(0, nearest);
    }

    // For a single ray: the nearest hit with t <= limit.
    static HitQueryT upTo(Real limit) {
        HitQueryT query;
        query.limit_ = limit;
        return query;
    }

    LaneBits active() const { return active_; }

    // Hits beyond this t do not matter, so a traversal may cull by it. Below 0 in a lane that wants no hit.
    const T& limit() const { return limit_; }

    // Whether the rays end at a light, at t = 1.
    bool endsAtLight() const { return end_ != nullptr; }

    // Whether no further hit can change the answer.
    bool done() const { return any_ && found_ == active_; }

    // The lanes that have a hit, and the answer of one lane.
    LaneBits found() const { return found_; }
    Hit nearest(int lane = 0) const {
        return {laneOf(nearest_, lane), shape_[lane], laneOf(primitive_, lane), (entering_ >> lane & 1) != 0};
    }

    // The lanes in which another hit was so near to the nearest one that the two surfaces may coincide there.
    // Scene::firstOfCoincident decides them.
    LaneBits contended() const { return any_ ? 0 : contended_; }
    void set(int lane, const Hit& hit) {
        found_ |= bitOf(lane);
        setLane(nearest_, lane, hit.t);
        shape_[lane] = hit.shape;
        setLane(primitive_, lane, hit.primitive);
        entering_ = hit.entering ? entering_ | bitOf(lane) : entering_ & ~bitOf(lane);
    }

    // Of these lanes, those that hit the same face of the same shape as the first of them, from the same
    // side. On a mesh any triangle will do.
    LaneBits coherent(LaneBits lanes) const {
        if constexpr (laneCountOf<T> == 1) return lanes;
        const int first = firstLane(lanes);
        const bool anyPrimitive = shape_[first]->type() == ShapeType::Mesh;
        LaneBits same = 0;
        for (int lane = 0; lane < laneCountOf<T>; ++lane) {
            const bool face = (laneOf(primitive_, lane) == laneOf(primitive_, first)) | anyPrimitive;
            same |= static_cast<LaneBits>((shape_[lane] == shape_[first]) & face) << lane;
        }
        return lanes & same & (entering_ >> first & 1 ? entering_ : ~entering_);
    }

    // The answers of coherent lanes; the other lanes are filled with the answer of the first coherent one.
    HitT<T> hits(LaneBits coherent) const {
        const int first = firstLane(coherent);
        const HitT<T> hit{nearest_, shape_[first], primitive_, (entering_ >> first & 1) != 0};
        if (laneCountOf<T> == 1 || coherent == allLanesOf<T>) return hit;
        return {filled(hit.t, coherent), hit.shape, filled(hit.primitive, coherent), hit.entering};
    }

    // Offer a shape's hits, in the lanes where `hit` holds and t is not beyond the limit. offerFace has the
    // face's number in each lane as a T.
    void offer(Truth<T> hit, const T& t, const Shape& shape, std::uint32_t primitive, Truth<T> entering) {
        consider(bits(hit & (t <= limit_)), t, shape, bits(entering), [&](int) { return primitive; });
    }
    void offerFace(Truth<T> hit, const T& t, const Shape& shape, const T& face, Truth<T> entering) {
        if constexpr (laneCountOf<T> == 1) {
            offer(hit, t, shape, static_cast<std::uint32_t>(face), entering);
        } else {
            // A conversion to a signed integer is one instruction.
            consider(bits(hit & (t <= limit_)), t, shape, bits(entering), [&](int lane) {
                return static_cast<std::uint32_t>(static_cast<std::int32_t>(laneOf(face, lane)));
            });
        }
    }

    // Offers the answer for a lane that was traced alone.
    void offer(int lane, const HitQueryT<Real>& alone) {
        tests += alone.tests;
        if (alone.found_ == 0) return;
        if (alone.contended_ != 0) contended_ |= bitOf(lane);
        const Hit hit = alone.nearest();
        consider(bitOf(lane), T(hit.t), *hit.shape, hit.entering ? bitOf(lane) : 0,
                 [&](int) { return hit.primitive; });
    }

    // The number of hits that have the t of the nearest, up to rounding, but are not at its point.
    unsigned apart() const { return apart_; }

    // Intersection tests made, for --stats.
    std::uint64_t tests = 0;
    void count() { tests += countLanes<T>(active_); }

  private:
    template <class U>
    friend class HitQueryT;

    static LaneBits bitOf(int lane) { return LaneBits{1} << lane; }

    template <class PrimitiveOf>
    void consider(LaneBits which, const T& t, const Shape& shape, LaneBits entering,
                  PrimitiveOf primitiveOf) {
        if (which == 0) return;
        if constexpr (laneCountOf<T> == 1)
            if (point_) return considerCoincident({t, &shape, primitiveOf(0), entering != 0});
        if (end_) which &= ~throughEnd(which, t, shape, primitiveOf);
        LaneBits taken = which & ~notNearer(which & found_, t);
        if (const LaneBits contended = which & ~taken & contended_; contended != 0)
            taken |= listedBefore(contended, t, shape, primitiveOf);
        if (taken == 0) return;
        const Truth<T> takes = maskOf<T>(taken);
        nearest_ = select(takes, t, nearest_);
        limit_ = select(takes, any_ ? T(-1) : min(limit_, t * T(1 + coincidenceWindow)), limit_);
        found_ |= taken;
        entering_ = (entering_ & ~taken) | (entering & taken);
        for (int lane = 0; lane < laneCountOf<T>; ++lane) {
            const bool takesThis = (taken >> lane & 1) != 0;
            shape_[lane] = takesThis ? &shape : shape_[lane];
            setLane(primitive_, lane, takesThis ? primitiveOf(lane) : laneOf(primitive_, lane));
        }
    }

    // The lanes whose hit is at the light, on a surface that the light lies on.
    template <class PrimitiveOf>
    LaneBits throughEnd(LaneBits which, const T& t, const Shape& shape, PrimitiveOf primitiveOf) const {
        LaneBits result = 0;
        forEach<T>(which & bits(t >= T(1 - coincidenceWindow)), [&](int lane) {
            if (shape.touches(*end_, Vec3(0), primitiveOf(lane))) result |= bitOf(lane);
        });
        return result;
    }

    // Of the lanes that have a hit already, those whose new hit is not nearer. Marks the contended ones.
    LaneBits notNearer(LaneBits again, const T& t) {
        if (again == 0) return 0;
        const T window = T(1 + coincidenceWindow);
        contended_ |= again & bits((t <= nearest_ * window) & (nearest_ <= t * window));
        return again & bits(!(t < nearest_));
    }

    // The lanes whose new hit has exactly the t of the nearest one, but is listed before it.
    template <class PrimitiveOf>
    [[gnu::noinline, gnu::cold]] LaneBits listedBefore(LaneBits contended, const T& t, const Shape& shape,
                                                       PrimitiveOf primitiveOf) const {
        LaneBits result = 0;
        forEach<T>(contended & bits((t <= nearest_) & (nearest_ <= t)), [&](int lane) {
            if (isListedBefore({laneOf(t, lane), &shape, primitiveOf(lane)}, nearest(lane)))
                result |= bitOf(lane);
        });
        return result;
    }

    void considerCoincident(const Hit& hit) {
        if (!hit.shape->touches(*point_, *pointError_, hit.primitive)) ++apart_;
        else if (isListedBefore(hit, nearest())) set(0, hit);
    }

    LaneBits active_, found_ = 0, contended_ = 0, entering_ = 0;
    T limit_, nearest_ = T(infinity);
    const Vec3* end_ = nullptr;
    bool any_ = false;
    const Shape* shape_[laneCountOf<T>] = {};
    Primitive<T> primitive_{};
    unsigned apart_ = 0;
    const Vec3 *point_ = nullptr, *pointError_ = nullptr;
};
using HitQuery = HitQueryT<Real>;

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
