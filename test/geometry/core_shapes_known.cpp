// Known answers: each shape and each of its faces, in object space, and the same under every pose. A ray and
// a surface that are mapped by the same affine map meet at the same t, so the answer in the world is the
// mapped answer.
#include <catch2/catch.hpp>

#include "../support/core_support.h"

using namespace raytracer;
using namespace raytracer::test;

namespace {

struct Case {
    const char* what;
    Wide origin, direction;
    bool hit = false;
    long double t = 0;
    Wide position{0}, normal{0};
    std::uint32_t face = 0;
    glm::dvec2 texCoord{0};
    bool exact = false;  // tangent or on a seam: only where nothing is rounded
};

constexpr Case miss(const char* what, Wide origin, Wide direction, bool exact = false) {
    Case c{what, origin, direction};
    c.exact = exact;
    return c;
}

double turnOf(double x, double y) { return std::atan2(y, x) / (2 * 3.14159265358979323846); }
const long double slope = std::sqrt(0.5L);

std::vector<Case> sphereCases() {
    const double v = 1 - std::acos(-0.48) / 3.14159265358979323846;
    return {
        {"from outside", {0, 3, 0}, {0, -1, 0}, true, 2, {0, 1, 0}, {0, 1, 0}, 0, {0.25, 0.5}},
        {"t counts in the direction's units",
         {0, 3, 0},
         {0, -4, 0},
         true,
         0.5L,
         {0, 1, 0},
         {0, 1, 0},
         0,
         {0.25, 0.5}},
        {"from inside", {0, 0, 0}, {0, -2, 0}, true, 0.5L, {0, -1, 0}, {0, -1, 0}, 0, {0.75, 0.5}},
        {"from inside, off the centre",
         {0, 0.5L, 0},
         {0, -1, 0},
         true,
         1.5L,
         {0, -1, 0},
         {0, -1, 0},
         0,
         {0.75, 0.5}},
        {"oblique",
         {0.6L, 2.64L, 1.52L},
         {0, -1, -1},
         true,
         2,
         {0.6L, 0.64L, -0.48L},
         {0.6L, 0.64L, -0.48L},
         0,
         {turnOf(0.6, 0.64), v}},
        {"along -x, on the seam", {-3, 0, 0}, {1, 0, 0}, true, 2, {-1, 0, 0}, {-1, 0, 0}, 0, {0.5, 0.5}},
        {"at the pole", {0, 0, 5}, {0, 0, -1}, true, 4, {0, 0, 1}, {0, 0, 1}, 0, {0, 1}, true},
        {"at the other pole", {0, 0, -5}, {0, 0, 1}, true, 4, {0, 0, -1}, {0, 0, -1}, 0, {0, 0}, true},
        {"tangent", {-5, 1, 0}, {1, 0, 0}, true, 5, {0, 1, 0}, {0, 1, 0}, 0, {0.25, 0.5}, true},
        {"starting on it, inwards",
         {0, 1, 0},
         {0, -1, 0},
         true,
         0,
         {0, 1, 0},
         {0, 1, 0},
         0,
         {0.25, 0.5},
         true},
        miss("beside", {-5, 1.001L, 0}, {1, 0, 0}),
        miss("behind the origin", {0, 3, 0}, {0, 1, 0}),
        miss("far away", {1e6L, 2, 0}, {-1, 0, 0}),
    };
}

std::vector<Case> planeCases() {
    return {
        {"from above", {0.25L, 0.5L, 2}, {0, 0, -1}, true, 2, {0.25L, 0.5L, 0}, {0, 0, 1}, 0, {0.625, 0.75}},
        {"from below",
         {0.25L, 0.5L, -2},
         {0, 0, 4},
         true,
         0.5L,
         {0.25L, 0.5L, 0},
         {0, 0, 1},
         0,
         {0.625, 0.75}},
        {"oblique, repeating",
         {4.5L, -4.25L, 1},
         {-1, 2, -1},
         true,
         1,
         {3.5L, -2.25L, 0},
         {0, 0, 1},
         0,
         {0.25, 0.375}},
        {"starting on it",
         {0.25L, 0.5L, 0},
         {1, 0, 1},
         true,
         0,
         {0.25L, 0.5L, 0},
         {0, 0, 1},
         0,
         {0.625, 0.75},
         true},
        miss("parallel", {0, 0, 1}, {1, 1, 0}, true),
        miss("within it", {0, 0, 0}, {1, 1, 0}, true),
        miss("behind the origin", {0, 0, 2}, {1, 0, 1}),
    };
}

std::vector<Case> cylinderCases() {
    return {
        {"body from outside",
         {2.4L, 1.8L, 0.25L},
         {-0.8L, -0.6L, 0},
         true,
         2,
         {0.8L, 0.6L, 0.25L},
         {0.8L, 0.6L, 0},
         0,
         {turnOf(0.8, 0.6), 0.25}},
        {"body from inside",
         {0, 0.5L, 0.5L},
         {0, -1, 0},
         true,
         1.5L,
         {0, -1, 0.5L},
         {0, -1, 0},
         0,
         {0.75, 0.5}},
        {"body, oblique", {0, 3, -0.75L}, {0, -2, 1}, true, 1, {0, 1, 0.25L}, {0, 1, 0}, 0, {0.25, 0.25}},
        {"top from above",
         {0.25L, -0.5L, 3},
         {0, 0, -2},
         true,
         1,
         {0.25L, -0.5L, 1},
         {0, 0, 1},
         1,
         {0.625, 0.25}},
        {"top from inside",
         {0.25L, -0.5L, 0.5L},
         {0, 0, 1},
         true,
         0.5L,
         {0.25L, -0.5L, 1},
         {0, 0, 1},
         1,
         {0.625, 0.25}},
        {"bottom from below",
         {-0.5L, 0.25L, -1},
         {0, 0, 1},
         true,
         1,
         {-0.5L, 0.25L, 0},
         {0, 0, -1},
         2,
         {0.25, 0.625}},
        {"bottom from inside",
         {-0.5L, 0.25L, 0.5L},
         {0, 0, -1},
         true,
         0.5L,
         {-0.5L, 0.25L, 0},
         {0, 0, -1},
         2,
         {0.25, 0.625}},
        {"top, oblique", {2.5L, 0, 3}, {-1, 0, -1}, true, 2, {0.5L, 0, 1}, {0, 0, 1}, 1, {0.75, 0.5}},
        {"along the axis", {0, 0, -1}, {0, 0, 1}, true, 1, {0, 0, 0}, {0, 0, -1}, 2, {0.5, 0.5}},
        {"tangent", {-5, 1, 0.5L}, {1, 0, 0}, true, 5, {0, 1, 0.5L}, {0, 1, 0}, 0, {0.25, 0.5}, true},
        miss("beside", {-5, 1.001L, 0.5L}, {1, 0, 0}),
        miss("above", {-5, 0, 1.001L}, {1, 0, 0}),
        miss("below", {-5, 0, -0.001L}, {1, 0, 0}),
        miss("outside, along the axis", {1.001L, 0, -5}, {0, 0, 1}),
        miss("past the rim", {3, 0, -0.75L}, {-1, 0, 1}),
        miss("behind the origin", {0, 3, 0.5L}, {0, 1, 0}),
    };
}

std::vector<Case> coneCases() {
    const Wide n(0.6L * slope, 0.8L * slope, slope), p(0.3L, 0.4L, 0.5L);
    const Wide east(slope, 0, slope), west(-slope, 0, slope);
    return {
        {"body from outside", p + 2.0L * n, -n, true, 2, p, n, 0, {turnOf(0.3, 0.4), 0.5}},
        {"body from inside",
         {0, 0, 0.25L},
         {0, 1, 0},
         true,
         0.75L,
         {0, 0.75L, 0.25L},
         {0, slope, slope},
         0,
         {0.25, 0.25}},
        {"body, along x", {-3, 0, 0.25L}, {1, 0, 0}, true, 2.25L, {-0.75L, 0, 0.25L}, west, 0, {0.5, 0.25}},
        {"body, downwards",
         {0, 0.5L, 2},
         {0, 0, -1},
         true,
         1.5L,
         {0, 0.5L, 0.5L},
         {0, slope, slope},
         0,
         {0.25, 0.5}},
        {"body, parallel to the other side",
         {-2.5L, 0, 2.5L},
         {1, 0, -1},
         true,
         2,
         {-0.5L, 0, 0.5L},
         west,
         0,
         {0.5, 0.5}},
        {"bottom from below",
         {0.5L, 0.25L, -2},
         {0, 0, 1},
         true,
         2,
         {0.5L, 0.25L, 0},
         {0, 0, -1},
         1,
         {0.75, 0.625}},
        {"bottom from inside",
         {0.25L, 0, 0.5L},
         {0, 0, -1},
         true,
         0.5L,
         {0.25L, 0, 0},
         {0, 0, -1},
         1,
         {0.625, 0.5}},
        {"bottom, oblique", {2.5L, 0, -2}, {-1, 0, 1}, true, 2, {0.5L, 0, 0}, {0, 0, -1}, 1, {0.75, 0.5}},
        {"along the axis", {0, 0, -1}, {0, 0, 1}, true, 1, {0, 0, 0}, {0, 0, -1}, 1, {0.5, 0.5}},
        {"apex from above", {0, 0, 3}, {0, 0, -1}, true, 2, {0, 0, 1}, {0, 0, 1}, 0, {0, 1}, true},
        {"apex from inside", {0, 0, 0.25L}, {0, 0, 1}, true, 0.75L, {0, 0, 1}, {0, 0, 1}, 0, {0, 1}, true},
        {"tangent",
         {-5, 0.5L, 0.5L},
         {1, 0, 0},
         true,
         5,
         {0, 0.5L, 0.5L},
         {0, slope, slope},
         0,
         {0.25, 0.5},
         true},
        miss("beside", {-5, 0.501L, 0.5L}, {1, 0, 0}),
        miss("the other nappe", {3, 0, 2}, {-1, 0, 0}),
        miss("the other nappe, steeply", {0.25L, 0, 1.25L}, {0, 0, 1}),
        miss("below", {-5, 0, -0.001L}, {1, 0, 0}),
        miss("past the rim", {3, 0, -2.25L}, {-1, 0, 2}),
        miss("behind the origin", {0, 3, 0.5L}, {0, 1, 0}),
    };
}

// Face f, seen from outside and from inside, at an off-centre point.
std::vector<Case> boxCases() {
    std::vector<Case> cases;
    for (std::uint32_t face = 0; face < 6; ++face) {
        const auto axis = static_cast<int>(face / 2);
        Wide p(0.25L, -0.5L, 0.125L), n(0);
        n[axis] = face % 2 == 0 ? 1 : -1;
        p[axis] = n[axis];
        const Wide uv = (p + 1.0L) / 2.0L;
        const glm::dvec2 texCoord(uv[axis == 0 ? 1 : 0], uv[axis == 2 ? 1 : 2]);
        Wide aside = 0.25L * n;
        aside[(axis + 1) % 3] = 0.0625L;
        cases.push_back({"face from outside", p + 3.0L * n, -2.0L * n, true, 1.5L, p, n, face, texCoord});
        cases.push_back({"face, oblique", p + 4.0L * aside, -aside, true, 4, p, n, face, texCoord});
        cases.push_back({"face from inside", p - n, n, true, 1, p, n, face, texCoord});
        cases.push_back(miss("behind the origin", p + 3.0L * n, n));
        Wide beside = p;
        beside[(axis + 1) % 3] = 1.001L;
        cases.push_back(miss("beside", beside + 3.0L * n, -n));
    }
    cases.push_back(miss("past the corner", {3, 3, 2.5L}, {-1, -1, 1}));
    return cases;
}

// Of an edge the face that the ray comes to counts, of two such the first in the assignment's order.
std::vector<Case> cubeCases() {
    std::vector<Case> cases = boxCases();
    const Case edges[] = {
        {"corner", {5, 5, 5}, {-1, -1, -1}, true, 4, {1, 1, 1}, {1, 0, 0}, 0, {1, 1}, true},
        {"edge", {0, -4, 4}, {0, 1, -1}, true, 3, {0, -1, 1}, {0, -1, 0}, 3, {0.5, 1}, true},
        {"along a face", {-5, 1, 0.25L}, {1, 0, 0}, true, 4, {-1, 1, 0.25L}, {-1, 0, 0}, 1, {1, 0.625}, true},
        {"touching an edge", {2, 0, 0.5L}, {-1, 1, 0}, true, 1, {1, 1, 0.5L}, {1, 0, 0}, 0, {1, 0.75}, true},
        {"the same back", {0, 2, 0.5L}, {1, -1, 0}, true, 1, {1, 1, 0.5L}, {0, 1, 0}, 2, {1, 0.75}, true}};
    cases.insert(cases.end(), std::begin(edges), std::end(edges));
    return cases;
}

std::vector<Case> casesOf(Kind kind) {
    switch (kind) {
        case Kind::Sphere: return sphereCases();
        case Kind::Plane: return planeCases();
        case Kind::Cylinder: return cylinderCases();
        case Kind::Cone: return coneCases();
        case Kind::Cube: return cubeCases();
        case Kind::Mesh: return boxCases();
    }
    return {};
}

// A few dozen roundings of numbers of this magnitude.
bool near(long double value, long double expected, long double magnitude) {
    return std::abs(value - expected) <= 200 * static_cast<long double>(unitRoundoff) * magnitude;
}

bool near(const Vec3& v, const Wide& expected, long double magnitude) {
    return near(v.x, expected.x, magnitude) && near(v.y, expected.y, magnitude) &&
           near(v.z, expected.z, magnitude);
}

void check(const Case& c, const Shape& shape, const Affine& affine) {
    const Wide origin = pointToWorld(affine, c.origin), direction = directionToWorld(affine, c.direction);
    const Intersection hit = shape.rayIntersect({Vec3(origin), Vec3(direction), {}});
    REQUIRE(hit.valid == c.hit);
    if (!c.hit) return;
    const long double magnitude = 1 + glm::length(origin);
    CHECK(near(hit.t, c.t, 1 + 4 * c.t));
    CHECK(near(hit.position, pointToWorld(affine, c.position), magnitude));
    CHECK(near(hit.normal, normalToWorld(affine, c.normal), 4));
    CHECK(near(hit.texCoord.x, c.texCoord.x, 4));
    CHECK(near(hit.texCoord.y, c.texCoord.y, 4));
    CHECK(hit.material == &shape.material());
    CHECK(hit.shape == &shape);
    CHECK(hit.primitive / (shape.material().shininess == 2 ? 2 : 1) == c.face);
}

}  // namespace

