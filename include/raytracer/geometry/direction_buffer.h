// Which shapes lie in each direction from a point: for the rays from an eye (Weghorst, Hooper and Greenberg,
// Improved Computational Methods for Ray Tracing, ACM Transactions on Graphics 3(1), 1984) and the rays to a
// light (Haines and Greenberg, The Light Buffer, IEEE Computer Graphics and Applications 6(9), 1986).
//
// A cube around the point has a grid on each face. A cell of the grid has a bit for each shape that may be
// seen through it. A packet meets the shapes of its rays' cells, the nearest first, and needs no tree. As a
// tree, the buffer may only discard: a picture is the same with it and without it.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "raytracer/geometry/shapes.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct BoxedShape {
    const Shape* shape;
    FloatBox box;
};

class DirectionBuffer {
  public:
    static constexpr std::size_t mostShapes = 64;

    // Without shapes: not to be used.
    DirectionBuffer() = default;

    // Of at most mostShapes shapes, with their boxes and without. The rays begin or end at the point, and
    // have directions whose components add up to at most `reach`, which is finite. For them `slack` is as
    // BvhRay::slack. The point and the boxes are within widestRange.
    DirectionBuffer(const Vec3& point, std::span<const BoxedShape> boxed,
                    std::span<const Shape* const> unbounded, Real reach, Real slack);

    bool empty() const { return candidates_.empty(); }

    // As ShapeTree::meet: for rays from the point, or for a query that ends there.
    template <class T>
    void meet(const RayT<T>& ray, HitQueryT<T>& query) const;

    // A grid has this many columns and rows. Through those at its border no shape is seen.
    static constexpr int resolution = 32;

    // A face of the cube, and its grid. The column of a direction d from the point is
    // columns * d[across] / |d[axis]| + firstColumn, and its row is found likewise.
    struct Face {
        Real columns = 0, firstColumn = 0, rows = 0, firstRow = 0;
        int axis = 0, across = 0, along = 0;
        std::size_t cells = 0;  // the place of its first cell
    };

  private:
    // The bits of the shapes that rays may hit which have these directions from the point, and the largest
    // component of each direction (or a bound on it).
    template <class T>
    std::uint64_t along(const Vec3T<T>& direction, T& depth) const;

    // The shape of a bit. Of the difference between any point of the shape and this point, the largest
    // component is at least `nearest`.
    struct Candidate {
        Real nearest;
        const Shape* shape;
    };
    std::vector<Candidate> candidates_;  // the nearest first
    std::uint64_t everywhere_ = 0;       // the shapes without a box, and those around the point
    Face faces_[6];
    std::vector<std::uint64_t> cells_{0};  // row by row; a face without shapes has the first cell only
    Real reach_ = 0;
};

template <class T>
void DirectionBuffer::meet(const RayT<T>& ray, HitQueryT<T>& query) const {
    const bool toPoint = query.endsAtLight();
    T depth;
    std::uint64_t left = along(toPoint ? -ray.direction : ray.direction, depth);
    for (; left != 0 && !query.done(); left &= left - 1) {
        const Candidate& candidate = candidates_[static_cast<std::size_t>(std::countr_zero(left))];
        if (!any(T(candidate.nearest) <= (toPoint ? depth : query.limit() * depth))) return;
        candidate.shape->meet(ray, query);
    }
}

template <class T>
std::uint64_t DirectionBuffer::along(const Vec3T<T>& direction, T& depth) const {
    const Vec3T<T> size = abs(direction);
    depth = max(size.x, max(size.y, size.z));
    constexpr Real least = std::numeric_limits<Real>::min() / unitRoundoff;  // its inverse is finite
    if (!all((depth >= T(least)) & (size.x + size.y + size.z <= T(reach_)))) {
        depth = T(std::numeric_limits<Real>::max());
        return ~std::uint64_t{0} >> (mostShapes - candidates_.size());
    }
    const Vec3 first = laneOf(size, 0);
    const int axis = first.x >= first.y ? (first.x >= first.z ? 0 : 2) : (first.y >= first.z ? 1 : 2);
    const LaneBits negative = bits(direction[axis] < T(0));
    const bool together = all(size[axis] == depth) && (negative == 0 || negative == allLanesOf<T>);
    std::uint64_t seen = everywhere_;
    if constexpr (laneCountOf<T> != 1)
        if (!together) {
            Real ignored;
            for (int lane = 0; lane < laneCountOf<T>; ++lane) seen |= along(laneOf(direction, lane), ignored);
            return seen;
        }
    const Face& face = faces_[2 * axis + (negative != 0)];
    const T inverse = T(1) / depth;
    const auto place = [&](int side, Real scale, Real offset) {
        return truncated(clamp(direction[side] * inverse * T(scale) + T(offset), 0, resolution - 1));
    };
    const auto columns = place(face.across, face.columns, face.firstColumn),
               rows = place(face.along, face.rows, face.firstRow);
    const std::uint64_t* const cells = &cells_[face.cells];
    for (std::size_t lane = 0; lane < columns.size(); ++lane)
        seen |= cells[rows[lane] * resolution + columns[lane]];
    return seen;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
