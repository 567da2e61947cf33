// The triangles that meshes with the same OBJ file share, and the watertight test of a line against one.
#pragma once

#include <array>
#include <memory>
#include <type_traits>
#include <vector>

#include "raytracer/bvh/build_options.h"
#include "raytracer/bvh/bvh.h"
#include "raytracer/geometry/transform.h"
#include "raytracer/scene/mesh_file.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Which object axis is which for the watertight test: z has the largest component of the direction; x and y
// are in the order that keeps the winding.
struct ShearAxes {
    int x, y, z;
};
ShearAxes shearAxes(const Vec3& direction);

// Finds the axes for these lanes; false where they differ.
template <class T>
bool commonAxes(const Vec3T<T>& direction, LaneBits lanes, ShearAxes& axes) {
    axes = shearAxes(laneOf(direction, firstLane(lanes)));
    if constexpr (laneCountOf<T> == 1) return true;
    const Vec3T<T> size = abs(direction);
    const LaneBits xy = bits(size.x > size.y), xz = bits(size.x > size.z), yz = bits(size.y > size.z);
    const LaneBits longest[3] = {xy & xz, ~xy & yz, ~(xy & xz) & ~(~xy & yz)};
    const LaneBits falling = lanes & bits(direction[axes.z] < T(0));
    return (lanes & ~longest[axes.z]) == 0 && (falling == 0 || falling == lanes);
}

// The ray's part of the watertight test (Woop, Benthin and Wald, JCGT 2013): the axes permuted and sheared so
// that the ray becomes the z axis.
template <class T>
struct ShearedRayT {
    ShearedRayT(const ObjectRayT<T>& ray, const ShearAxes& shearAxes)
        : origin(ray.origin),
          axes(shearAxes),
          shearX(ray.direction[axes.x] / ray.direction[axes.z]),
          shearY(ray.direction[axes.y] / ray.direction[axes.z]),
          scaleZ(T(1) / ray.direction[axes.z]) {}

    Vec3T<T> origin;
    ShearAxes axes;
    T shearX, shearY, scaleZ;
};

// Where the line meets the triangle: t, and the barycentric weights of the corners. Inside or outside is
// exact: of the triangles around an edge or a vertex of a closed mesh, a line through that edge or vertex
// hits as many as a line that passes an infinitesimal distance beside it.
template <class T>
struct LineHit {
    Truth<T> hit;
    Truth<T> entering;  // the line comes from the side where the corners are counter-clockwise
    T t;
    T terms;  // the sum of the magnitudes of t's terms
    T weight[3];
};

// On which side of the edge p -> q the origin lies, +1 or -1, as if the origin were displaced by (e, e^2)
// with e infinitesimal: never 0 unless p == q, and opposite for q -> p. (Simulation of Simplicity,
// Edelsbrunner and Mucke 1990.)
int sideOfEdge(Real px, Real py, Real qx, Real qy);

// Whether the origin is within the triangle of these corners, where a rounded edge function is 0.
bool isWithin(const Vec3& x, const Vec3& y);

// The edge functions at the origin: for each edge, twice the signed area of its triangle with the origin. 0
// only where the origin is on the edge's line.
Vec3 exactEdges(const Vec3& x, const Vec3& y);

template <class T>
LineHit<T> intersectLine(const ShearedRayT<T>& ray, const std::array<Vec3T<T>, 3>& corner) {
    Vec3T<T> x, y, z;
    for (int i = 0; i < 3; ++i) {
        const Vec3T<T> relative = corner[static_cast<std::size_t>(i)] - ray.origin;
        x[i] = relative[ray.axes.x] - ray.shearX * relative[ray.axes.z];
        y[i] = relative[ray.axes.y] - ray.shearY * relative[ray.axes.z];
        z[i] = ray.scaleZ * relative[ray.axes.z];
    }
    // The origin must be on the same side of all three edges. A rounded difference that is not zero has the
    // right sign.
    T u = x.z * y.y - y.z * x.y, v = x.x * y.z - y.x * x.z, w = x.y * y.x - y.y * x.x;
    LineHit<T> result;
    const Truth<T> below = (u < T(0)) | (v < T(0)) | (w < T(0)), above = (u > T(0)) | (v > T(0)) | (w > T(0));
    result.hit = !(below & above);
    if (!any(result.hit)) return result;
    const Truth<T> edge = result.hit & ((u == T(0)) | (v == T(0)) | (w == T(0)));
    if (any(edge)) {
        const auto within = [](const Vec3& cornersX, const Vec3& cornersY) {
            return Real(isWithin(cornersX, cornersY));
        };
        result.hit = result.hit & ((!edge) | (laneByLane<T>(within, x, y) > T(0)));
        // All three edge functions of a sliver may have been rounded to zero.
        const Vec3T<T> exact = laneByLane<Vec3T<T>>(exactEdges, x, y);
        u = select(edge, exact.x, u), v = select(edge, exact.y, v), w = select(edge, exact.z, w);
    }
    const T sum = u + v + w;
    result.hit = result.hit & !(sum == T(0));
    result.entering = sum > T(0);
    result.weight[0] = u / sum, result.weight[1] = v / sum, result.weight[2] = w / sum;
    const T a = result.weight[0] * z.x, b = result.weight[1] * z.y, c = result.weight[2] * z.z;
    result.t = a + b + c;
    result.terms = abs(a) + abs(b) + abs(c);
    return result;
}

// The geometry that shapes with the same OBJ file share.
class TriangleMesh {
  public:
    explicit TriangleMesh(std::shared_ptr<const MeshData> data, const BuildOptions& options = {});

    const MeshData& data() const { return *data_; }
    std::uint32_t triangleCount() const { return static_cast<std::uint32_t>(data_->triangleCount()); }
    // The corners of a triangle, or of each lane's triangle.
    template <class T>
    std::array<Vec3T<T>, 3> corners(const Primitive<T>& triangle) const;
    // The texture coordinate where the corners have these weights. The image repeats beyond 0 and 1.
    Vec2 texCoord(std::uint32_t triangle, const Vec3& weights) const;
    bool repeatsTexture() const { return repeatsTexture_; }

    const Bvh& bvh() const { return bvh_; }  // empty: all triangles must be tested

    // BvhRay::slack for rays that start no farther than this from zero: a bound on the error of a computed
    // hit, in object space.
    Real slackFrom(Real farthestOrigin) const;

  private:
    Vec3 position(std::uint32_t index) const {
        if constexpr (std::is_same_v<Real, double>) return Vec3(data_->positions[index]);
        else return positions_[index];
    }

    std::shared_ptr<const MeshData> data_;
    std::vector<Vec3> positions_;  // only where Real is not double, which data_ has
    Real largest_;                 // the largest magnitude of a coordinate
    bool repeatsTexture_;          // some texture coordinate is beyond 0 and 1
    Bvh bvh_;
};

template <class T>
std::array<Vec3T<T>, 3> TriangleMesh::corners(const Primitive<T>& triangle) const {
    std::array<Vec3T<T>, 3> result;
    forEachLane(triangle, [&](int lane, std::uint32_t one) {
        const std::uint32_t* index = &data_->positionIndex[std::size_t{3} * one];
        for (std::size_t i = 0; i < 3; ++i) setLane(result[i], lane, position(index[i]));
    });
    return result;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
