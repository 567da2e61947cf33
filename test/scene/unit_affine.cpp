// Affine maps: known answers, exact quarter turns, the ends of the exponent range, singular ones.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include "raytracer/scene/affine.h"

using namespace raytracer;

namespace {

using Real = long double;
using Rows = ExtendedRows;

Affine rotation(double degrees, glm::dvec3 axis) {
    TransformDescription transform;
    transform.rotate = TransformDescription::Rotation{degrees, axis};
    return compose(transform);
}

Affine linear(const Rows& rows) {
    Affine affine;
    affine.linear = rows;
    return affine;
}

void requireEqual(const Rows& actual, const Rows& expected) {
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            CAPTURE(row, column);
            CHECK(actual[row][column] == expected[row][column]);
        }
}

// The largest entry of A inverse(A) - I, as a part of the terms that it is the sum of: whatever A's scale, a
// few 2^-64.
Real residual(const Affine& affine) {
    const auto inverse = inverseLinear(affine);
    REQUIRE(inverse);
    Real largest = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            Real sum = row == column ? -1 : 0, size = 1;
            for (int i = 0; i < 3; ++i) {
                const Real term = affine.linear[row][i] * (*inverse)[i][column];
                sum += term;
                size += std::abs(term);
            }
            largest = std::max(largest, std::abs(sum) / size);
        }
    return largest;
}

}  // namespace

TEST_CASE("A transform without parts is the identity") {
    const Affine affine = compose({});
    requireEqual(affine.linear, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK((affine.translation[0] == 0 && affine.translation[1] == 0 && affine.translation[2] == 0));
}

TEST_CASE("The parts apply as translate * rotate * scale * matrix") {
    TransformDescription transform;
    transform.translate = glm::dvec3(10, 20, 30);
    transform.rotate = TransformDescription::Rotation{90, {0, 0, 1}};  // x -> y, y -> -x
    transform.scale = glm::dvec3(2, 3, 4);
    glm::dmat4 matrix(1);
    matrix[1] = {5, 1, 0, 0};  // x += 5 y
    matrix[3] = {1, 1, 1, 1};
    transform.matrix = matrix;
    const Affine affine = compose(transform);
    requireEqual(affine.linear, {{0, -3, 0}, {2, 10, 0}, {0, 0, 4}});
    CHECK(affine.translation[0] == 10 - 3);
    CHECK(affine.translation[1] == 20 + 2);
    CHECK(affine.translation[2] == 30 + 4);
}

TEST_CASE("Quarter turns are exact about any axis") {
    SECTION("about x, y and z, right-handed") {
        requireEqual(rotation(90, {1, 0, 0}).linear, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}});
        requireEqual(rotation(90, {0, 1, 0}).linear, {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}});
        requireEqual(rotation(-90, {0, 0, 1}).linear, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}});
    }
    SECTION("half and full turns, and very many of them") {
        requireEqual(rotation(180, {0, 0, 7}).linear, {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}});
        requireEqual(rotation(360, {1, 2, 3}).linear, rotation(0, {1, 2, 3}).linear);
        requireEqual(rotation(-270, {3, 0, 4}).linear, rotation(90, {3, 0, 4}).linear);
        requireEqual(rotation(360e12 + 90, {0, 0, 1}).linear, rotation(90, {0, 0, 1}).linear);
    }
    SECTION("about a diagonal, the coordinates go round") {
        const Affine affine = rotation(120, {1, 1, 1});
        const Real cycle[3][3] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                CHECK(std::abs(affine.linear[row][column] - cycle[row][column]) < 1e-15L);
    }
}

TEST_CASE("An angle is brought to radians in double, its sine and cosine are taken in long double") {
    const Affine affine = rotation(60, {0, 0, -2});
    const Real radians = 60 * 0.01745329251994329576923690768489;
    CHECK(affine.linear[0][0] == std::cos(radians));
    CHECK(affine.linear[0][1] == std::sin(radians));
    CHECK(affine.linear[1][0] == -std::sin(radians));
}

TEST_CASE("The axis may have any length but 0") {
    for (const double length : {1e-300, 5e-324, 1e-200, 1e200, 1.7e308})
        requireEqual(rotation(90, {0, -length, 0}).linear, rotation(90, {0, -1, 0}).linear);
    for (const double length : {1e-200, 1e200}) {
        const Affine scaled = rotation(37, {1 * length, 2 * length, -3 * length}),
                     unit = rotation(37, {1, 2, -3});
        for (int i = 0; i < 9; ++i)
            CHECK(std::abs(scaled.linear[i / 3][i % 3] - unit.linear[i / 3][i % 3]) < 1e-15L);
    }
}