TEST_CASE("every shape's every face, in every pose") {
    const Texture texture{{1, 1}, {255, 255, 255}};
    Material material;
    material.diffuse_texture = &texture;
    for (const Kind kind : allKinds)
        for (const Pose& pose : poses()) {
            const Affine affine = compose(pose.transform);
            material.shininess = kind == Kind::Mesh ? 2 : 1;  // triangles a face, for check()
            const auto shape = makeShape(kind, affine, material, cubeMesh());
            for (const Case& c : casesOf(kind)) {
                if (c.exact && !pose.exact) continue;
                INFO(nameOf(kind) << ", " << pose.name << ": " << c.what);
                check(c, *shape, affine);
            }
        }
}

// A point on the near side, aimed at from ever further away: what is lost goes with the distance, not with
// its square (Haines et al., Ray Tracing Gems, ch. 7).
TEST_CASE("quadrics far from the ray's origin") {
    const Material material;
    struct Aim {
        Kind kind;
        Wide target, from;
    };
    const Aim aims[] = {{Kind::Sphere, {0.48L, 0.6L, 0.64L}, {0.6L, 0, 0.8L}},
                        {Kind::Cylinder, {0.6L, 0.8L, 0.25L}, {0.96L, 0.28L, 0}},
                        {Kind::Cylinder, {0.6L, 0.8L, 0.25L}, {0.64L, 0.48L, 0.6L}},
                        {Kind::Cone, {0.3L, 0.4L, 0.5L}, {0.96L, 0.28L, 0}},
                        {Kind::Cone, {0.3L, 0.4L, 0.5L}, {0.48L, 0.6L, 0.64L}}};
    for (const Aim& aim : aims)
        for (int exponent = 0; exponent < std::numeric_limits<Real>::digits - 8; ++exponent) {
            const long double distance = std::scalbn(1.0L, exponent);
            const Intersection hit =
                makeShape(aim.kind, Affine{}, material)
                    ->rayIntersect({Vec3(aim.target + distance * aim.from), Vec3(-aim.from), {}});
            INFO(nameOf(aim.kind) << " from 2^" << exponent);
            REQUIRE(hit.valid);
            CHECK(near(hit.position, aim.target, 8 + distance));
            CHECK(near(hit.t, distance, 8 + distance));
        }
}

