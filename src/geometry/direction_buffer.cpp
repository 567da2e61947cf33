#include "raytracer/geometry/direction_buffer.h"

#include <algorithm>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

constexpr int resolution = DirectionBuffer::resolution;

Vec3 unit(int axis) {
    Vec3 result(0);
    result[axis] = 1;
    return result;
}

struct Range {
    Real low, high;
};

// All places at which a ray may hit a shape, seen from a point. Of a mesh it is the mesh's box.
class Outline {
  public:
    Outline(const BoxedShape& boxed, const Vec3& point, Real slack) : shape_(boxed.shape) {
        for (int axis = 0; axis < 3; ++axis) {
            low_[axis] = static_cast<Real>(boxed.box.low[axis]) - point[axis] - slack;
            high_[axis] = static_cast<Real>(boxed.box.high[axis]) - point[axis] + slack;
            nearest_ = std::max({nearest_, low_[axis], -high_[axis]});
        }
        nearest_ *= 1 - Real(0x1p-18);  // more than the roundings above and those of a ray's t
        if (shape_->type() == ShapeType::Mesh) {
            center_ = (low_ + high_) / Real(2);
            margin_ = (high_ - low_) / Real(2);
        } else {
            center_ = shape_->transform().translation() - point;
            margin_ = shape_->margin() + Vec3(slack);
        }
    }

    const Shape* shape() const { return shape_; }
    Real nearest() const { return nearest_; }

    // Whether the shape may be seen in a direction d with low <= n . d / w . d <= high and w . d > 0. If not,
    // a plane through the point separates the shape from these directions.
    bool isSeen(const Vec3& n, const Range& range, const Vec3& w) const {
        return support(n - range.low * w) >= 0 && support(range.high * w - n) >= 0;
    }

    // What d[side] / |d[axis]| is at most and at least, from -1 to 1, on the face of the cube where d[axis]
    // has this sign; low > high where the shape is not seen there.
    Range range(int side, int axis, bool negative) const {
        const Real near = negative ? -high_[axis] : low_[axis], far = negative ? -low_[axis] : high_[axis];
        if (far <= 0) return {1, -1};
        if (near <= 0) return {-1, 1};
        return {std::max(Real(-1), low_[side] / (low_[side] < 0 ? near : far)),
                std::min(Real(1), high_[side] / (high_[side] > 0 ? near : far))};
    }

  private:
    // The largest n . p of all places p.
    Real support(const Vec3& n) const {
        Real most = glm::dot(n, center_) + glm::dot(abs(n), margin_);
        if (shape_->type() != ShapeType::Mesh)
            most += raytracer::support(shape_->type(), nullptr, n * shape_->transform().linear());
        return most;
    }

    const Shape* shape_;
    Vec3 low_, high_, center_, margin_;
    Real nearest_ = 0;
};

// By how much the place in a grid may be rounded, in cells.
constexpr Real rounding = Real(1) / 32;

// A face of the cube, and the part of it that is divided into a grid.
class Window {
  public:
    Window(int axis, bool negative, std::span<const Outline> outlines)
        : axis_(axis), across_(axis == 0), along_(axis == 2 ? 1 : 2), negative_(negative) {
        for (const Outline& outline : outlines) {
            const Range columns = outline.range(across_, axis, negative),
                        rows = outline.range(along_, axis, negative);
            if (columns.low > columns.high || rows.low > rows.high) continue;
            include(columns_, columns);
            include(rows_, rows);
        }
    }

    bool empty() const { return columns_.low > columns_.high; }

    DirectionBuffer::Face face(std::size_t cells) const {
        DirectionBuffer::Face face{.axis = axis_, .across = across_, .along = along_, .cells = cells};
        const auto fit = [](const Range& range, Real& scale, Real& offset) {
            constexpr Real narrowest = Real(0x1p-10);  // of a narrower one, float would not tell the cells
            scale = (resolution - 3) / std::max(range.high - range.low, narrowest);
            offset = Real(1.5) - scale * range.low;
        };
        fit(columns_, face.columns, face.firstColumn);
        fit(rows_, face.rows, face.firstRow);
        return face;
    }

