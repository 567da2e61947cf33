// A set of points in a k-d tree (Bentley 1975) of two dimensions, from which points can be removed.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "plane_polygon.h"

namespace raytracer {

struct PlaneBox {
    PlanePoint low, high;
};

class PointTree {
  public:
    explicit PointTree(std::vector<PlanePoint> points)
        : points_(std::move(points)),
          order_(points_.size()),
          place_(points_.size()),
          left_(points_.size(), true),
          count_(points_.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        build({0, size(), false});
        for (std::uint32_t i = 0; i < size(); ++i) place_[order_[i]] = i;
    }

    void remove(std::uint32_t point) {
        const std::uint32_t place = place_[point];
        Node node{0, size(), false};
        for (; node.middle() != place; node = place < node.middle() ? node.lower() : node.upper())
            --count_[node.middle()];
        --count_[place];
        left_[place] = false;
    }

    // Whether `test` is true of any of the points in those boxes of which `mayHold` is true. Stops at the
    // first one.
    template <class MayHold, class Test>
    bool any(MayHold mayHold, Test test) const {
        constexpr std::int64_t beyond = std::int64_t{1} << 52;
        return anyBelow({0, size(), false}, {{-beyond, -beyond}, {beyond, beyond}}, mayHold, test);
    }

  private:
    // The points order_[begin] to order_[end - 1]. The middle one separates the others along an axis.
    struct Node {
        std::uint32_t begin, end;
        bool byY;
        std::uint32_t middle() const { return begin + (end - begin) / 2; }
        Node lower() const { return {begin, middle(), !byY}; }
        Node upper() const { return {middle() + 1, end, !byY}; }
    };

    std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
    static std::int64_t along(const PlanePoint& point, const Node& node) {
        return node.byY ? point.y : point.x;
    }

    void build(const Node& node) {
        if (node.begin == node.end) return;
        count_[node.middle()] = node.end - node.begin;
        const auto at = [&](std::uint32_t i) { return order_.begin() + i; };
        std::nth_element(at(node.begin), at(node.middle()), at(node.end),
                         [&](auto a, auto b) { return along(points_[a], node) < along(points_[b], node); });
        build(node.lower());
        build(node.upper());
    }

    template <class MayHold, class Test>
    bool anyBelow(const Node& node, const PlaneBox& box, MayHold& mayHold, Test& test) const {
        if (node.begin == node.end || count_[node.middle()] == 0 || !mayHold(box)) return false;
        const std::uint32_t point = order_[node.middle()];
        if (left_[node.middle()] && test(point)) return true;
        PlaneBox lower = box, upper = box;
        (node.byY ? lower.high.y : lower.high.x) = along(points_[point], node);
        (node.byY ? upper.low.y : upper.low.x) = along(points_[point], node);
        return anyBelow(node.lower(), lower, mayHold, test) || anyBelow(node.upper(), upper, mayHold, test);
    }

    std::vector<PlanePoint> points_;
    std::vector<std::uint32_t> order_, place_;  // place_[point]: its place in order_
    std::vector<bool> left_;                    // by place: whether the point is in the set
    std::vector<std::uint32_t> count_;          // how many points of the set are in the node with this middle
};

}  // namespace raytracer