// From so far that the place of the hit is rounded into the very centre, where there is no direction
// outwards.
TEST_CASE("a normal is of unit length however far the ray comes from") {
    const Material material;
    for (const Kind kind : {Kind::Sphere, Kind::Cylinder, Kind::Cone})
        for (int exponent = 0; exponent < 100; ++exponent) {
            const Vec3 origin(std::scalbn(Real(1), exponent), 0, Real(0.25));
            const Intersection hit =
                makeShape(kind, Affine{}, material)->rayIntersect({origin, {-1, 0, 0}, {}});
            INFO(nameOf(kind) << " from 2^" << exponent);
            REQUIRE(hit.valid);
            CHECK(near(glm::dot(hit.normal, hit.normal), 1, 1));
        }
}

namespace {

// A solid that is flat along an axis, a point of the disc that it looks like, and a way to that point.
struct Flat {
    Kind kind;
    int axis;
    Wide target, way;
};
const Flat flats[] = {{Kind::Sphere, 2, {0.4L, 0.3L, 0}, {-0.2L, 0.1L, -1}},
                      {Kind::Sphere, 0, {0, 0.6L, -0.2L}, {1, -0.5L, -0.1L}},
                      {Kind::Cylinder, 0, {0, 0.4L, 0.3L}, {-1, -0.2L, -0.1L}},
                      {Kind::Cone, 2, {0.2L, 0.4L, 0}, {-0.1L, -0.2L, -1}},
                      {Kind::Cone, 2, {0.2L, -0.4L, 0}, {-0.3L, -0.2L, 1}}};

// A ray meets it in that point, and so does the ray that goes on inside it.
void checkDisc(const Flat& flat, double thickness, double degrees) {
    TransformDescription pose, turn;
    pose.rotate = turn.rotate = TransformDescription::Rotation{degrees, {0.3, 1, 0.2}};
    glm::dvec3 scale(1);
    scale[flat.axis] = thickness;
    pose.scale = scale;
    Wide axis(0);
    axis[flat.axis] = flat.way[flat.axis] > 0 ? -1 : 1;
    const Affine turned = compose(turn);
    const Wide target = pointToWorld(turned, flat.target), way = pointToWorld(turned, flat.way),
               normal = pointToWorld(turned, axis);
    // Of an origin that is not distant, as many digits are lost as its distance has.
    const long double roundings = 32 + 4 * std::sqrt(static_cast<long double>(distantSquared)) +
                                  4 * thickness / static_cast<long double>(unitRoundoff);

    Material glass;
    glass.refractive = true;
    const auto shape = makeShape(flat.kind, compose(pose), glass);
    const Ray ray{Vec3(target - 2.0L * way), Vec3(way), {}};
    const Intersection in = shape->rayIntersect(ray);
    REQUIRE(in.valid);
    CHECK(near(in.position, target, roundings));
    CHECK(near(in.normal, normal, roundings));
    const ShadingPoint point(ray, in, true);
    const Intersection out = shape->rayIntersect(point.leave(ray.direction, ShadingPoint::Side::Far));
    REQUIRE(out.valid);
    CHECK(near(out.position, target, roundings));
    CHECK(near(out.normal, -normal, roundings));
}

}  // namespace

