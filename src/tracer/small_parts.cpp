#include "small_parts.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "raytracer/geometry/shapes.h"
#include "raytracer/util/memory.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// Pixels. What is wider contains a centre.
constexpr Real widest = 2;
// Pixels. A longer part is halved, so that each pixel along a wire gets a point.
constexpr Real longest = Real(1.5);
// A part that is partly behind the eye is halved so often at most, and one before the eye.
constexpr int mostHalvings = 6, mostHalvingsInFront = 32;
// More would take longer than they are worth: a second or two.
constexpr std::size_t mostParts = std::size_t{1} << 24;

struct Point {
    Vec3 place;     // in the scene's frame
    Vec2 pixel;     // where the picture shows it, in pixels
    Real distance;  // along the camera's axis; 0 or less: behind the eye
};

class Search {
  public:
    Search(const Scene& scene, const ImageSize& size)
        : camera_(scene.camera),
          width_(static_cast<Real>(size.width)),
          height_(static_cast<Real>(size.height)) {
        for (const Shape& shape : scene.shapes)
            if (shape.type() == ShapeType::Mesh) addMesh(shape);
            else addSolid(shape);
    }

    std::vector<ExtraSample> samples() {
        keepNearest();
        std::vector<ExtraSample> samples;
        for (const Part& part : parts_) samples.push_back({part.pixel});
        return samples;
    }

  private:
    struct Part {
        int row, column;
        Real distance;
        glm::dvec2 pixel;
    };

    Point seen(const Vec3& place) const {
        const Vec3 onFilm = camera_.onFilm(place);
        return {place, camera_.pixelOf(Vec2(onFilm), width_, height_), onFilm.z};
    }

    // In pixels; where one end is behind the eye, infinite.
    static Real lengthOf(const Point& a, const Point& b) {
        return a.distance > 0 && b.distance > 0 ? glm::length(b.pixel - a.pixel) : infinity;
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
            if (lengthOf(a, b) <= longest) {
                take(middle);
                continue;
            }
            const Vec3 across = (c.place - (a.place + b.place) / Real(2)) / Real(2);
            add(a, middle, across, 0);
            add(middle, b, across, 0);
        }
    }

    // The axis of the solid's box that looks longest. A plane has none: its numbers are infinite or NaN.
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
        std::ranges::sort(half, {},
                          [&](const Vec3& h) { return lengthOf(seen(middle - h), seen(middle + h)); });
        add(seen(middle - half[2]), seen(middle + half[2]), half[1], 0);
    }

    // A segment inside a shape that is as wide as from -across to across around each of its points.
    void add(const Point& from, const Point& to, const Vec3& across, int halvings) {
        const auto [nearest, farthest] = std::minmax(from.distance, to.distance);
        if (!(farthest > 0) || taken_ == mostParts) return;
        const bool isInFront = nearest > 0;
        if (isInFront && isBeside(from.pixel, to.pixel)) return;
        const Point middle = seen((from.place + to.place) / Real(2));
        if (isInFront) {
            const Vec2 along = to.pixel - from.pixel,
                       width = seen(middle.place + across).pixel - seen(middle.place - across).pixel;
            const Real length = glm::length(along);
            if (!(std::abs(along.x * width.y - along.y * width.x) <= widest * length)) return;
            if (length <= longest) return take(middle);
            if (halvings == mostHalvingsInFront) return;
        } else if (halvings == mostHalvings) {
            return;
        }
        add(from, middle, across, halvings + 1);
        add(middle, to, across, halvings + 1);
    }

    bool isBeside(const Vec2& a, const Vec2& b) const {
        return max(a.x, b.x) < 0 || min(a.x, b.x) > width_ || max(a.y, b.y) < 0 || min(a.y, b.y) > height_;
    }

    void take(const Point& point) {
        const glm::dvec2 pixel(point.pixel);
        const bool isInside = point.distance > 0 && pixel.x >= 0 && pixel.x < static_cast<double>(width_) &&
                              pixel.y >= 0 && pixel.y < static_cast<double>(height_);
        if (!isInside || taken_ == mostParts) return;
        if (parts_.size() == parts_.capacity()) makeRoom();
        parts_.push_back({static_cast<int>(pixel.y), static_cast<int>(pixel.x), point.distance, pixel});
        ++taken_;
    }

    void makeRoom() {
        keepNearest();
        const std::size_t room = std::max<std::size_t>(1024, 2 * parts_.size());
        if (room <= parts_.capacity()) return;
        requireMemory({}, "what is small in the picture", static_cast<double>(room * sizeof(Part)));
        parts_.reserve(room);
    }

    // Of each pixel's parts only the nearest, row by row.
    void keepNearest() {
        const auto place = [](const Part& part) { return std::pair(part.row, part.column); };
        std::ranges::sort(parts_, {}, [&](const Part& part) {
            return std::tuple(place(part), part.distance, part.pixel.x, part.pixel.y);
        });
        const auto isSamePlace = [&](const Part& a, const Part& b) { return place(a) == place(b); };
        parts_.erase(std::unique(parts_.begin(), parts_.end(), isSamePlace), parts_.end());
    }

    const Camera& camera_;
    Real width_, height_;
    std::vector<Part> parts_;
    std::size_t taken_ = 0;
};

}  // namespace

std::vector<ExtraSample> smallParts(const Scene& scene, const ImageSize& size) {
    return Search(scene, size).samples();
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
