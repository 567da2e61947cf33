// The shapes of the assignment: where a ray meets them, and what their surface is like there.
//
// Two stages. `intersect` finds hits and offers them to a HitQuery as {t, shape, primitive}; `surfaceAt`
// computes position, normal, texture coordinate and error bound once, for the hit that won.
#pragma once

#include <cstdint>

#include "raytracer/bvh/bvh.h"
#include "raytracer/geometry/hit_query.h"
#include "raytracer/geometry/material.h"
#include "raytracer/geometry/transform.h"
#include "raytracer/scene/scene_description.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// A hit, complete. All in world space.
template <class T>
struct IntersectionT {
    bool valid = false;
    T t{0};                // in units of the ray's direction
    Vec3T<T> position{0};  // on the surface: put back onto it in object space
    Vec3T<T> normal{
        0};  // unit length, towards the shape's exterior whatever the side that the ray comes from
    Vec2T<T> texCoord{0};  // (u, v), v up; only where the material has a texture
    const Material* material = nullptr;

    const Shape* shape = nullptr;
    Primitive<T> primitive{};
    bool entering = false;      // the ray meets the exterior side
    Vec3T<T> positionError{0};  // bound on the distance of `position` from the surface, for each axis
};
using Intersection = IntersectionT<Real>;

using ShapeKind = ShapeType;

// Beside the virtual functions, for one ray, each shape has the same as templates, for one or several
// (`meet`, `surface`), which src/shape_formulas.h and src/mesh_formulas.h define.
class Shape {
  public:
    Shape(ShapeKind kind, const Transform& transform, const Material& material, std::uint32_t index)
        : transform_(transform), material_(&material), index_(index), kind_(kind) {}
    virtual ~Shape() = default;
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;

    // Offers to the query the hits with t >= 0 that could matter to it: a convex shape its nearest, a mesh
    // one for each triangle. Never the point that the ray leaves (Departure): a ray that leaves a convex
    // solid outwards does not meet it again, one that enters it comes out exactly once, a plane or triangle
    // never meets its own ray; and of another shape that goes through the ray's origin (touches) the root at
    // the origin is dropped.
    virtual void intersect(const Ray& ray, HitQuery& query) const = 0;

    // The surface at a hit that `intersect` offered for this ray.
    virtual Intersection surfaceAt(const Ray& ray, const Hit& hit) const = 0;

    // Whether the world point, known to within pointError for each axis, may lie on this shape's surface (on
    // the plane of that primitive, for a mesh).
    virtual bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t primitive) const = 0;

    // A box around every point that `intersect` may take for a point of this shape, in world space; false
    // where there is none.
    virtual bool bounds(FloatBox& box) const = 0;

    // The assignment's interface: the nearest hit of this shape alone, complete.
    Intersection rayIntersect(const Ray& ray) const;

    ShapeKind kind() const { return kind_; }
    const Transform& transform() const { return transform_; }
    const Material& material() const { return *material_; }
    std::uint32_t index() const {
        return index_;
    }  // place in the scene file: the first of coincident shapes wins

  protected:
    // The ray's point at the hit, in object space.
    template <class T>
    Vec3T<T> pointObject(const RayT<T>& ray, const HitT<T>& hit) const;
    // The point of an object-space surface, in the world: the common part of every surface.
    template <class T>
    IntersectionT<T> place(const HitT<T>& hit, const Vec3T<T>& pointObject,
                           const Vec3T<T>& normalObject) const;
    // The box from center - half to center + half, widened by what the arithmetic of `intersect` may be off
    // by. sizeObject: half the size of the shape's box in object space.
    bool widened(const Vec3& centerObject, const Vec3& sizeObject, const Vec3& half, FloatBox& box) const;

    bool wantsTexCoord() const { return material_->diffuse_texture != nullptr; }

    Transform transform_;

  private:
    const Material* material_;
    std::uint32_t index_;
    ShapeKind kind_;
};

// A convex solid: one chord a line. Faces are numbered in the order of the assignment.
class Solid : public Shape {
  public:
    using Shape::Shape;

