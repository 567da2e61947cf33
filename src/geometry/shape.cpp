#include "raytracer/geometry/shape.h"

#include <algorithm>

#include "raytracer/geometry/shape_formulas.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

// Whether it scales alike in all directions, to within 1/256: close enough for culling by FloatBox::ball.
bool isUniform(const Mat3& m) {
    const Mat3 squares = glm::transpose(m) * m;
    Real off = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            off = std::max(off, std::abs(squares[i][j] - (i == j ? squares[0][0] : 0)));
    return off <= squares[0][0] / 1024;
}

}  // namespace

Intersection Shape::rayIntersect(const Ray& ray) const {
    HitQuery query;
    intersect(ray, query);
    return query.found() ? surfaceAt(ray, query.nearest()) : Intersection{};
}

bool Shape::widened(const Vec3& centerObject, const Vec3& sizeObject, const Vec3& half, FloatBox& box) const {
    constexpr Real worst =
        1 << 20;  // a worse transform would widen the whole tree's rays: better no box for this one
    const Mat3 sizes = abs(transform_.linear());
    const Real conditioning = transform_.conditioning();
    if (!(conditioning <= worst)) return false;
    // A hit may lie off the surface by as much as a root of the roundoff (at a cone's apex), in units of the
    // shape's size; and by some roundings of the numbers that place it.
    const Vec3 size = sizes * sizeObject;
    const Real place = maxComponent(abs(transform_.translation()) + sizes * abs(centerObject) + size);
    const Vec3 margin = 16 * coincidenceWindow * size + gamma(32) * conditioning * place;
    const Vec3 center = transform_.pointToWorld(centerObject), low = center - half - margin,
               high = center + half + margin;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = floatBelow(static_cast<double>(low[axis]));
        box.high[axis] = floatAbove(static_cast<double>(high[axis]));
    }
    return Bvh::usable(box);
}

// Sphere

void Sphere::intersect(const Ray& ray, HitQuery& query) const { meet(ray, query); }

Intersection Sphere::surfaceAt(const Ray& ray, const Hit& hit) const { return surface(ray, hit); }

bool Sphere::touches(const Vec3& point, const Vec3& pointError, std::uint32_t) const {
    return touchesOffset(point, pointError, SphereOffset());
}

bool Sphere::bounds(FloatBox& box) const {
    const Mat3& m = transform_.linear();
    box.ball = isUniform(m);
    return widened(Vec3(0), Vec3(1), glm::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]), box);
}

// Cylinder

void Cylinder::intersect(const Ray& ray, HitQuery& query) const { meet(ray, query); }

Intersection Cylinder::surfaceAt(const Ray& ray, const Hit& hit) const { return surface(ray, hit); }

bool Cylinder::touches(const Vec3& point, const Vec3& pointError, std::uint32_t) const {
    return touchesOffset(point, pointError, CylinderOffset());
}

bool Cylinder::bounds(FloatBox& box) const {
    const Mat3& m = transform_.linear();
    const Vec3 half = glm::sqrt(m[0] * m[0] + m[1] * m[1]) + abs(m[2]) / Real(2);
    return widened({0, 0, Real(0.5)}, {1, 1, Real(0.5)}, half, box);
}

// Cone

void Cone::intersect(const Ray& ray, HitQuery& query) const { meet(ray, query); }

Intersection Cone::surfaceAt(const Ray& ray, const Hit& hit) const { return surface(ray, hit); }

bool Cone::touches(const Vec3& point, const Vec3& pointError, std::uint32_t) const {
    return touchesOffset(point, pointError, ConeOffset());
}

// Around the base and the apex.
bool Cone::bounds(FloatBox& box) const {
    const Mat3& m = transform_.linear();
    const Vec3 base = glm::sqrt(m[0] * m[0] + m[1] * m[1]), middle = m[2] / Real(2);
    return widened({0, 0, Real(0.5)}, {1, 1, Real(0.5)}, glm::max(base + abs(middle), abs(middle)), box);
}

// Cube

void Cube::intersect(const Ray& ray, HitQuery& query) const { meet(ray, query); }

Intersection Cube::surfaceAt(const Ray& ray, const Hit& hit) const { return surface(ray, hit); }

bool Cube::touches(const Vec3& point, const Vec3& pointError, std::uint32_t) const {
    return touchesOffset(point, pointError, CubeOffset());
}

bool Cube::bounds(FloatBox& box) const {
    return widened(Vec3(0), Vec3(1), abs(transform_.linear()) * Vec3(1), box);
}

// Plane

void Plane::intersect(const Ray& ray, HitQuery& query) const { meet(ray, query); }

Intersection Plane::surfaceAt(const Ray& ray, const Hit& hit) const { return surface(ray, hit); }

bool Plane::touches(const Vec3& point, const Vec3& pointError, std::uint32_t) const {
    return touchesPlane(point, pointError);
}

bool Plane::bounds(FloatBox&) const { return false; }

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
