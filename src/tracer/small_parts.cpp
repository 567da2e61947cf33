#include "small_parts.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "raytracer/geometry/shapes.h"
#include "raytracer/util/memory.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// Pixels. What is wider contains a centre.
constexpr Real widest = 2;
// Pixels. A longer part is halved, so that each pixel along a wire, or its neighbour, gets a point.
constexpr Real longest = Real(1.5);
// How often a part may be halved: towards the eye, or in a picture of any size. After the usual number it is
// looked whether rounding alone moves it by pixels, so that it never gets short.
constexpr int usualHalvings = 16, mostHalvings = 32;
// There are at most about so many parts, even if all shapes and triangles are as long as the picture: where
// there are many of them, parts get longer.
constexpr double mostParts = 1 << 26;

struct Point {
    Vec3 place;     // in the scene's frame
    Vec2 pixel;     // where the picture shows it, in pixels
    Real distance;  // along the camera's axis; 0 or less: behind the eye
};

class Search {
  public:
    Search(const Scene& scene, const ImageSize& size, const PixelRectangle& place)
        : camera_(scene.camera), width_(size.width), height_(size.height), place_(place) {
        double count = 0;
        for (const Shape& shape : scene.shapes)
            count += shape.type() == ShapeType::Mesh ? shape.triangles().triangleCount() : 1;
        longest_ = max(longest, static_cast<Real>(count * std::hypot(size.width, size.height) / mostParts));
        for (const Shape& shape : scene.shapes)
            if (shape.type() == ShapeType::Mesh) addMesh(shape);
            else addSolid(shape);
    }

    std::vector<glm::dvec2> points() {
        keepNearest();
        requireMemory(parts_.size() * sizeof(glm::dvec2));
        std::vector<glm::dvec2> points;
        points.reserve(parts_.size());
        for (const Part& part : parts_) points.push_back(part.pixel);
        return points;
    }

  private:
    struct Part {
        glm::dvec2 pixel;
        Real distance;

        std::pair<int, int> place() const { return {static_cast<int>(pixel.y), static_cast<int>(pixel.x)}; }
    };

    Point seen(const Vec3& place) const {
        const Vec3 onFilm = camera_.onFilm(place);
        return {place, camera_.pixelOf(Vec2(onFilm), static_cast<Real>(width_), static_cast<Real>(height_)),
                onFilm.z};
    }

    // In pixels, and in the scene. Where one end is behind the eye, the first is infinite.
    static std::pair<Real, Real> lengthOf(const Point& a, const Point& b) {
        const bool isSeen = a.distance > 0 && b.distance > 0;
        return {isSeen ? glm::length(b.pixel - a.pixel) : infinity, glm::length(b.place - a.place)};
    }

    // Two segments inside each triangle: from the ends of the side that looks longest to the centroid.
    void addMesh(const Shape& shape) {
        const auto seenCorner = [&](const Vec3& p) { return seen(shape.transform().pointToWorld(p)); };
        for (std::uint32_t i = 0; i < shape.triangles().triangleCount(); ++i) {
            const auto corners = shape.triangles().corners<Real>(i);
            Point a = seenCorner(corners[0]), b = seenCorner(corners[1]), c = seenCorner(corners[2]);
            if (lengthOf(b, c) > lengthOf(a, b)) std::swap(a, c);
            if (lengthOf(c, a) > lengthOf(a, b)) std::swap(b, c);
            const Point middle = seen((a.place + b.place + c.place) / Real(3));
            if (lengthOf(a, b).first <= longest_) {
                take(middle);
                continue;
            }
            const Vec3 side = b.place - a.place, other = c.place - a.place;
            const Vec3 height = other - side * (glm::dot(other, side) / glm::dot(side, side));
            add(a, middle, height / Real(2), 0);
            add(middle, b, height / Real(2), 0);
        }
    }

