
#include <algorithm>
#include <utility>

#include "raytracer/geometry/mesh_formulas.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

// So many triangles are as fast without a tree (Notes.txt).
constexpr std::uint32_t listLimit = 8;

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
    : data_(std::move(data)) {
    if constexpr (!std::is_same_v<Real, double>)
        positions_.assign(data_->positions.begin(), data_->positions.end());
    // Rounding is monotone: the least of the doubles, as Real, is the least of all as Real.
    const Vec3 low(data_->low), high(data_->high);
    center_ = low / Real(2) + high / Real(2);
    size_ = glm::max(high - center_, center_ - low);
    largest_ = glm::max(abs(low), abs(high));
    if (options.accelerator == Accelerator::Bvh && triangleCount() > listLimit)
        bvh_ = Bvh::ofTriangles(*data_, options);
}

std::array<Vec2, 3> TriangleMesh::texCoords(std::uint32_t triangle) const {
    std::array<Vec2, 3> result{};
    if (data_->texCoordIndex.empty()) return result;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t index = data_->texCoordIndex[std::size_t{3} * triangle + corner];
        if (index != MeshData::noTexCoord) result[corner] = Vec2(data_->texCoords[index]);
    }
    return result;
}

LineHit<Real> TriangleMesh::meetLine(const ObjectRay& line, std::uint32_t triangle) const {
    return intersectLine(ShearedRayT<Real>(line, shearAxes(line.direction)), corners<Real>(triangle));
}

// The roundings of the watertight test, and of float positions, which the tree has as they were.
Real Mesh::slackFrom(Real farthestOrigin) const {
    constexpr Real roundoff = std::max(unitRoundoff, static_cast<Real>(0x1p-53));
    return 64 * roundoff * std::max(farthestOrigin, maxComponent(triangles_->largest()));
}

void Mesh::intersect(const Ray& ray, HitQuery& query) const {
    const ObjectRay object = toObject(ray);
    const Bvh& bvh = triangles_->bvh();
    const auto meshRay = [&] { return MeshRay<Real>{ray, {object, shearAxes(object.direction)}}; };
    if (bvh.empty()) return intersectAll(meshRay(), query);

    const auto slack = static_cast<double>(slackFrom(maxComponent(abs(object.origin))));
    BvhCursor cursor(bvh, {glm::dvec3(object.origin), glm::dvec3(object.direction), slack});
    if (!cursor.usable()) return intersectAll(meshRay(), query);
    const auto next = [&] { return cursor.next(static_cast<double>(query.limit())); };
    if (!next()) return;
    const MeshRay<Real> sheared = meshRay();
    do meetTriangles(sheared, cursor.primitives(), query);
    while (!query.done() && next());
}

void Mesh::intersectAll(const MeshRay<Real>& ray, HitQuery& query) const {
    for (std::uint32_t triangle = 0; triangle < triangles_->triangleCount() && !query.done(); ++triangle)
        meetTriangles(ray, {&triangle, 1}, query);
}

bool Mesh::bounds(FloatBox& box) const {
    return widened(triangles_->center(), triangles_->size(), abs(transform_.linear()) * triangles_->size(),
                   box);
}

Intersection Mesh::surfaceAt(const Ray& ray, const Hit& hit) const {
    return surface(ray, hit, shearAxes(transform_.toObject(ray).direction));
}

bool Mesh::touches(const Vec3& point, const Vec3& pointError, std::uint32_t triangle) const {
    return touchesTriangle(point, pointError, triangle);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
