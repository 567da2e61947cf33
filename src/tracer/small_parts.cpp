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
// How often a part may be halved: towards the eye, or in a picture of any size. After the usual number, a
// part that rounding alone moves (isRounded) is left out: it would never get short.
constexpr int usualHalvings = 16, mostHalvings = 32;
// There are at most about so many parts, even if all shapes and triangles are as long as the picture: where
// there are many of them, parts get longer.
constexpr double mostParts = 1 << 26;
constexpr double linesOfSolid = 7;  // at most: one inside, and two in each of three faces that are seen

// A point inside a shape, which there reaches at least from place - across to place + across.
struct Point {
    Vec3 place, across;  // in the scene's frame
    Vec2 pixel;          // where the picture shows `place`, in pixels
    Vec2 width;          // from one end to the other there, in pixels
    Real distance;       // along the camera's axis; 0 or less: behind the eye
};

class Search {
  public:
    Search(const Scene& scene, const ImageSize& size, const PixelRectangle& place)
        : camera_(scene.camera), width_(size.width), height_(size.height), place_(place) {
        double count = 0;
        for (const Shape& shape : scene.shapes)
            count += shape.type() == ShapeType::Mesh ? shape.triangles().triangleCount() : linesOfSolid;
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

    Point seen(const Vec3& place, const Vec3& across = Vec3(0)) const {
        const Vec3 onFilm = camera_.onFilm(place);
        const Vec2 width = across == Vec3(0) ? Vec2(0)
                                             : pixelOf(camera_.onFilm(place + across)) -
                                                   pixelOf(camera_.onFilm(place - across));
        return {place, across, pixelOf(onFilm), width, onFilm.z};
    }

    // Begins a shape or triangle with the distance of its farthest point. An orthographic camera shows at the
    // same pixel what is before and behind a point, so all of it counts as seen if a part of it is in front.
    void begin(Real farthest) { behind_ = !camera_.isPerspective() && farthest > 0 ? -infinity : 0; }

    Real distanceOf(const Vec3& place) const { return camera_.onFilm(place).z; }

    Vec2 pixelOf(const Vec3& onFilm) const {
        return camera_.pixelOf(Vec2(onFilm), static_cast<Real>(width_), static_cast<Real>(height_));
    }

    // Whether what lies between these points is seen as the segment between their pixels.
    bool isSegment(const Point& a, const Point& b) const {
        return !camera_.isPerspective() || (a.distance > 0 && b.distance > 0);
    }

    // In pixels, and in the scene. Where one end is behind the eye, the first is infinite.
    std::pair<Real, Real> lengthOf(const Point& a, const Point& b) const {
        return {isSegment(a, b) ? glm::length(b.pixel - a.pixel) : infinity, glm::length(b.place - a.place)};
    }

    // Two segments inside each triangle: from the ends of the side that looks longest, where the corners are
    // sharp, to the centroid.
    void addMesh(const Shape& shape) {
        for (std::uint32_t i = 0; i < shape.triangles().triangleCount(); ++i) {
            auto corners = shape.triangles().corners<Real>(i);
            for (Vec3& corner : corners) corner = shape.transform().pointToWorld(corner);
            begin(max(max(distanceOf(corners[0]), distanceOf(corners[1])), distanceOf(corners[2])));
            Point a = seen(corners[0]), b = seen(corners[1]), c = seen(corners[2]);
            if (lengthOf(b, c) > lengthOf(a, b)) std::swap(a, c);
            if (lengthOf(c, a) > lengthOf(a, b)) std::swap(b, c);
            const Vec3 centroid = (a.place + b.place + c.place) / Real(3);
            if (lengthOf(a, b).first <= longest_) {
                take(seen(centroid));
                continue;
            }
            // The chords through the centroid that are parallel to the sides opposite to a and to b.
            addTip(a, seen(centroid, (c.place - b.place) / Real(3)));
            addTip(b, seen(centroid, (c.place - a.place) / Real(3)));
        }
    }

    // The two axes of the solid's box that look longest, and those of its flat faces that are seen from
    // outside. A plane has none: its numbers are infinite or NaN.
    void addSolid(const Shape& shape) {
        Vec3 middle, half[3];
        for (int axis = 0; axis < 3; ++axis) {
            const Real high = support(shape.type(), nullptr, unit(axis)),
                       low = -support(shape.type(), nullptr, -unit(axis));
            middle[axis] = (low + high) / 2;
            half[axis] = shape.transform().linear()[axis] * ((high - low) / 2);
        }
        middle = shape.transform().pointToWorld(middle);
        Real farthest = distanceOf(middle);
        for (const Vec3& h : half) farthest += abs(distanceOf(middle + h) - distanceOf(middle));
        begin(farthest);
        for (int axis = 0; axis < 3; ++axis)
            for (const Real side : {Real(-1), Real(1)})
                if (!isTurnedAway(shape, middle + side * half[axis], side * unit(axis)))
                    addFace(shape.type(), middle + side * half[axis], side * unit(axis), (axis + 1) % 3,
                            (axis + 2) % 3, half);
        orderByLength(middle, half[0], half[1]);
        orderByLength(middle, half[0], half[2]);
        addRhombus(middle, half[1], half[2]);
    }

    // Whether the plane through a point of the scene, with this normal in object space, is seen from behind
    // or from its edge.
    bool isTurnedAway(const Shape& shape, const Vec3& point, const Vec3& normal) const {
        const Vec3 view = shape.transform().toObject(Ray{point, camera_.viewOf(point), {}}).direction;
        return glm::dot(view, normal) >= 0;
    }

    // Adds a side of the box, unless the solid touches that only in a point or in a line.
    void addFace(ShapeType type, const Vec3& middle, const Vec3& normal, int next, int last,
                 const Vec3* half) {
        const auto reach = [&](const Vec3& along) { return faceReach(type, normal, along); };
        if (!(min(reach(unit(next)), reach(unit(last))) > Real(0.5))) return;
        addRhombus(middle, half[next], half[last]);
        // Seen almost from its edge, it has sharp ends in the direction of a diagonal.
        const Real diagonal = reach(unit(next) + unit(last)) / 2;
        addRhombus(middle, diagonal * (half[next] + half[last]), diagonal * (half[next] - half[last]));
    }

    static Vec3 unit(int axis) {
        Vec3 n(0);
        n[axis] = 1;
        return n;
    }

    // How far the solid's farthest points in the direction n reach along this vector: the slope of the
    // support function (Rockafellar, Convex Analysis, Corollary 23.5.3). A flat face reaches 1, other points
    // nowhere.
    static Real faceReach(ShapeType type, const Vec3& n, const Vec3& along) {
        constexpr Real step = 1.0 / 1024;
        return (support(type, nullptr, n + step * along) - support(type, nullptr, n)) / step;
    }

    // Where the axes pass the eye, the longer one is the one that is longer in the scene.
    void orderByLength(const Vec3& middle, Vec3& shorter, Vec3& longer) const {
        const auto length = [&](const Vec3& h) { return lengthOf(seen(middle - h), seen(middle + h)); };
        if (length(shorter) > length(longer)) std::swap(shorter, longer);
    }

    // A rhombus with these half diagonals, which lies in a shape.
    void addRhombus(const Vec3& middle, Vec3 across, Vec3 along) {
        orderByLength(middle, across, along);
        const Point center = seen(middle, across);
        addTip(seen(middle - along), center);
        addTip(seen(middle + along), center);
    }

    // A tip that is at least as wide as long is not sharp: the pixels beside it show it.
    void addTip(const Point& tip, const Point& base) {
        const Vec2 along = base.pixel - tip.pixel;
        const bool isBlunt = isSegment(tip, base) && isWider(base, along, max(widest, glm::length(along)));
        if (!isBlunt) add(tip, base, 0);
    }

    // The points of a segment where its shape is thin.
    void add(const Point& from, const Point& to, int halvings) {
        const auto [nearest, farthest] = std::minmax(from.distance, to.distance);
        if (!(farthest > behind_)) return;
        const Point middle = seen((from.place + to.place) / Real(2), (from.across + to.across) / Real(2));
        if (isSegment(from, to)) {
            if (isBeside(from.pixel, to.pixel)) return;
            const Vec2 along = to.pixel - from.pixel;
            if (isWider(from, along, widest) && isWider(to, along, widest)) return;
            if (nearest > behind_ && glm::length(along) <= longest_) return take(middle);
            if (halvings > usualHalvings && isRounded(middle)) return;
        }
        if (halvings >= mostHalvings) return;
        add(from, middle, halvings + 1);
        add(middle, to, halvings + 1);
    }

    static bool isWider(const Point& point, const Vec2& along, Real width) {
        return !(std::abs(along.x * point.width.y - along.y * point.width.x) <= width * glm::length(along));
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
        const bool isInside = point.distance > behind_ && pixel.x >= place_.x0 && pixel.x < place_.x1 &&
                              pixel.y >= place_.y0 && pixel.y < place_.y1;
        if (!isInside) return;
        if (parts_.size() == parts_.capacity()) makeRoom();
        parts_.push_back({pixel, point.distance > 0 ? point.distance : infinity});
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
    Real behind_ = 0;  // the least distance that is seen is above this
    std::vector<Part> parts_;
};

}  // namespace

std::vector<glm::dvec2> smallParts(const Scene& scene, const ImageSize& size, const PixelRectangle& place) {
    return Search(scene, size, place).points();
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
