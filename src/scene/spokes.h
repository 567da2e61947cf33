// The sides of a polygon that begin or end at one point.
#pragma once

#include <map>

#include "plane_polygon.h"

namespace raytracer {

// Sorted by their directions, counter-clockwise, so that the sides within an angle are found at once. Sides
// between the same two points are one side with a count.
class Spokes {
  public:
    explicit Spokes(const PlanePoint& hub) : hub_(hub), sides_(ByDirection{hub}) {}

    const PlanePoint& hub() const { return hub_; }
    bool isEmpty() const { return sides_.empty(); }
    void add(const PlanePoint& end) { ++sides_[end]; }
    void remove(const PlanePoint& end) {
        const auto side = sides_.find(end);
        if (--side->second == 0) sides_.erase(side);
    }

    // Whether `test` is true of any end. Stops at the first one.
    template <class Test>
    bool any(Test test) const {
        for (const auto& [end, count] : sides_)
            if (test(end)) return true;
        return false;
    }

    // The same for the ends that lie, seen from the hub, between `from` and `to`. `to` must be left of
    // `from`.
    template <class Test>
    bool anyBetween(const PlanePoint& from, const PlanePoint& to, Test test) const {
        auto side = sides_.lower_bound(from);
        for (std::size_t i = 0; i < sides_.size(); ++i, ++side) {
            if (side == sides_.end()) side = sides_.begin();
            const PlanePoint& end = side->first;
            if (sideOf(hub_, from, end) < 0 || sideOf(hub_, end, to) < 0) return false;
            if (test(end)) return true;
        }
        return false;
    }

  private:
    struct ByDirection {
        PlanePoint hub;

        int half(const PlanePoint& end) const {
            if (end == hub) return 0;
            return end.y > hub.y || (end.y == hub.y && end.x > hub.x) ? 1 : 2;
        }
        bool operator()(const PlanePoint& a, const PlanePoint& b) const {
            if (half(a) != half(b)) return half(a) < half(b);
            const int side = sideOf(hub, a, b);
            return side != 0 ? side > 0 : isBefore(a, b);
        }
    };

    PlanePoint hub_;
    std::map<PlanePoint, std::uint32_t, ByDirection> sides_;  // the number of sides with this end
};

}  // namespace raytracer
