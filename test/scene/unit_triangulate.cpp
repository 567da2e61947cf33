// Polygons of every form, turned in space, at any scale: that their triangles cover them and nothing else.
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include "../../src/scene/point_tree.h"
#include "../../src/scene/triangulate.h"
#include "../support/slowness.h"

using namespace raytracer;

namespace {

using glm::dvec2, glm::dvec3;
using Outline = std::vector<dvec2>;
using Triangle = std::array<std::uint32_t, 3>;

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }

double areaOf(const Outline& outline) {
    double area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        area += cross(outline[i], outline[(i + 1) % outline.size()]) / 2;
    return area;
}

double areaOf(const Outline& outline, const Triangle& t) {
    return cross(outline[t[1]] - outline[t[0]], outline[t[2]] - outline[t[0]]) / 2;
}

// A plane in space: origin + x * across + y * up.
struct Placement {
    dvec3 origin{0}, across{1, 0, 0}, up{0, 1, 0};

    std::vector<dvec3> operator()(const Outline& outline) const {
        std::vector<dvec3> corners;
        for (const dvec2& p : outline) corners.push_back(origin + p.x * across + p.y * up);
        return corners;
    }
};

Outline rotated(Outline outline, std::size_t first) {
    std::rotate(outline.begin(), outline.begin() + static_cast<std::ptrdiff_t>(first), outline.end());
    return outline;
}

std::set<Triangle> numberedFrom(std::size_t first, std::vector<Triangle> triangles, std::size_t count) {
    for (Triangle& t : triangles) {
        for (std::uint32_t& corner : t) corner = static_cast<std::uint32_t>((corner + first) % count);
        std::rotate(t.begin(), std::ranges::min_element(t), t.end());
    }
    return {triangles.begin(), triangles.end()};
}

// Their areas have one sign and add up to the polygon's: together they are the polygon, once.
void checkCovered(const Outline& outline, const std::vector<Triangle>& triangles) {
    REQUIRE(triangles.size() == outline.size() - 2);
    const double whole = areaOf(outline);
    double sum = 0, least = 1;
    for (const Triangle& t : triangles) {
        sum += areaOf(outline, t);
        least = std::min(least, areaOf(outline, t) / whole);
    }
    CHECK(least >= -1e-12);
    CHECK(sum / whole == Approx(1).epsilon(1e-9));
}

void checkAnyFirst(const Outline& outline, const Placement& place, std::size_t step = 1) {
    const auto triangles = triangulateConcave(place(outline));
    checkCovered(outline, triangles);
    const auto expected = numberedFrom(0, triangles, outline.size());
    for (std::size_t first = step; first < outline.size(); first += step)
        CHECK(numberedFrom(first, triangulateConcave(place(rotated(outline, first))), outline.size()) ==
              expected);
}

void checkEverywhere(const Outline& outline, std::size_t step = 1) {
    checkAnyFirst(outline, {}, step);
    checkAnyFirst(outline, {{3, -2, 1}, {0.48, 0.6, 0.64}, {-0.8, 0.6, 0}}, step);
    checkAnyFirst(outline, {{-1e6, 1e7, 2e6}, {0, 0, 1}, {-1, 0.5, 0}}, step);
    for (const double scale : {1e-310, 1e-200, 1e100, 1e307})
        checkAnyFirst(outline, {dvec3(0), scale * dvec3(0.5, 1, 0.25), scale * dvec3(-1, 0.5, 0.125)}, step);
}

class Random {
  public:
    explicit Random(unsigned seed) : bits_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * 0x1p-53 * static_cast<double>(bits_() >> 11);
    }
    std::size_t below(std::size_t count) { return bits_() % count; }

  private:
    std::mt19937_64 bits_;
};

