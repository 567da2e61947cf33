// The light model's parts by known answer: Phong's terms, Snell's law, powers, texels.
#include <catch2/catch.hpp>

#include "raytracer/tracer/shading.h"

using namespace raytracer;

namespace {

// A point on the plane z = 0, seen along `direction`.
struct Seen {
    explicit Seen(const Vec3& direction) {
        hit.valid = true;
        hit.normal = {0, 0, 1};
        hit.material = &material;
        look(direction);
    }
    void look(const Vec3& direction) {
        ray.direction = direction;
        hit.entering = direction.z < 0;
    }
    ShadingPoint point() const { return ShadingPoint(ray, hit, false); }
    DirectLight light(const Vec3& position) const {
        return directLight(point(), {position, Color(1, Real(0.5L), 2), Color(3)});
    }

    Material material;
    Intersection hit;
    Ray ray;
};

bool near(Real a, Real b) { return std::abs(a - b) <= 8 * unitRoundoff; }

bool near(const Vec3& a, const Vec3& b) { return maxComponent(abs(a - b)) <= 8 * unitRoundoff; }

}  // namespace

TEST_CASE("Phong's terms") {
    Seen seen({0, 0, -7});  // V = (0, 0, 1)
    seen.material.color_ambient = Color(Real(0.25L));
    seen.material.color_diffuse = Color(Real(0.5L), 1, Real(0.25L));
    seen.material.color_specular = Color(Real(0.5L));
    seen.material.shininess = 3;
    SECTION("a light in front") {
        const DirectLight light = seen.light({0, 3, 4});  // L = (0, .6, .8), R = (0, -.6, .8)
        CHECK(light.ambient == Color(Real(0.75L)));
        CHECK(near(light.N_L, Real(0.8L)));
        CHECK(near(light.V_R, Real(0.8L)));
        CHECK(near(light.diffuse.x, Real(0.4L)));
        CHECK(near(light.diffuse.y, Real(0.4L)));
        CHECK(near(light.diffuse.z, Real(0.4L)));
        CHECK(near(light.specular.x, Real(0.256L)));
        CHECK(near(light.specular.y, Real(0.128L)));
        CHECK(near(light.specular.z, Real(0.512L)));
        CHECK(light.toLight == Vec3(0, 3, 4));
    }
    SECTION("a light behind the surface gives its ambient part only") {
        const DirectLight light = seen.light({0, 3, -4});
        CHECK(light.ambient == Color(Real(0.75L)));
        CHECK(light.lit() == Color(0));
    }
    SECTION("a light in the surface's own plane") { CHECK(seen.light({0, 3, 0}).lit() == Color(0)); }
    SECTION("a light at the point itself") { CHECK(seen.light({0, 0, 0}).lit() == Color(0)); }
    SECTION("the other side is lit as well") {
        seen.look({0, 0, 2});
        const DirectLight light = seen.light({0, 3, -4});
        CHECK(near(light.N_L, Real(0.8L)));
        CHECK(near(light.V_R, Real(0.8L)));
        const DirectLight behind = seen.light({0, 3, 4});
        CHECK(behind.lit() == Color(0));
        CHECK(behind.N_L == 0);
        CHECK(behind.V_R == 0);
    }
    SECTION("no highlight where the mirror image is behind the viewer") {
        seen.look({0, -4, -1});  // V = (0, 4, 1) / sqrt 17
        const DirectLight light = seen.light({0, 4, 1});
        CHECK(light.V_R == 0);
        CHECK(light.specular == Color(0));
        CHECK(light.diffuse.y > 0);
    }
    SECTION("a shininess of 0 and a light straight above") {
        seen.material.shininess = 0;
        CHECK(near(seen.light({0, 3, 4}).specular.x, Real(0.5L)));
    }
}

TEST_CASE("reflection") {
    CHECK(near(reflectedDirection(Seen({3, 0, -4}).point()), {Real(0.6L), 0, Real(0.8L)}));
    CHECK(near(reflectedDirection(Seen({3, 0, 4}).point()), {Real(0.6L), 0, Real(-0.8L)}));
    CHECK(reflectedDirection(Seen({0, 0, -1}).point()) == Vec3(0, 0, 1));
}

