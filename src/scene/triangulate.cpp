// Clips ears (Meisters, Polygons have ears, 1975): a corner whose triangle with its two neighbours holds no
// other corner is cut off, until three are left.
#include "triangulate.h"

#include <algorithm>
#include <deque>

#include "plane_polygon.h"
#include "point_tree.h"
#include "spokes.h"

namespace raytracer {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class EarClipping {
  public:
    explicit EarClipping(std::span<const PlanePoint> polygon)
        : polygon_(polygon),
          corners_(polygon.size()),
          left_(static_cast<std::uint32_t>(polygon.size())),
          blocking_(withoutSpikes()) {
        for (const Corner& corner : corners_)
            if (corner.blocker != 0) addSpokes(corner);
    }

    std::vector<Triangle> clipAll() {
        for (weaken(); left_ > 3; weaken()) clipEars();
        const std::uint32_t last = corners_[0].isClipped ? anyLeft() : 0;
        triangles_.push_back(earAt(last));
        return std::move(triangles_);
    }

  private:
    // What an ear must be. Each is used once no corner is an ear by the one before it.
    enum class Strictness {
        Spike,     // no area
        Clear,     // no other corner lies in it or on its sides, up to roundings
        Touching,  // the polygon does not go into it
        Any        // any corner: the polygon crosses itself
    };

    struct Corner {
        std::uint32_t previous, next;
        std::uint32_t blocker = 0;  // its place in blockers_, counted from 1; 0: it is convex
        bool isClipped = false;
    };

    // Returns the points of the corners that may block an ear, each point once. The spikes are clipped first:
    // only they can make a convex corner reflex.
    std::vector<PlanePoint> withoutSpikes() {
        const std::uint32_t count = left_;
        for (std::uint32_t i = 0; i < count; ++i) corners_[i] = {(i + count - 1) % count, (i + 1) % count};
        clipEars();
        std::vector<std::uint32_t> reflex;
        for (std::uint32_t i = 0; i < count; ++i)
            if (!corners_[i].isClipped && !isLeftTurn(i)) reflex.push_back(i);
        std::ranges::sort(reflex, isBefore, [&](std::uint32_t corner) { return polygon_[corner]; });
        std::vector<PlanePoint> blocking;
        for (const std::uint32_t corner : reflex) {
            if (blocking.empty() || blocking.back() != polygon_[corner]) {
                blocking.push_back(polygon_[corner]);
                blockers_.emplace_back(polygon_[corner]);
            }
            corners_[corner].blocker = static_cast<std::uint32_t>(blocking.size());
        }
        return blocking;
    }

    void addSpokes(const Corner& corner) {
        for (const std::uint32_t end : {corner.previous, corner.next})
            blockers_[corner.blocker - 1].add(polygon_[end]);
    }

    Triangle earAt(std::uint32_t corner) const {
        return {corners_[corner].previous, corner, corners_[corner].next};
    }
    bool isLeftTurn(std::uint32_t corner) const {
        const auto [a, b, c] = earAt(corner);
        return sideOf(polygon_[a], polygon_[b], polygon_[c]) > 0;
    }
    // Whether the polygon turns back on itself here. Such a corner has no area, and blocks later ears.
    bool isSpike(std::uint32_t corner) const {
        const auto [previous, tip, next] = earAt(corner);
        return turnsBack(polygon_[previous], polygon_[tip], polygon_[next]);
    }

    // Tries every corner once, and again when a neighbour is clipped: no other corner can have become an ear.
    // First in, first out, so that the triangles do not all share a corner.
    void clipEars() {
        std::deque<std::uint32_t> candidates;
        const auto add = [&](std::uint32_t corner) {
            if (isSpike(corner)) candidates.push_front(corner);
            else candidates.push_back(corner);
        };
        for (std::uint32_t i = 0; i < polygon_.size(); ++i)
            if (!corners_[i].isClipped) add(i);
        while (left_ > 3 && !candidates.empty()) {
            const std::uint32_t corner = candidates.front();
            candidates.pop_front();
            if (corners_[corner].isClipped || !isEar(corner)) continue;
            clip(corner);
            add(corners_[corner].previous);
            add(corners_[corner].next);
        }
    }

    void clip(std::uint32_t corner) {
        const Triangle ear = earAt(corner);
        const auto [previous, clipped, next] = ear;
        triangles_.push_back(ear);
        const Corner before[] = {corners_[previous], corners_[clipped], corners_[next]};
        corners_[clipped].isClipped = true;
        corners_[previous].next = next;
        corners_[next].previous = previous;
        --left_;
        for (std::size_t i = 0; i < 3; ++i)
            if (before[i].blocker != 0) changeSpokes(ear[i], before[i]);
    }

