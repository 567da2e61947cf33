#include <algorithm>
#include <utility>

#include "raytracer/geometry/triangle_mesh.h"

#include "raytracer/geometry/mesh.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

bool repeats(const MeshData& mesh) {
    return std::ranges::any_of(mesh.texCoords, [](const glm::dvec2& uv) {
        return std::min(uv.x, uv.y) < 0 || std::max(uv.x, uv.y) > 1;
    });
}

// Clamped to the range of Real, which may be float: the fraction of an infinity is NaN.
Real finite(double u) {
    constexpr auto largest = static_cast<double>(
        std::min<long double>(std::numeric_limits<Real>::max(), std::numeric_limits<double>::max()));
    return static_cast<Real>(std::clamp(u, -largest, largest));
}

}  // namespace

int sideOfEdge(Real px, Real py, Real qx, Real qy) {
    const Real difference = differenceOfProducts(px, qy, py, qx);
    if (difference != 0) return difference > 0 ? 1 : -1;
    if (py != qy) return py > qy ? 1 : -1;
    return (qx > px) - (qx < px);
}

bool isWithin(const Vec3& x, const Vec3& y) {
    const int side = sideOfEdge(x[2], y[2], x[1], y[1]);
    return side != 0 && side == sideOfEdge(x[0], y[0], x[2], y[2]) &&
           side == sideOfEdge(x[1], y[1], x[0], y[0]);
}

Vec3 exactEdges(const Vec3& x, const Vec3& y) {
    return {differenceOfProducts(x[2], y[1], y[2], x[1]), differenceOfProducts(x[0], y[2], y[0], x[2]),
            differenceOfProducts(x[1], y[0], y[1], x[0])};
}

ShearAxes shearAxes(const Vec3& direction) {
    const Vec3 size = abs(direction);
    ShearAxes axes{};
    axes.z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    axes.x = (axes.z + 1) % 3;
    axes.y = (axes.z + 2) % 3;
    if (direction[axes.z] < 0) std::swap(axes.x, axes.y);
    return axes;
}

TriangleMesh::TriangleMesh(std::shared_ptr<const MeshData> data, const BuildOptions& options)
    : data_(std::move(data)),
      largest_(maxComponent(Vec3(glm::max(glm::abs(data_->low), glm::abs(data_->high))))),
      repeatsTexture_(repeats(*data_)) {
    if constexpr (!std::is_same_v<Real, double>)
        positions_.assign(data_->positions.begin(), data_->positions.end());
    if (options.accelerator == Accelerator::Bvh) bvh_ = Bvh::ofTriangles(*data_, options);
}

Vec2 TriangleMesh::texCoord(std::uint32_t triangle, const Vec3& weights) const {
    if (data_->texCoordIndex.empty()) return Vec2(0);
    Vec2 corner[3] = {Vec2(0), Vec2(0), Vec2(0)}, result(0);
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t index = data_->texCoordIndex[std::size_t{3} * triangle + i];
        if (index != MeshData::noTexCoord)
            corner[i] = Vec2(finite(data_->texCoords[index].x), finite(data_->texCoords[index].y));
        result += weights[i] * corner[i];
    }
    for (int i = 0; i < 2; ++i) {
        if (result[i] >= 0 && result[i] <= 1) continue;
        // Where rounding alone has led beyond 1, the last column is meant, not the first.
        const auto [low, high] = std::minmax({corner[0][i], corner[1][i], corner[2][i]});
        result[i] = glm::clamp(result[i], low, high);
        if (result[i] < 0 || result[i] > 1) result[i] -= std::floor(result[i]);
    }
    return result;
}

void Mesh::meetAt(const Shape& shape, const Ray& ray, const ObjectRay& object, HitQuery& query) {
    meetInObject(shape, ray, object, query);
}

// Covers the roundings of the watertight test. Where Real is float, also those of the positions: the tree has
// them unrounded.
Real TriangleMesh::slackFrom(Real farthestOrigin) const {
    return 64 * writtenRoundoff * std::max(farthestOrigin, largest_);
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