    // The axis of the solid's box that looks longest. If several axes pass the eye, it is the one that is
    // longest in the scene. A plate that is seen from its edge has two long axes, so its diagonal is longer
    // than both. A plane has none: its numbers are infinite or NaN.
    void addSolid(const Shape& shape) {
        Vec3 middle, half[3];
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 n(0);
            n[axis] = 1;
            const Real high = support(shape.type(), nullptr, n), low = -support(shape.type(), nullptr, -n);
            middle[axis] = (low + high) / 2;
            half[axis] = shape.transform().linear()[axis] * ((high - low) / 2);
        }
        middle = shape.transform().pointToWorld(middle);
        const auto length = [&](const Vec3& h) { return lengthOf(seen(middle - h), seen(middle + h)); };
        const auto order = [&](Vec3& a, Vec3& b) {
            if (length(a) > length(b)) std::swap(a, b);
        };
        order(half[0], half[1]);
        order(half[1], half[2]);
        order(half[0], half[1]);
        const auto addAlong = [&](const Vec3& h) { add(seen(middle - h), seen(middle + h), half[1], 0); };
        addAlong(half[2]);
        if (!(length(half[1]).first > widest)) return;
        const Vec3 sum = half[2] + half[1], difference = half[2] - half[1];
        addAlong(length(sum) > length(difference) ? sum : difference);
    }

    // A segment inside a shape that is as wide as from -across to across around each of its points.
    void add(const Point& from, const Point& to, const Vec3& across, int halvings) {
        const auto [nearest, farthest] = std::minmax(from.distance, to.distance);
        if (!(farthest > 0)) return;
        const bool isInFront = nearest > 0;
        if (isInFront && isBeside(from.pixel, to.pixel)) return;
        const Point middle = seen((from.place + to.place) / Real(2));
        if (isInFront) {
            const Vec2 along = to.pixel - from.pixel,
                       width = seen(middle.place + across).pixel - seen(middle.place - across).pixel;
            const Real length = glm::length(along);
            if (!(std::abs(along.x * width.y - along.y * width.x) <= widest * length)) return;
            if (length <= longest_) return take(middle);
            if (halvings > usualHalvings && isRounded(middle)) return;
        }
        if (halvings >= mostHalvings) return;
        add(from, middle, across, halvings + 1);
        add(middle, to, across, halvings + 1);
    }

    bool isRounded(const Point& point) const {
        const Real shift = 4 * unitRoundoff * maxComponent(abs(point.place));
        const Point beside = seen(point.place + Vec3(shift, -shift, shift));
        return !(glm::length(beside.pixel - point.pixel) < longest / 4);
    }

    bool isBeside(const Vec2& a, const Vec2& b) const {
        return max(a.x, b.x) < static_cast<Real>(place_.x0) || min(a.x, b.x) > static_cast<Real>(place_.x1) ||
               max(a.y, b.y) < static_cast<Real>(place_.y0) || min(a.y, b.y) > static_cast<Real>(place_.y1);
    }

    void take(const Point& point) {
        const glm::dvec2 pixel(point.pixel);
        const bool isInside = point.distance > 0 && pixel.x >= place_.x0 && pixel.x < place_.x1 &&
                              pixel.y >= place_.y0 && pixel.y < place_.y1;
        if (!isInside) return;
        if (parts_.size() == parts_.capacity()) makeRoom();
        parts_.push_back({pixel, point.distance});
    }

    void makeRoom() {
        keepNearest();
        const std::size_t room = std::max<std::size_t>(1024, 2 * parts_.size());
        if (room <= parts_.capacity()) return;
        requireMemory(room * sizeof(Part));
        parts_.reserve(room);
    }

    static void requireMemory(std::size_t bytes) {
        raytracer::requireMemory({}, "what is small in the picture", static_cast<double>(bytes));
    }

    // Of each pixel's parts only the nearest, row by row.
    void keepNearest() {
        std::ranges::sort(parts_, {}, [](const Part& part) {
            return std::tuple(part.place(), part.distance, part.pixel.x, part.pixel.y);
        });
        const auto isSamePlace = [](const Part& a, const Part& b) { return a.place() == b.place(); };
        parts_.erase(std::unique(parts_.begin(), parts_.end(), isSamePlace), parts_.end());
    }

    const Camera& camera_;
    int width_, height_;
    PixelRectangle place_;
    Real longest_;
    std::vector<Part> parts_;
};

}  // namespace

std::vector<glm::dvec2> smallParts(const Scene& scene, const ImageSize& size, const PixelRectangle& place) {
    return Search(scene, size, place).points();
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