TEST_CASE("Snell's law") {
    Seen entering({3, 0, -4}), leaving({3, 0, 4});
    Vec3 direction(9);
    SECTION("straight on") {
        Seen seen({0, 0, -2});
        seen.material.index_of_refraction = Real(1.5L);
        REQUIRE(refractedDirection(seen.point(), direction));
        CHECK(near(direction, {0, 0, -1}));
        for (const Real ior : {Real(1e-30L), Real(1e-9L), Real(1e9L), Real(1e30L)}) {
            seen.material.index_of_refraction = ior;
            REQUIRE(refractedDirection(seen.point(), direction));
            CHECK(direction == Vec3(0, 0, -1));
        }
    }
    SECTION("the same index on both sides") {
        REQUIRE(refractedDirection(entering.point(), direction));
        CHECK(near(direction, {Real(0.6L), 0, Real(-0.8L)}));
    }
    SECTION("into the denser: sin = 0.6 / 1.5") {
        entering.material.index_of_refraction = Real(1.5L);
        REQUIRE(refractedDirection(entering.point(), direction));
        CHECK(near(direction, {Real(0.4L), 0, -std::sqrt(Real(0.84L))}));
    }
    SECTION("out of the denser: sin = 0.6 * 1.5") {
        leaving.material.index_of_refraction = Real(1.5L);
        REQUIRE(refractedDirection(leaving.point(), direction));
        CHECK(near(direction, {Real(0.9L), 0, std::sqrt(Real(0.19L))}));
    }
    SECTION("total internal reflection: 0.6 * 2 > 1") {
        leaving.material.index_of_refraction = 2;
        CHECK_FALSE(refractedDirection(leaving.point(), direction));
        entering.material.index_of_refraction = Real(0.5L);
        CHECK_FALSE(refractedDirection(entering.point(), direction));
    }
    SECTION("the extremes bend as they should and stay of unit length") {
        for (const Real ior : {1 - 8 * unitRoundoff, 1 + 8 * unitRoundoff, Real(0.1L), Real(10)})
            for (Seen* seen : {&entering, &leaving}) {
                seen->material.index_of_refraction = ior;
                if (!refractedDirection(seen->point(), direction)) continue;
                CHECK(near(glm::length(direction), 1));
                CHECK(direction.z * seen->ray.direction.z > 0);
            }
    }
}

TEST_CASE("secondary rays know the side that they run on") {
    using Side = ShadingPoint::Side;
    const Seen outside({0, 0, -1}), inside({0, 0, 1});
    CHECK_FALSE(outside.point().leave({0, 0, 1}, Side::Near).departure.inside);
    CHECK(outside.point().leave({0, 0, -1}, Side::Far).departure.inside);
    CHECK(inside.point().leave({0, 0, -1}, Side::Near).departure.inside);
    CHECK_FALSE(inside.point().leave({0, 0, 1}, Side::Far).departure.inside);
}

TEST_CASE("normalized") {
    const Real sizes[] = {std::numeric_limits<Real>::min(), std::numeric_limits<Real>::denorm_min(), 1,
                          std::numeric_limits<Real>::max()};
    for (const Real size : sizes) {
        CHECK(near(normalized(Vec3{size, 0, 0}), {1, 0, 0}));
        CHECK(near(normalized(Vec3{size, -size, size}), Vec3(1, -1, 1) / std::sqrt(Real(3))));
    }
    CHECK(normalized(Vec3(0)) == Vec3(0));
}

TEST_CASE("texels") {
    // r g
    // b w
    const Texture texture{{2, 2}, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}};
    const Color r(1, 0, 0), g(0, 1, 0), b(0, 0, 1), w(1);
    const auto at = [&](double u, double v) {
        return lookUp(texture, {static_cast<Real>(u), static_cast<Real>(v)});
    };
    CHECK(at(0, 1) == r);
    CHECK(at(1, 1) == g);
    CHECK(at(0, 0) == b);
    CHECK(at(1, 0) == w);
    CHECK(at(0.49, 0.51) == r);
    CHECK(at(0.51, 0.51) == g);
    CHECK(at(0.49, 0.49) == b);
    CHECK(at(0.5, 0.5) == w);  // a texel owns its upper left edges
    CHECK(at(-0.25, 2) == r);  // beyond the edge: its last texel
    CHECK(at(7, -3) == w);
}

TEST_CASE("texels of 16 bits") {
    const Texture texture{{1, 1}, {}, {1, 256, 65535}};
    CHECK(lookUp(texture, {0, 0}) == Color(1, 256, 65535) / Real(65535));
}

TEST_CASE("bilinear look-ups stop at the border, or go round") {
    // 0 80
    // 160 240
    const Texture texture{{2, 2}, {0, 0, 0, 80, 80, 80, 160, 160, 160, 240, 240, 240}};
    const auto at = [&](double u, double v, bool aroundU, bool aroundV) {
        const Color color =
            lookUpBilinear(texture, {static_cast<Real>(u), static_cast<Real>(v)}, {aroundU, aroundV});
        return static_cast<double>(255 * color.x);
    };
    const auto is = [](double value) { return Approx(value).margin(1e-4); };
    for (const bool u : {false, true})
        for (const bool v : {false, true}) {
            CHECK(at(0.25, 0.75, u, v) == is(0));  // a texel's centre
            CHECK(at(0.5, 0.5, u, v) == is(120));
            CHECK(at(0, 0.75, u, v) == is(u ? 40 : 0));
            CHECK(at(1, 0.75, u, v) == is(u ? 40 : 80));
            CHECK(at(0.125, 0.75, u, v) == is(u ? 20 : 0));
            CHECK(at(0.25, 1, u, v) == is(v ? 80 : 0));
            CHECK(at(0.25, 0, u, v) == is(v ? 80 : 160));
            CHECK(at(0, 1, u, v) == is((u ? 40 : 0) + (v ? 80 : 0)));
        }
    const Texture single{{1, 1}, {51, 51, 51}};
    CHECK(lookUpBilinear(single, {1, 0}, {true, true}) == Color(Real(51) / 255));
}