  protected:
    // What a chord means for a ray: entry or exit, or neither because the ray starts there. chordOf: the part
    // of a line inside the solid, in object space; offsetOf: a signed measure of the distance from the
    // surface, negative inside, at most the Euclidean distance in object units.
    template <class T, class Query, class ChordFinder, class OffsetFinder>
    void offerChord(const RayT<T>& ray, Query& query, ChordFinder chordOf, OffsetFinder offsetOf) const;
    template <class T, class OffsetFinder>
    Truth<T> touchesOffset(const Vec3T<T>& point, const Vec3T<T>& pointError, OffsetFinder offsetOf) const;
};

// x^2 + y^2 + z^2 = 1.
class Sphere final : public Solid {
  public:
    Sphere(const Transform& transform, const Material& material, std::uint32_t index)
        : Solid(ShapeKind::Sphere, transform, material, index) {}
    void intersect(const Ray& ray, HitQuery& query) const override;
    Intersection surfaceAt(const Ray& ray, const Hit& hit) const override;
    bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t primitive) const override;
    bool bounds(FloatBox& box) const override;

    template <class T, class Query>
    void meet(const RayT<T>& ray, Query& query) const;
    template <class T>
    IntersectionT<T> surface(const RayT<T>& ray, const HitT<T>& hit) const;
};

// x^2 + y^2 = 1, 0 < z < 1 (face 0), top z = 1 (1), bottom z = 0 (2).
class Cylinder final : public Solid {
  public:
    Cylinder(const Transform& transform, const Material& material, std::uint32_t index)
        : Solid(ShapeKind::Cylinder, transform, material, index) {}
    void intersect(const Ray& ray, HitQuery& query) const override;
    Intersection surfaceAt(const Ray& ray, const Hit& hit) const override;
    bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t primitive) const override;
    bool bounds(FloatBox& box) const override;

    template <class T, class Query>
    void meet(const RayT<T>& ray, Query& query) const;
    template <class T>
    IntersectionT<T> surface(const RayT<T>& ray, const HitT<T>& hit) const;
};

// x^2 + y^2 = (1 - z)^2, 0 < z <= 1 (face 0), bottom z = 0 (1).
class Cone final : public Solid {
  public:
    Cone(const Transform& transform, const Material& material, std::uint32_t index)
        : Solid(ShapeKind::Cone, transform, material, index) {}
    void intersect(const Ray& ray, HitQuery& query) const override;
    Intersection surfaceAt(const Ray& ray, const Hit& hit) const override;
    bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t primitive) const override;
    bool bounds(FloatBox& box) const override;

    template <class T, class Query>
    void meet(const RayT<T>& ray, Query& query) const;
    template <class T>
    IntersectionT<T> surface(const RayT<T>& ray, const HitT<T>& hit) const;
};

// -1 <= x, y, z <= 1; faces x = 1 (0), x = -1 (1), y = 1 (2), y = -1 (3), z = 1 (4), z = -1 (5).
class Cube final : public Solid {
  public:
    Cube(const Transform& transform, const Material& material, std::uint32_t index)
        : Solid(ShapeKind::Cube, transform, material, index) {}
    void intersect(const Ray& ray, HitQuery& query) const override;
    Intersection surfaceAt(const Ray& ray, const Hit& hit) const override;
    bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t primitive) const override;
    bool bounds(FloatBox& box) const override;

    template <class T, class Query>
    void meet(const RayT<T>& ray, Query& query) const;
    template <class T>
    IntersectionT<T> surface(const RayT<T>& ray, const HitT<T>& hit) const;
};

// z = 0.
class Plane final : public Shape {
  public:
    Plane(const Transform& transform, const Material& material, std::uint32_t index)
        : Shape(ShapeKind::Plane, transform, material, index) {}
    void intersect(const Ray& ray, HitQuery& query) const override;
    Intersection surfaceAt(const Ray& ray, const Hit& hit) const override;
    bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t primitive) const override;
    bool bounds(FloatBox& box) const override;

    template <class T, class Query>
    void meet(const RayT<T>& ray, Query& query) const;
    template <class T>
    IntersectionT<T> surface(const RayT<T>& ray, const HitT<T>& hit) const;

  private:
    template <class T>
    Truth<T> touchesPlane(const Vec3T<T>& point, const Vec3T<T>& pointError) const;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