// An even number of corners.
Outline star(std::size_t count, Random& random) {
    Outline outline;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = glm::two_pi<double>() * static_cast<double>(i) / static_cast<double>(count);
        outline.push_back((i % 2 == 0 ? random.between(0.5, 1) : random.between(0.05, 0.2)) *
                          dvec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

// On a coarse grid many corners lie on lines with others.
Outline staircase(std::size_t steps, Random& random) {
    Outline outline{{0, 0}};
    double x = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        const auto y = static_cast<double>(1 + 2 * (i % 2) + random.below(2));
        outline.insert(outline.begin(), {x, y});
        x += static_cast<double>(1 + random.below(2));
        outline.insert(outline.begin(), {x, y});
    }
    outline.insert(outline.begin(), {x, 0});
    return outline;
}

// A band that winds round many times.
Outline spiral(std::size_t count) {
    Outline outline;
    const auto at = [](double turns, double radius) {
        return radius *
               dvec2(std::cos(glm::two_pi<double>() * turns), std::sin(glm::two_pi<double>() * turns));
    };
    for (std::size_t i = 0; i < count / 2; ++i)
        outline.push_back(at(0.02 * static_cast<double>(i), 1 + 0.02 * static_cast<double>(i)));
    for (std::size_t i = count / 2; i-- > 0;)
        outline.push_back(at(0.02 * static_cast<double>(i), 0.5 + 0.02 * static_cast<double>(i)));
    std::reverse(outline.begin(), outline.end());
    return outline;
}

// A hole is reached from the outline by way of two sides that lie on each other.
Outline withHole(Outline outline, Outline hole, std::size_t from, std::size_t to) {
    std::reverse(hole.begin(), hole.end());
    Outline inserted{outline[from]};
    for (std::size_t i = 0; i <= hole.size(); ++i)
        inserted.push_back(hole[(hole.size() - 1 - to + i) % hole.size()]);
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(from), inserted.begin(), inserted.end());
    return outline;
}

// Petals that meet in one point.
Outline flower(std::size_t petals) {
    Outline outline;
    for (std::size_t i = 0; i < petals; ++i) {
        outline.push_back({0, 0});
        for (const double side : {0.0, 0.75}) {
            const double angle =
                glm::two_pi<double>() * (static_cast<double>(i) + side) / static_cast<double>(petals);
            outline.push_back({std::cos(angle), std::sin(angle)});
        }
    }
    return outline;
}

const Outline aSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};

}  // namespace

TEST_CASE("a convex polygon stays as it is") {
    CHECK(triangulateConcave(Placement{}(aSquare)).empty());
    Random random(1);
    for (int n = 4; n < 30; ++n) {
        Outline outline;
        for (int i = 0; i < n; ++i) {
            const double angle = glm::two_pi<double>() * (i + random.between(-0.3, 0.3)) / n;
            outline.push_back({std::cos(angle), std::sin(angle)});
        }
        for (const double scale : {1e-310, 1.0, 1e307})
            CHECK(triangulateConcave(Placement{dvec3(0), scale * dvec3(0.5, 1, 0.25),
                                               scale * dvec3(-1, 0.5, 0.125)}(outline))
                      .empty());
    }
    SECTION("with corners on its sides, in any plane") {
        const Outline outline{{0, 0}, {1, 0}, {3, 0}, {4, 0}, {4, 3}, {4, 4}, {1, 4}, {0, 4}, {0, 0.125}};
        for (int i = 0; i < 100; ++i) {
            const dvec3 across =
                normalize(dvec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)));
            const dvec3 up =
                normalize(glm::cross(across, dvec3(random.between(-1, 1), random.between(-1, 1), 1)));
            CHECK(triangulateConcave(Placement{dvec3(0), across, up}(outline)).empty());
        }
    }
    SECTION("with a corner twice, or without an area") {
        CHECK(triangulateConcave(Placement{}({{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 4}})).empty());
        CHECK(triangulateConcave(Placement{}({{0, 0}, {1, 1}, {2, 2}, {3, 3}})).size() == 2);
    }
}