// Upright and turned.
TEST_CASE("a flat solid is met where its disc is, however thin") {
    const int most = std::min(1000, std::numeric_limits<Real>::max_exponent - 10);
    for (const Flat& flat : flats)
        for (const double degrees : {0., 33.})
            for (int exponent = 10; exponent < most; ++exponent) {
                INFO(nameOf(flat.kind) << " of 2^-" << exponent << ", turned by " << degrees);
                checkDisc(flat, std::scalbn(1.0, -exponent), degrees);
            }
}

TEST_CASE("answers in the world, worked by hand") {
    const Material material;
    const auto hit = [&](Kind kind, const TransformDescription& t, const Vec3& origin,
                         const Vec3& direction) {
        return makeShape(kind, compose(t), material)->rayIntersect({origin, direction, {}});
    };
    TransformDescription t;
    SECTION("an ellipsoid's normal is steeper than its radius") {
        t.translate = glm::dvec3(10, 0, 0), t.scale = glm::dvec3(2, 1, 0.5);
        const Intersection i = hit(Kind::Sphere, t, Vec3(11.2L, 5.8L, 0), {0, -1, 0});
        REQUIRE(i.valid);
        CHECK(near(i.t, 5, 5));
        CHECK(near(i.position, {11.2L, 0.8L, 0}, 11));
        CHECK(near(i.normal, Wide(0.3L, 0.8L, 0) / std::sqrt(0.73L), 4));
    }
    SECTION("a sheared cube's side leans") {
        t.matrix = glm::dmat4(1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);  // x += y
        const Intersection i = hit(Kind::Cube, t, {5, Real(0.5), 0}, {-1, 0, 0});
        REQUIRE(i.valid);
        CHECK(near(i.t, 3.5L, 5));
        CHECK(near(i.position, {1.5L, 0.5L, 0}, 5));
        CHECK(near(i.normal, {slope, -slope, 0}, 4));
    }
    SECTION("a cylinder turned from z to y") {
        t.rotate = {-90, {1, 0, 0}};
        const Intersection i = hit(Kind::Cylinder, t, {Real(0.5), 4, 0}, {0, -1, 0});
        REQUIRE(i.valid);
        CHECK(i.t == 3);
        CHECK(i.position == Vec3(Real(0.5), 1, 0));
        CHECK(i.normal == Vec3(0, 1, 0));
    }
    SECTION("a mirrored cone still points outwards") {
        t.scale = glm::dvec3(1, 1, -2);
        const Intersection i = hit(Kind::Cone, t, {0, 0, -5}, {0, 0, 1});
        REQUIRE(i.valid);
        CHECK(i.t == 3);  // the apex
        CHECK(i.normal == Vec3(0, 0, -1));
        const Intersection base = hit(Kind::Cone, t, {Real(0.5), 0, 5}, {0, 0, -1});
        CHECK(base.t == 5);
        CHECK(base.normal == Vec3(0, 0, 1));
    }
    SECTION("translate, rotate and scale apply in this order whatever the file's") {
        t.translate = glm::dvec3(1, 0, 0), t.rotate = {90, {0, 0, 1}}, t.scale = glm::dvec3(3, 1, 1);
        const Intersection i = hit(Kind::Cube, t, {1, 9, 0}, {0, -1, 0});
        CHECK(i.t == 6);  // 3 along what was x, now y
        CHECK_FALSE(hit(Kind::Cube, t, {Real(2.5), 9, 0}, {0, -1, 0}).valid);
    }
}
