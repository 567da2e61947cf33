// A triangle mesh as a shape: watertight intersection.
#pragma once

#include <array>
#include <memory>
#include <type_traits>
#include <vector>

#include "raytracer/mesh_file.h"
#include "raytracer/render_options.h"
#include "raytracer/shape.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// The ray's part of the watertight test (Woop, Benthin and Wald, JCGT 2013): the axes permuted and sheared so that the
// ray becomes the z axis.
struct ShearedRay {
    explicit ShearedRay(const ObjectRay& ray);

    Vec3 origin;
    int x, y, z;  // which object axis is which; z has the largest component of the direction
    Real shearX, shearY, scaleZ;
};

// The geometry that shapes with the same OBJ file share.
class TriangleMesh {
  public:
    explicit TriangleMesh(std::shared_ptr<const MeshData> data, const BuildOptions& options = {});

    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(data_->triangleCount()); }
    std::array<Vec3, 3> corners(std::uint32_t triangle) const;
    std::array<Vec2, 3> texCoords(std::uint32_t triangle) const;

    // Where the line meets the triangle: t, and the weights of its corners. Exact about the inside: of the triangles around an
    // edge or a vertex of a closed mesh that the line passes through, it meets as many as if it passed by an
    // infinitesimal to the side.
    struct LineHit {
        bool hit = false;
        bool entering = false;  // it comes from where the corners are counter-clockwise
        Real t = 0;
        Real weight[3] = {0, 0, 0};
    };
    LineHit intersectLine(const ShearedRay& ray, std::uint32_t triangle) const;

    const Bvh& bvh() const { return bvh_; }  // empty where all triangles are to be tried

    // The middle of a box around it, half its size, and the largest coordinates, without their signs.
    const Vec3& center() const { return center_; }
    const Vec3& size() const { return size_; }
    const Vec3& largest() const { return largest_; }

  private:
    Vec3 position(std::uint32_t index) const {
        if constexpr (std::is_same_v<Real, double>)
            return Vec3(data_->positions[index]);
        else
            return positions_[index];
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
        : Shape(transform, material, index), triangles_(std::move(triangles)) {}

    void intersect(const Ray& ray, HitQuery& query) const override;
    Intersection surfaceAt(const Ray& ray, const Hit& hit) const override;
    bool touches(const Vec3& point, const Vec3& pointError, std::uint32_t triangle) const override;

    bool bounds(FloatBox& box) const override;

  private:
    struct MeshRay {
        const Ray& world;
        ObjectRay object;
        Real reach;  // the largest coordinate of its origin and of the mesh, in object space: what roundings go by
    };

    void intersectAll(const MeshRay& ray, HitQuery& query) const;
    void intersectTriangle(const MeshRay& ray, const ShearedRay& sheared, std::uint32_t triangle, HitQuery& query) const;
    ObjectRay toObject(const Ray& ray) const;
    Vec3 normalObject(std::uint32_t triangle) const;  // by the cross product, not of unit length

    std::shared_ptr<const TriangleMesh> triangles_;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
