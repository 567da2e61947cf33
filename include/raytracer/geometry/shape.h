// A shape in a scene, and its surface at a hit.
//
// Intersection has two stages. `intersect` finds hits and offers them to a HitQuery as {t, shape, primitive}.
// `surface` computes position, normal, texture coordinate and error bound once, for the hit that won. Each
// type of shape has a file of its own (sphere.h, ...); shapes.h lists them.
#pragma once

#include <cstdint>
#include <memory>

#include "raytracer/bvh/bvh.h"
#include "raytracer/geometry/material.h"
#include "raytracer/geometry/transform.h"
#include "raytracer/scene/scene_description.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

class TriangleMesh;
template <class T>
class HitQueryT;

// A hit as the traversal carries it.
template <class T>
struct HitT {
    T t = infinity;
    const Shape* shape = nullptr;  // null: nothing hit
    Primitive<T> primitive{};
    bool entering = false;  // the ray hits the exterior side: known by geometry, not by a rounded normal
};
using Hit = HitT<Real>;

// A complete hit, in world space.
template <class T>
struct IntersectionT {
    bool valid = false;
    T t{0};                // in units of the ray's direction
    Vec3T<T> position{0};  // on the surface: projected onto it in object space
    Vec3T<T> normal{0};    // unit length, towards the exterior, whichever side the ray comes from
    Vec2T<T> texCoord{0};  // (u, v), v up; only where the material has a texture
    const Material* material = nullptr;

    const Shape* shape = nullptr;
    Primitive<T> primitive{};
    bool entering = false;      // the ray meets the exterior side
    Vec3T<T> positionError{0};  // bound on the distance of `position` from the surface, for each axis
};
using Intersection = IntersectionT<Real>;

template <class T>
Intersection laneOf(const IntersectionT<T>& hit, int lane) {
    return {hit.valid,
            laneOf(hit.t, lane),
            laneOf(hit.position, lane),
            laneOf(hit.normal, lane),
            laneOf(hit.texCoord, lane),
            hit.material,
            hit.shape,
            laneOf(hit.primitive, lane),
            hit.entering,
            laneOf(hit.positionError, lane)};
}

// Whether a face's texture wraps around: its last column (u) or row (v) is followed by the first.
struct Periodic {
    bool u = false, v = false;
};

class Shape {
  public:
    // `triangles`: of a mesh, and only of a mesh.
    Shape(ShapeType type, const Transform& transform, const Material& material, std::uint32_t index,
          std::shared_ptr<const TriangleMesh> triangles = nullptr)
        : transform_(transform),
          material_(&material),
          triangles_(std::move(triangles)),
          index_(index),
          type_(type) {}

    // Offers to the query the hits with t >= 0 that could matter to it: of a convex shape the nearest, of a
    // mesh one for each triangle. Never offers the point that the ray leaves (Departure). A ray that leaves a
    // convex solid outwards does not hit it again. A ray that enters a convex solid leaves it exactly once. A
    // plane or triangle is never hit by a ray that leaves it. If another shape goes through the ray's origin
    // (touches), its root at the origin is dropped. A camera ray that starts on the shape hits it there
    // (unless it is a solid 1 / coincidenceWindow times smaller than its distance from the frame's origin).
    void intersect(const Ray& ray, HitQueryT<Real>& query) const;

    // The same for one ray or a packet (shapes.h), and the surface at a hit that was offered. `surface` takes
    // hits on one face, from one side. areCoherent: whether it can also compute them together; on a mesh it
    // cannot where the rays need different ShearAxes.
    template <class T>
    void meet(const RayT<T>& ray, HitQueryT<T>& query) const;
    template <class T>
    IntersectionT<T> surface(const RayT<T>& ray, const HitT<T>& hit) const;
    template <class T>
    bool areCoherent(const RayT<T>& ray, LaneBits lanes) const;

    // Whether the world point, known to within pointError for each axis, may lie on this shape's surface (on
    // the plane of that primitive, for a mesh).
    bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t primitive) const;

    // Finds a box, in world space, around every point that `intersect` may compute on this shape. False where
    // there is none.
    bool bounds(FloatBox& box) const;

    // A bound, for each axis, on how far from this shape `intersect` may compute a hit.
    Vec3 margin() const;

    Periodic periodic(std::uint32_t primitive) const;

    // The assignment's interface: the nearest hit of this shape alone, complete.
    Intersection rayIntersect(const Ray& ray) const;

    ShapeType type() const { return type_; }
    const Transform& transform() const { return transform_; }
    const Material& material() const { return *material_; }
    const TriangleMesh& triangles() const { return *triangles_; }
    // The place in the scene file: of coincident shapes the first wins.
    std::uint32_t index() const { return index_; }
    bool wantsTexCoord() const { return material_->diffuse_texture != nullptr; }

    // Brings a point and a normal of the surface from object space to the world: the part of `surface` that
    // all types have in common.
    template <class T>
    IntersectionT<T> place(const HitT<T>& hit, const Vec3T<T>& pointObject,
                           const Vec3T<T>& normalObject) const {
        IntersectionT<T> intersection;
        intersection.valid = true;
        intersection.t = hit.t;
        intersection.position = transform_.pointToWorld(pointObject);
        intersection.positionError = transform_.pointError(pointObject);
        intersection.normal = normalized(transform_.normalToWorld(normalObject));
        intersection.material = material_;
        intersection.shape = this;
        intersection.primitive = hit.primitive;
        intersection.entering = hit.entering;
        return intersection;
    }

  private:
    Transform transform_;
    const Material* material_;
    std::shared_ptr<const TriangleMesh> triangles_;
    std::uint32_t index_;
    ShapeType type_;
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