    void changeSpokes(std::uint32_t changed, const Corner& before) {
        Corner& corner = corners_[changed];
        if (corner.isClipped || isLeftTurn(changed)) corner.blocker = 0;
        else addSpokes(corner);
        Spokes& spokes = blockers_[before.blocker - 1];
        for (const std::uint32_t end : {before.previous, before.next}) spokes.remove(polygon_[end]);
        if (spokes.isEmpty()) blocking_.remove(before.blocker - 1);
    }

    bool isEar(std::uint32_t corner) const {
        if (strictness_ == Strictness::Any || isSpike(corner)) return true;
        if (strictness_ == Strictness::Spike) return false;
        const Triangle ear = earAt(corner);
        if (strictness_ == Strictness::Touching && side(ear, 0, polygon_[ear[2]]) == 0) return true;
        return isLeftTurn(corner) &&
               !blocking_.any([&](const PlaneBox& box) { return mayMeet(box, ear); },
                              [&](std::uint32_t point) { return blocks(blockers_[point], ear); });
    }

    // Tests the ear's box, then for each side of the ear the corner of `box` that is farthest to the left of
    // it.
    bool mayMeet(const PlaneBox& box, const Triangle& ear) const {
        constexpr std::int64_t roundings = 8;
        const PlanePoint &a = polygon_[ear[0]], &b = polygon_[ear[1]], &c = polygon_[ear[2]];
        const PlanePoint low{box.low.x - roundings, box.low.y - roundings},
            high{box.high.x + roundings, box.high.y + roundings};
        if (std::max({a.x, b.x, c.x}) < low.x || std::min({a.x, b.x, c.x}) > high.x ||
            std::max({a.y, b.y, c.y}) < low.y || std::min({a.y, b.y, c.y}) > high.y)
            return false;
        const auto mayBeLeft = [&](const PlanePoint& from, const PlanePoint& to) {
            return sideOf(from, to, {(to.y > from.y ? low : high).x, (to.x > from.x ? high : low).y}) >= 0;
        };
        return mayBeLeft(a, b) && mayBeLeft(b, c) && mayBeLeft(c, a);
    }

    // On which side of the ear's side i the point lies, up to roundings.
    int side(const Triangle& ear, std::size_t i, const PlanePoint& point) const {
        return clearSideOf(polygon_[ear[i]], polygon_[ear[(i + 1) % 3]], point);
    }

    bool blocks(const Spokes& blocker, const Triangle& ear) const {
        const PlanePoint& here = blocker.hub();
        const int sides[] = {side(ear, 0, here), side(ear, 1, here), side(ear, 2, here)};
        if (std::ranges::min(sides) < 0) return false;
        // A corner inside the ear blocks it. A corner on its border does if the polygon goes into the ear
        // from there.
        const auto goesIn = [&](const PlanePoint& end) {
            for (std::size_t i = 0; i < 3; ++i)
                if (sides[i] == 0 && side(ear, i, end) <= 0) return false;
            return true;
        };
        for (std::size_t i = 0; i < 3; ++i)
            if (polygon_[ear[i]] == here)
                return blocker.anyBetween(polygon_[ear[(i + 1) % 3]], polygon_[ear[(i + 2) % 3]], goesIn);
        return strictness_ == Strictness::Clear || blocker.any(goesIn);
    }

    void weaken() {
        if (strictness_ != Strictness::Any)
            strictness_ = static_cast<Strictness>(static_cast<int>(strictness_) + 1);
    }

    std::uint32_t anyLeft() const {
        const auto left = std::ranges::find(corners_, false, &Corner::isClipped);
        return static_cast<std::uint32_t>(left - corners_.begin());
    }

    std::span<const PlanePoint> polygon_;
    std::vector<Corner> corners_;
    std::uint32_t left_;
    Strictness strictness_ = Strictness::Spike;
    std::vector<Triangle> triangles_;
    // For each point, the sides at its corners that do not turn left: only such corners can block an ear.
    std::vector<Spokes> blockers_;
    PointTree blocking_;  // their points
};

// For a polygon without a normal, and so without area: any triangles will do, if always the same ones.
std::vector<Triangle> fan(std::uint32_t count) {
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 2; i < count; ++i) triangles.push_back({0, i - 1, i});
    return triangles;
}

}  // namespace

std::vector<Triangle> triangulateConcave(std::span<const glm::dvec3> corners) {
    const std::size_t first = leastCorner(corners);
    std::vector<glm::dvec3> rotated(corners.begin(), corners.end());
    std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(first), rotated.end());
    const std::vector<PlanePoint> polygon = projectPolygon(rotated);
    if (!polygon.empty() && isConvex(polygon)) return {};
    const auto count = static_cast<std::uint32_t>(corners.size());
    std::vector<Triangle> triangles = polygon.empty() ? fan(count) : EarClipping(polygon).clipAll();
    for (Triangle& triangle : triangles)
        for (std::uint32_t& corner : triangle) corner = static_cast<std::uint32_t>((corner + first) % count);
    return triangles;
}

}  // namespace raytracer
