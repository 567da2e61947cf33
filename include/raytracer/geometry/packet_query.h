// HitQuery for a packet: what each of its rays is looking for, and the best it has seen. Only
// packet_tracer.cpp includes it.
#pragma once

#include <bit>

#include "raytracer/geometry/hit_query.h"
#include "raytracer/geometry/shape.h"
#include "raytracer/numerics/ray_lanes.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {

// Calls function(lane) for each.
template <class Function>
void forEach(LaneBits lanes, Function function) {
    for (; lanes != 0; lanes &= lanes - 1) function(std::countr_zero(lanes));
}

class PacketQuery {
  public:
    // For the lanes that are asked for: the nearest hit of all; or before the end, or any before it.
    explicit PacketQuery(LaneBits asked)
        : asked_(asked), limit_(select(maskOf(asked), std::numeric_limits<Real>::max(), -1)) {}
    PacketQuery(LaneBits asked, const RayEnd& end, bool any)
        : asked_(asked), limit_(select(maskOf(asked), 1 - unitRoundoff, -1)), end_(&end), any_(any) {}

    // A lane that wants no (further) hit has a limit below 0.
    const Lanes& limit() const { return limit_; }
    LaneBits asked() const { return asked_; }
    bool done() const { return any_ && found_ == asked_; }

    LaneBits found() const { return found_; }
    LaneBits contended() const { return any_ ? 0 : contended_; }
    Hit hit(int lane) const {
        return {laneOf(nearest_, lane), shape_[lane], primitive_.of[lane], (entering_ >> lane & 1) != 0};
    }
    void set(int lane, const Hit& hit) {
        const LaneBits bit = LaneBits{1} << lane;
        found_ = hit.shape ? found_ | bit : found_ & ~bit;
        setLane(nearest_, lane, hit.t);
        shape_[lane] = hit.shape;
        primitive_.of[lane] = hit.primitive;
        entering_ = hit.entering ? entering_ | bit : entering_ & ~bit;
    }

    void offer(const Mask& hit, const Lanes& t, const Shape& shape, std::uint32_t primitive,
               const Mask& entering) {
        consider(hit, t, shape, bits(entering), [&](int) { return primitive; });
    }
    void offerFace(const Mask& hit, const Lanes& t, const Shape& shape, const Lanes& face,
                   const Mask& entering) {
        alignas(32) Real faces[laneCount];
        store(face, faces);
        consider(hit, t, shape, bits(entering), [&](int lane) {
            return static_cast<std::uint32_t>(
                static_cast<std::int32_t>(faces[lane]));  // what registers can convert
        });
    }

    // The same question for one of the lanes alone: of what is left, or from the start; and its answer.
    HitQuery one(int lane) const { return {end_, any_, laneOf(limit_, lane)}; }
    HitQuery whole() const { return end_ ? HitQuery(*end_, any_) : HitQuery(); }
    void offer(int lane, const HitQuery& one) {
        const Hit& hit = one.nearest();
        tests += one.tests;
        if (!one.found()) return;
        if (one.contended()) contended_ |= LaneBits{1} << lane;
        const LaneBits bit = LaneBits{1} << lane;
        consider(maskOf(bit), hit.t, *hit.shape, hit.entering ? bit : 0, [&](int) { return hit.primitive; });
    }

    // The lanes that met the same face of the same shape as the first of these, from the same side; of a
    // mesh, any triangle.
    LaneBits alike(LaneBits lanes) const {
        const int first = std::countr_zero(lanes);
        const bool anyPrimitive = shape_[first]->kind() == ShapeKind::Mesh;
        LaneBits same = 0;
        for (int lane = 0; lane < laneCount; ++lane) {
            const bool face = (primitive_.of[lane] == primitive_.of[first]) | anyPrimitive;
            same |= static_cast<LaneBits>((shape_[lane] == shape_[first]) & face) << lane;
        }
        return lanes & same & (entering_ >> first & 1 ? entering_ : ~entering_);
    }
    HitT<Lanes> hits(LaneBits alike) const {
        const int first = std::countr_zero(alike);
        HitT<Lanes> hit{nearest_, shape_[first], primitive_, (entering_ >> first & 1) != 0};
        if (alike == allLanes) return hit;
        hit.t = select(maskOf(alike), nearest_, laneOf(nearest_, first));
        for (int lane = 0; lane < laneCount; ++lane)
            if (!(alike >> lane & 1)) hit.primitive.of[lane] = primitive_.of[first];
        return hit;
    }

    std::uint64_t tests = 0;
    void count() { tests += static_cast<std::uint64_t>(std::popcount(asked_)); }

  private:
    // As HitQuery::consider.
    template <class PrimitiveOfLane>
    void consider(Mask hit, const Lanes& t, const Shape& shape, LaneBits entering,
                  PrimitiveOfLane primitiveOf) {
        hit = hit & (t <= limit_);
        LaneBits which = bits(hit);
        if (which == 0) return;
        if (end_) {
            const LaneBits late = which & bits(t >= 1 - coincidenceWindow);
            forEach(late, [&](int lane) {
                if (shape.touches(end_->position, Vec3(0), primitiveOf(lane)))
                    which &= ~(LaneBits{1} << lane);
            });
        }
        const Lanes window = 1 + coincidenceWindow;
        contended_ |= which & found_ & bits((t <= nearest_ * window) & (nearest_ <= t * window));
        LaneBits taken = which & ~(found_ & bits(!(t < nearest_)));
        forEach(which & found_ & bits(t == nearest_), [&](int lane) {
            if (isListedBefore({0, &shape, primitiveOf(lane), false}, this->hit(lane)))
                taken |= LaneBits{1} << lane;
        });
        if (taken == 0) return;
        const Mask takes = maskOf(taken);
        nearest_ = select(takes, t, nearest_);
        limit_ = select(takes, any_ ? Lanes(-1) : min(limit_, t * window), limit_);
        found_ |= taken;
        entering_ = (entering_ & ~taken) | (entering & taken);
        for (int lane = 0; lane < laneCount; ++lane) {
            const bool takesThis = (taken >> lane & 1) != 0;
            shape_[lane] = takesThis ? &shape : shape_[lane];
            primitive_.of[lane] = takesThis ? primitiveOf(lane) : primitive_.of[lane];
        }
    }

    LaneBits asked_, found_ = 0, contended_ = 0, entering_ = 0;
    Lanes limit_, nearest_ = infinity;
    const RayEnd* end_ = nullptr;
    bool any_ = false;
    const Shape* shape_[laneCount] = {};
    LanePrimitives primitive_{};
};

}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
