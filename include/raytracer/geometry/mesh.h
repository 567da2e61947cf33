// A triangle mesh as a shape: watertight intersection.
#pragma once

#include <array>
#include <memory>
#include <type_traits>
#include <vector>

#include "raytracer/bvh/build_options.h"
#include "raytracer/geometry/shape.h"
#include "raytracer/scene/mesh_file.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// Which object axis is which for the watertight test: z has the largest component of the direction; x and y
// are in the order that keeps the winding.
struct ShearAxes {
    int x, y, z;
    bool operator==(const ShearAxes&) const = default;
};
ShearAxes shearAxes(const Vec3& direction);

// The ray's part of the watertight test (Woop, Benthin and Wald, JCGT 2013): the axes permuted and sheared so
// that the ray becomes the z axis.
template <class T>
struct ShearedRayT {
    ShearedRayT(const ObjectRayT<T>& ray, const ShearAxes& axes);

    Vec3T<T> origin;
    ShearAxes axes;
    T shearX, shearY, scaleZ;
};

// Where the line meets the triangle: t, and the weights of its corners. Exact about the inside: of the
// triangles around an edge or a vertex of a closed mesh that the line passes through, it meets as many as if
// it passed by an infinitesimal to the side.
template <class T>
struct LineHit {
    Truth<T> hit;
    Truth<T> entering;  // it comes from where the corners are counter-clockwise
    T t;
    T weight[3];
};
template <class T>
LineHit<T> intersectLine(const ShearedRayT<T>& ray, const std::array<Vec3T<T>, 3>& corner);

// The geometry that shapes with the same OBJ file share.
class TriangleMesh {
  public:
    explicit TriangleMesh(std::shared_ptr<const MeshData> data, const BuildOptions& options = {});

    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(data_->triangleCount()); }
    // The corners of a triangle, or of each ray's own.
    template <class T>
    std::array<Vec3T<T>, 3> corners(const Primitive<T>& triangle) const;
    std::array<Vec2, 3> texCoords(std::uint32_t triangle) const;

    // Where a line in object space meets one of the triangles.
    LineHit<Real> meetLine(const ObjectRay& line, std::uint32_t triangle) const;

    const Bvh& bvh() const { return bvh_; }  // empty where all triangles are to be tried

    // The middle of a box around it, half its size, and the largest coordinates, without their signs.
    const Vec3& center() const { return center_; }
    const Vec3& size() const { return size_; }
    const Vec3& largest() const { return largest_; }

  private:
    Vec3 position(std::uint32_t index) const {
        if constexpr (std::is_same_v<Real, double>) return Vec3(data_->positions[index]);
        else return positions_[index];
    }

    std::shared_ptr<const MeshData> data_;
    std::vector<Vec3> positions_;  // only where Real is not what data_ has
    Vec3 center_{0}, size_{0}, largest_{0};
    Bvh bvh_;
};

class Mesh final : public Shape {
  public:
    Mesh(const Transform& transform, const Material& material, std::uint32_t index,
         std::shared_ptr<const TriangleMesh> triangles)
        : Shape(ShapeKind::Mesh, transform, material, index), triangles_(std::move(triangles)) {}

    void intersect(const Ray& ray, HitQuery& query) const override;
    Intersection surfaceAt(const Ray& ray, const Hit& hit) const override;
    bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t triangle) const override;

    bool bounds(FloatBox& box) const override;

    // Offers the hits of these triangles.
    template <class T>
    struct MeshRay {
        const RayT<T>& world;
        ShearedRayT<T> sheared;
    };
    template <class T, class Query>
    void meetTriangles(const MeshRay<T>& ray, std::span<const std::uint32_t> triangles, Query& query) const;
    template <class T>
    IntersectionT<T> surface(const RayT<T>& ray, const HitT<T>& hit, const ShearAxes& axes) const;

    template <class T>
    Truth<T> touchesTriangle(const Vec3T<T>& point, const Vec3T<T>& pointError, std::uint32_t triangle) const;

    // The ray in object space, made ready for the test: one that leaves this mesh starts a little off its
    // triangle.
    template <class T>
    ObjectRayT<T> toObject(const RayT<T>& ray) const;
    // How far off a computed hit may be in object space: what BvhRay::slack is.
    Real slackFrom(Real farthestOrigin) const;

    const TriangleMesh& triangles() const { return *triangles_; }

  private:
    void intersectAll(const MeshRay<Real>& ray, HitQuery& query) const;

    std::shared_ptr<const TriangleMesh> triangles_;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