    // Sets the bit in the cells that the outline may be seen through: those whose column, row and diagonals
    // it is seen through.
    void mark(const DirectionBuffer::Face& face, const Outline& outline, std::uint64_t bit,
              std::uint64_t* cells) const {
        const Vec3 w = negative_ ? -unit(axis_) : unit(axis_), column = face.columns * unit(across_),
                   row = face.rows * unit(along_);
        struct Strips {
            int first, last;
        };
        // Without the strips at both ends that the outline is not seen through. It may be seen through
        // those between. In strip k, offset + n . d / w . d is from k to k + width.
        const auto seen = [&](Strips strips, const Vec3& n, Real offset, int width) {
            const auto isSeenThrough = [&](int k) {
                const Range range{Real(k) - offset - rounding, Real(k + width) - offset + rounding};
                return outline.isSeen(n, range, w);
            };
            while (strips.first <= strips.last && !isSeenThrough(strips.first)) ++strips.first;
            while (strips.first < strips.last && !isSeenThrough(strips.last)) --strips.last;
            return strips;
        };
        const auto sideBySide = [&](const Vec3& n, int side, Real scale, Real offset) {
            const Range range = outline.range(side, axis_, negative_);
            if (range.low > range.high) return Strips{1, 0};
            const auto strip = [&](Real place) { return static_cast<int>(place * scale + offset); };
            return seen({std::max(strip(range.low) - 1, 1), std::min(strip(range.high) + 1, resolution - 2)},
                        n, offset, 1);
        };
        const Strips columns = sideBySide(column, across_, face.columns, face.firstColumn),
                     rows = sideBySide(row, along_, face.rows, face.firstRow);
        if (columns.first > columns.last || rows.first > rows.last) return;
        const Strips falling = seen({columns.first + rows.first, columns.last + rows.last}, column + row,
                                    face.firstColumn + face.firstRow, 2),
                     rising = seen({columns.first - rows.last, columns.last - rows.first}, column - row,
                                   face.firstColumn - face.firstRow + 1, 2);
        for (int y = rows.first; y <= rows.last; ++y) {
            const int last = std::min({columns.last, falling.last - y, rising.last + y});
            for (int x = std::max({columns.first, falling.first - y, rising.first + y}); x <= last; ++x)
                cells[y * resolution + x] |= bit;
        }
    }

  private:
    static void include(Range& range, const Range& other) {
        range = {std::min(range.low, other.low), std::max(range.high, other.high)};
    }

    int axis_, across_, along_;
    bool negative_;
    Range columns_{1, -1}, rows_{1, -1};
};

}  // namespace

DirectionBuffer::DirectionBuffer(const Vec3& point, std::span<const BoxedShape> boxed,
                                 std::span<const Shape* const> unbounded, Real reach, Real slack)
    : reach_(reach) {
    std::vector<Outline> outlines;
    for (const BoxedShape& one : boxed) outlines.emplace_back(one, point, slack);
    std::stable_sort(outlines.begin(), outlines.end(),
                     [](const Outline& a, const Outline& b) { return a.nearest() < b.nearest(); });
    for (const Shape* shape : unbounded) candidates_.push_back({-infinity, shape});
    for (const Outline& outline : outlines) candidates_.push_back({outline.nearest(), outline.shape()});
    const auto inFront =
        std::find_if(outlines.begin(), outlines.end(), [](const Outline& o) { return o.nearest() > 0; });
    const std::size_t around = unbounded.size() + static_cast<std::size_t>(inFront - outlines.begin());
    outlines.erase(outlines.begin(), inFront);
    everywhere_ = around == 0 ? 0 : ~std::uint64_t{0} >> (mostShapes - around);

    cells_.reserve(1 + 6 * resolution * resolution);  // moved never; pages of unused faces stay untouched
    for (int number = 0; number < 6; ++number) {
        const Window window(number / 2, number % 2 == 1, outlines);
        if (window.empty()) continue;
        const std::size_t first = cells_.size();
        cells_.resize(first + resolution * resolution);
        faces_[number] = window.face(first);
        for (std::size_t i = 0; i < outlines.size(); ++i)
            window.mark(faces_[number], outlines[i], std::uint64_t{1} << (around + i), &cells_[first]);
    }
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