TEST_CASE("Inverses, known") {
    SECTION("a scale's factors, correctly rounded") {
        const auto inverse = inverseLinear(linear({{3, 0, 0}, {0, -0.1L, 0}, {0, 0, 8}}));
        REQUIRE(inverse);
        requireEqual(*inverse, {{1 / Real(3), 0, 0}, {0, 1 / -0.1L, 0}, {0, 0, 0.125L}});
    }
    SECTION("a permutation, where the pivots are off the diagonal") {
        const auto inverse = inverseLinear(linear({{0, 2, 0}, {0, 0, 4}, {8, 0, 0}}));
        REQUIRE(inverse);
        requireEqual(*inverse, {{0, 0, 0.125L}, {0.5L, 0, 0}, {0, 0.25L, 0}});
    }
    SECTION("a full matrix of integers") {
        const auto inverse = inverseLinear(linear({{2, 1, 1}, {1, 2, 1}, {1, 1, 2}}));
        REQUIRE(inverse);
        for (int i = 0; i < 9; ++i)
            CHECK(std::abs((*inverse)[i / 3][i % 3] - (i % 4 == 0 ? 0.75L : -0.25L)) < 1e-18L);
    }
}

TEST_CASE("Inverses at the ends of the exponent range") {
    for (const Real scale : {1e-300L, 1e-100L, 1e100L, 1e300L})
        CHECK(residual(linear({{2 * scale, scale, 0}, {scale, 2 * scale, scale}, {0, scale, 3 * scale}})) <
              1e-17L);
    CHECK(residual(linear({{1e300L, 0, 0}, {0, 1e-300L, 0}, {0, 0, 1}})) < 1e-17L);
    CHECK(residual(linear({{1, 1e30L, 0}, {0, 1, 0}, {0, 1e-30L, 1}})) < 1e-17L);
    CHECK(residual(linear({{1e40L, 1e20L, 0}, {1e20L, 2, 0}, {0, 0, 1e-200L}})) < 1e-17L);
}

TEST_CASE("Rotated, scaled and sheared over two hundred orders of magnitude, inverses hold") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 10'000; ++i) {
        TransformDescription transform;
        transform.rotate =
            TransformDescription::Rotation{1000 * unit(random), {unit(random), unit(random), 0.1}};
        const double size = std::pow(10, 100 * unit(random));
        transform.scale = glm::dvec3(size, 3 * size, -0.3 * size);
        glm::dmat4 shear(1);
        shear[1][0] = 2 * unit(random);
        transform.matrix = shear;
        REQUIRE(residual(compose(transform)) < 1e-17L);
    }
}

TEST_CASE("A rotation of scales that differ by any factor has an inverse") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto number = [&] { return std::copysign(std::pow(10, 307 * unit(random)), unit(random)); };
    for (int i = 0; i < 10'000; ++i) {
        TransformDescription transform;
        glm::dvec3 axis(unit(random), unit(random), unit(random));
        if (i % 2 == 0) axis[i % 3] = number();
        transform.rotate = TransformDescription::Rotation{i % 3 == 0 ? number() : 360 * unit(random), axis};
        transform.scale = glm::dvec3(number(), i % 5 == 0 ? number() : 1, i % 7 == 0 ? number() : 1);
        CAPTURE(i);
        REQUIRE(residual(compose(transform)) < 1e-17L);
    }
    TransformDescription found;  // by the fuzzer
    found.rotate = TransformDescription::Rotation{1.0339757656912846e-25, {-1e-100, 1.9375, -5.875}};
    found.scale = glm::dvec3(3.125, 1.8309827970591118e+307, 6.0625);
    CHECK(residual(compose(found)) < 1e-17L);
}

TEST_CASE("Singular matrices have no inverse") {
    CHECK_FALSE(inverseLinear(linear({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}})));
    CHECK_FALSE(inverseLinear(linear({{1, 0, 0}, {0, 0, 0}, {0, 0, 1}})));
    CHECK_FALSE(inverseLinear(linear({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}})));
    CHECK_FALSE(inverseLinear(linear({{1e-200L, 2e-200L, 0}, {2e200L, 4e200L, 0}, {0, 0, 1}})));
    TransformDescription flat;  // rank 2, hidden behind a rotation and factors that no double holds exactly
    flat.rotate = TransformDescription::Rotation{33, {1, 2, 3}};
    flat.scale = glm::dvec3(0.1, 1e9, 1e-9);
    flat.matrix = glm::dmat4({0.1, 0.2, 0, 0}, {0.3, 0.6, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});
    CHECK_FALSE(inverseLinear(compose(flat)));
}

TEST_CASE("A matrix that only doubles hold apart from a singular one has an inverse") {
    const Real nearlyOne = 1 + 0x1p-52L;
    CHECK(inverseLinear(linear({{1, 1, 0}, {1, nearlyOne, 0}, {0, 0, 1}})));
}
