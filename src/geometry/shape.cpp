#include "raytracer/geometry/shape.h"

#include <algorithm>
#include <tuple>

#include "raytracer/geometry/shapes.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// Whether the map scales all directions equally, to within 1/256: close enough for culling by FloatBox::ball.
bool isUniform(const Mat3& m) {
    const Mat3 squares = glm::transpose(m) * m;
    Real off = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            off = std::max(off, std::abs(squares[i][j] - (i == j ? squares[0][0] : 0)));
    return off <= squares[0][0] / 1024;
}

struct Box {
    Vec3 low, high;
};

// Around the shape, mapped by `linear` and `translation`.
Box boxAround(const Shape& shape, const Mat3& linear, const Vec3& translation) {
    const MeshData* mesh = shape.type() == ShapeType::Mesh ? &shape.triangles().data() : nullptr;
    const Mat3 rows = glm::transpose(linear);
    Box box{translation, translation};
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] -= support(shape.type(), mesh, -rows[axis]);
        box.high[axis] += support(shape.type(), mesh, rows[axis]);
    }
    return box;
}

}  // namespace

bool isListedBefore(const Hit& a, const Hit& b) {
    return std::tuple(a.shape->index(), a.primitive) < std::tuple(b.shape->index(), b.primitive);
}

void Shape::intersect(const Ray& ray, HitQuery& query) const { meet(ray, query); }

bool Shape::touches(const Vec3& point, const Vec3& pointError, std::uint32_t primitive) const {
    return visit(type_, [&](auto kind) { return kind.touches(*this, point, pointError, primitive); });
}

Periodic Shape::periodic(std::uint32_t primitive) const {
    return visit(type_, [&](auto kind) { return kind.periodic(*this, primitive); });
}

Intersection Shape::rayIntersect(const Ray& ray) const {
    HitQuery query;
    intersect(ray, query);
    return query.found() ? surface(ray, query.nearest()) : Intersection{};
}

Vec3 Shape::margin() const {
    // A hit may be off the surface by the square root of the roundoff (at a cone's apex), relative to the
    // shape's size, and by some roundings of the coordinates that place the shape.
    const Box object = boxAround(*this, Mat3(1), Vec3(0));
    const Mat3 sizes = abs(transform_.linear());
    const Vec3 size = sizes * (object.high / Real(2) - object.low / Real(2));
    const Vec3 far = abs(transform_.translation()) + sizes * glm::max(abs(object.low), abs(object.high));
    return 16 * coincidenceWindow * size + gamma(32) * transform_.conditioning() * maxComponent(far);
}

bool Shape::bounds(FloatBox& box) const {
    constexpr Real worst = 1 << 20;  // a worse one would widen every ray in the tree: this shape has no box
    if (!(transform_.conditioning() <= worst)) return false;
    const Box world = boxAround(*this, transform_.linear(), transform_.translation());
    const Vec3 error = margin();
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = floatBelow(static_cast<double>(world.low[axis] - error[axis]));
        box.high[axis] = floatAbove(static_cast<double>(world.high[axis] + error[axis]));
    }
    box.ball = isUniform(transform_.linear()) && visit(type_, [](auto kind) { return kind.isBall; });
    return Bvh::usable(box);
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
