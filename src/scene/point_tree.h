// A set of points in a k-d tree (Bentley 1975) of two dimensions, from which points can be removed. Each node
// has the box of its points: where these lie along a curve, as a polygon's corners do, their boxes are slim,
// and a query visits few of them.
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
          count_(points_.size()),
          box_(points_.size()) {
        std::iota(order_.begin(), order_.end(), 0u);
        build({0, size()});
        for (std::uint32_t i = 0; i < size(); ++i) place_[order_[i]] = i;
    }

    void remove(std::uint32_t point) {
        const std::uint32_t place = place_[point];
        Node node{0, size()};
        for (; node.middle() != place; node = place < node.middle() ? node.lower() : node.upper())
            --count_[node.middle()];
        --count_[place];
        left_[place] = false;
    }

    // Whether `test` is true of any of the points in those boxes of which `mayHold` is true. Stops at the
    // first one.
    template <class MayHold, class Test>
    bool any(MayHold mayHold, Test test) const {
        return anyBelow({0, size()}, mayHold, test);
    }

  private:
    // The points order_[begin] to order_[end - 1]. The middle one separates the others along an axis.
    struct Node {
        std::uint32_t begin, end;
        std::uint32_t middle() const { return begin + (end - begin) / 2; }
        Node lower() const { return {begin, middle()}; }
        Node upper() const { return {middle() + 1, end}; }
    };

    std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }

    PlaneBox boxOf(const Node& node) const {
        PlaneBox box{points_[order_[node.begin]], points_[order_[node.begin]]};
        for (std::uint32_t i = node.begin + 1; i < node.end; ++i) {
            const PlanePoint& point = points_[order_[i]];
            box.low = {std::min(box.low.x, point.x), std::min(box.low.y, point.y)};
            box.high = {std::max(box.high.x, point.x), std::max(box.high.y, point.y)};
        }
        return box;
    }

    void build(const Node& node) {
        if (node.begin == node.end) return;
        const PlaneBox box = boxOf(node);
        box_[node.middle()] = box;
        count_[node.middle()] = node.end - node.begin;
        const auto axis = box.high.x - box.low.x > box.high.y - box.low.y ? &PlanePoint::x : &PlanePoint::y;
        const auto at = [&](std::uint32_t i) { return order_.begin() + i; };
        std::nth_element(at(node.begin), at(node.middle()), at(node.end),
                         [&](auto a, auto b) { return points_[a].*axis < points_[b].*axis; });
        build(node.lower());
        build(node.upper());
    }

    template <class MayHold, class Test>
    bool anyBelow(const Node& node, MayHold& mayHold, Test& test) const {
        const std::uint32_t middle = node.middle();
        if (node.begin == node.end || count_[middle] == 0 || !mayHold(box_[middle])) return false;
        return (left_[middle] && test(order_[middle])) || anyBelow(node.lower(), mayHold, test) ||
               anyBelow(node.upper(), mayHold, test);
    }

    std::vector<PlanePoint> points_;
    std::vector<std::uint32_t> order_, place_;  // place_[point]: its place in order_
    std::vector<bool> left_;                    // by place: whether the point is in the set
    // Of the node with this middle: how many points of the set are in it, and the box of all that were.
    std::vector<std::uint32_t> count_;
    std::vector<PlaneBox> box_;
};

}  // namespace raytracer