TEST_CASE("a polygon that is not convex is covered exactly") {
    SECTION("a dart, clockwise too") {
        Outline dart{{0, 1}, {-1, -1}, {0, -0.5}, {1, -1}};
        checkEverywhere(dart);
        std::reverse(dart.begin(), dart.end());
        checkEverywhere(dart);
    }
    SECTION("an L, a comb, a corner with three on a line") {
        checkEverywhere({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
        checkEverywhere(
            {{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
        checkEverywhere({{0, 0}, {1, 0}, {2, 0}, {4, 0}, {2, 1}, {1, 2}, {0, 4}, {0, 2}});
    }
    SECTION("random stars and stairs") {
        Random random(2);
        for (int i = 0; i < 20; ++i) {
            checkEverywhere(star(6 + 2 * random.below(6), random));
            checkEverywhere(staircase(2 + random.below(8), random));
        }
    }
    SECTION("with a hole, at every corner") {
        const Outline hole{{1, 1}, {3, 1}, {2, 2}, {3, 3}, {1, 3}};
        const std::size_t seen[][3] = {
            {0, 1, 4}, {1, 0, 3}, {3, 1, 4}, {4, 0, 3}};  // its corners from the square's
        for (std::size_t from = 0; from < 4; ++from)
            for (const std::size_t to : seen[from]) checkEverywhere(withHole(aSquare, hole, from, to));
    }
    SECTION("that touches itself") {
        checkEverywhere({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}});           // a corner on a side
        checkEverywhere({{0, 0}, {2, 1}, {4, 0}, {4, 2}, {2, 1}, {0, 2}});   // a corner on a corner
        checkEverywhere(withHole(aSquare, {{0, 4}, {1, 1}, {3, 1}}, 0, 1));  // a hole on a corner
    }
    SECTION("with a spike, whose end is farther than its beginning or nearer, or that has corners") {
        checkEverywhere({{-4, -4}, {4, -4}, {4, 4}, {0, 4}, {0, 0}, {0, 1}, {-4, 1}});
        checkEverywhere({{-4, -4}, {4, -4}, {4, 1}, {0, 1}, {0, 0}, {0, 4}, {-4, 4}});
        checkEverywhere({{-4, -4}, {4, -4}, {4, 4}, {0, 4}, {0, 0}, {0, 4}, {-4, 4}});
        checkEverywhere(
            {{-4, -4}, {4, -4}, {4, 4}, {0, 4}, {0, 2}, {0, 0}, {0, -1}, {0, 0}, {0, 1}, {-4, 1}});
    }
    SECTION("not flat: seen along its normal") {
        const Outline outline{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
        std::vector<dvec3> corners = Placement{}(outline);
        for (std::size_t i = 0; i < corners.size(); ++i) corners[i].z = i % 2 == 0 ? 0.05 : -0.05;
        checkCovered(outline, triangulateConcave(corners));
    }
}

TEST_CASE("a polygon that crosses itself has the same triangles from any corner") {
    Random random(3);
    for (int i = 0; i < 100; ++i) {
        Outline outline;
        for (std::size_t n = 4 + random.below(8); n > 0; --n)
            outline.push_back({static_cast<double>(random.below(4)), static_cast<double>(random.below(4))});
        const auto expected = numberedFrom(0, triangulateConcave(Placement{}(outline)), outline.size());
        for (std::size_t first = 1; first < outline.size(); ++first)
            CHECK(numberedFrom(first, triangulateConcave(Placement{}(rotated(outline, first))),
                               outline.size()) == expected);
    }
}

TEST_CASE("polygons of very many corners are covered, too") {
    Random random(4);
    constexpr int corners = 100'000 / test::slowness;
    for (const Outline& outline : {star(corners, random), staircase(corners / 2, random), spiral(corners)})
        checkCovered(outline, triangulateConcave(Placement{dvec3(1), {0.6, 0, 0.8}, {0, 1, 0}}(outline)));
}

TEST_CASE("points along a curve: a line across it meets few of their boxes") {
    constexpr std::int64_t count = 60'000, x = count / 3;
    std::vector<PlanePoint> parabola;
    for (std::int64_t i = 0; i < count; ++i) parabola.push_back({i, i * i});
    int boxes = 0;
    const auto isAtX = [&](const PlaneBox& box) {
        ++boxes;
        return box.low.x <= x && x <= box.high.x;
    };
    CHECK_FALSE(PointTree(parabola).any(isAtX, [](std::uint32_t) { return false; }));
    CHECK(boxes < 50);  // two for each of the tree's 16 levels
}

TEST_CASE("very many corners at one point take no longer than elsewhere") {
    checkAnyFirst(flower(40), {});
    checkCovered(flower(60'000 / test::slowness),
                 triangulateConcave(Placement{}(flower(60'000 / test::slowness))));
    Outline repeated;
    for (int i = 0; i < 50'000 / test::slowness; ++i)
        repeated.insert(repeated.end(), {{0, 0}, {1, 0}, {0.2, 0.2}, {0, 1}});
    CHECK(triangulateConcave(Placement{}(repeated)).size() == repeated.size() - 2);
}
