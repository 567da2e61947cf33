#include "raytracer/mesh.h"

#include <algorithm>
#include <utility>

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

// So many triangles are as fast without a tree (Notes.txt).
constexpr std::uint32_t listLimit = 8;

// On which side of the edge p -> q the origin lies, +1 or -1, as if the origin were displaced by (e, e^2) with e
// infinitesimal: never 0 unless p == q, and opposite for q -> p. (Simulation of Simplicity, Edelsbrunner and Mucke 1990.)
int sideOfEdge(Real px, Real py, Real qx, Real qy) {
    const Real difference = differenceOfProducts(px, qy, py, qx);
    if (difference != 0) return difference > 0 ? 1 : -1;
    if (py != qy) return py > qy ? 1 : -1;
    return (qx > px) - (qx < px);
}

}  // namespace

ShearedRay::ShearedRay(const ObjectRay& ray) : origin(ray.origin) {
    const Vec3 size = abs(ray.direction);
    z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    x = (z + 1) % 3;
    y = (z + 2) % 3;
    if (ray.direction[z] < 0) std::swap(x, y);  // keeps the winding
    shearX = ray.direction[x] / ray.direction[z];
    shearY = ray.direction[y] / ray.direction[z];
    scaleZ = 1 / ray.direction[z];
}

TriangleMesh::TriangleMesh(std::shared_ptr<const MeshData> data, const BuildOptions& options) : data_(std::move(data)) {
    if constexpr (!std::is_same_v<Real, double>) positions_.assign(data_->positions.begin(), data_->positions.end());
    Vec3 low(infinity), high(-infinity);
    for (std::uint32_t i = 0; i < data_->positions.size(); ++i) {
        low = glm::min(low, position(i));
        high = glm::max(high, position(i));
    }
    center_ = low / Real(2) + high / Real(2);
    size_ = glm::max(high - center_, center_ - low);
    largest_ = glm::max(abs(low), abs(high));
    if (options.accelerator == Accelerator::Bvh && triangleCount() > listLimit)
        bvh_ = Bvh::ofTriangles(data_->positions, data_->positionIndex, options.threads);
}

std::array<Vec3, 3> TriangleMesh::corners(std::uint32_t triangle) const {
    const std::uint32_t* index = &data_->positionIndex[std::size_t{3} * triangle];
    return {position(index[0]), position(index[1]), position(index[2])};
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

TriangleMesh::LineHit TriangleMesh::intersectLine(const ShearedRay& ray, std::uint32_t triangle) const {
    const std::array<Vec3, 3> corner = corners(triangle);
    Real px[3], py[3], pz[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 relative = corner[i] - ray.origin;
        px[i] = relative[ray.x] - ray.shearX * relative[ray.z];
        py[i] = relative[ray.y] - ray.shearY * relative[ray.z];
        pz[i] = ray.scaleZ * relative[ray.z];
    }
    // All three edges must have the origin on the same side. A rounded difference that is not zero has the right sign.
    Real u = px[2] * py[1] - py[2] * px[1], v = px[0] * py[2] - py[0] * px[2], w = px[1] * py[0] - py[1] * px[0];
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return {};
    if (u == 0 || v == 0 || w == 0) {
        const int side = sideOfEdge(px[2], py[2], px[1], py[1]);
        if (side == 0 || side != sideOfEdge(px[0], py[0], px[2], py[2]) ||
            side != sideOfEdge(px[1], py[1], px[0], py[0]))
            return {};
        // A sliver may be seen so closely that all three were rounded to zero.
        u = differenceOfProducts(px[2], py[1], py[2], px[1]);
        v = differenceOfProducts(px[0], py[2], py[0], px[2]);
        w = differenceOfProducts(px[1], py[0], py[1], px[0]);
    }
    const Real sum = u + v + w;
    if (sum == 0) return {};
    LineHit result{true, sum > 0, 0, {u / sum, v / sum, w / sum}};
    result.t = result.weight[0] * pz[0] + result.weight[1] * pz[1] + result.weight[2] * pz[2];
    return result;
}

Vec3 Mesh::normalObject(std::uint32_t triangle) const {
    const auto corner = triangles_->corners(triangle);
    return glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
}

void Mesh::intersect(const Ray& ray, HitQuery& query) const {
    const ObjectRay object = toObject(ray);
    const Vec3 coordinates = glm::max(abs(object.origin), triangles_->largest());
    const MeshRay meshRay{ray, object, maxComponent(coordinates)};
    const Bvh& bvh = triangles_->bvh();
    if (bvh.empty()) return intersectAll(meshRay, query);

    // The roundings of the watertight test, and of float positions, which the tree has as they were.
    constexpr Real roundoff = std::max(unitRoundoff, static_cast<Real>(0x1p-53));
    const Real slack = 64 * roundoff * meshRay.reach;
    BvhCursor cursor(bvh, {glm::dvec3(object.origin), glm::dvec3(object.direction), static_cast<double>(slack)});
    if (!cursor.usable()) return intersectAll(meshRay, query);
    const auto next = [&] { return cursor.next(static_cast<double>(query.limit())); };
    if (!next()) return;
    const ShearedRay sheared(object);
    do {
        for (const std::uint32_t triangle : cursor.primitives()) intersectTriangle(meshRay, sheared, triangle, query);
    } while (!query.done() && next());
}

void Mesh::intersectAll(const MeshRay& ray, HitQuery& query) const {
    const ShearedRay sheared(ray.object);
    for (std::uint32_t triangle = 0; triangle < triangles_->triangleCount() && !query.done(); ++triangle)
        intersectTriangle(ray, sheared, triangle, query);
}

void Mesh::intersectTriangle(const MeshRay& ray, const ShearedRay& sheared, std::uint32_t triangle, HitQuery& query) const {
    const Departure& departure = ray.world.departure;
    if (departure.shape == this && departure.primitive == triangle) return;
    ++query.tests;
    const TriangleMesh::LineHit line = triangles_->intersectLine(sheared, triangle);
    if (!line.hit) return;
    if (!(line.t >= 0 && line.t <= query.limit())) return;
    if (departure.shape && departure.shape != this && touches(ray.world.origin, departure.positionError, triangle)) return;
    query.offer(line.t, *this, triangle, line.entering);
}

// A ray that leaves this mesh starts off its triangle's plane, on its own side, and within the edges, by more than the
// point may be wrong: from there the exact test of the line tells truly what it enters and leaves. On the point itself, at
// an edge, rounding would decide, and a ray into the mesh might pass it by.
ObjectRay Mesh::toObject(const Ray& ray) const {
    ObjectRay object = transform_.toObject(ray);
    if (ray.departure.shape != this) return object;
    const auto corner = triangles_->corners(ray.departure.primitive);
    const Vec3 error = transform_.objectError(ray.origin, ray.departure.positionError) +
                       gamma(4) * (abs(corner[0]) + abs(corner[1]) + abs(corner[2]));
    const Real margin = error.x + error.y + error.z;
    const Vec3 normal = normalObject(ray.departure.primitive), up = normalized(normal);
    const Real area = glm::dot(normal, up);  // twice
    Vec3 weight, edge;
    for (int i = 0; i < 3; ++i) {
        const Vec3 &next = corner[(i + 1) % 3], &last = corner[(i + 2) % 3];
        weight[i] = glm::dot(glm::cross(next - object.origin, last - object.origin), up);
        edge[i] = glm::length(next - last);
    }
    // The distance from an edge is its weight over its length. A few margins, so that dihedral angles may be sharp; no
    // more than there is where the triangle is smaller than its error.
    const Real longest = maxComponent(edge), least = std::min(8 * margin * longest, area / 3);
    weight = glm::max(weight, least);
    object.origin = (weight.x * corner[0] + weight.y * corner[1] + weight.z * corner[2]) / (weight.x + weight.y + weight.z);
    const Real off = least / (4 * longest);
    object.origin += (ray.departure.inside ? -off : off) * up;
    return object;
}

bool Mesh::bounds(FloatBox& box) const {
    return widened(triangles_->center(), triangles_->size(), abs(transform_.linear()) * triangles_->size(), box);
}

Intersection Mesh::surfaceAt(const Ray& ray, const Hit& hit) const {
    const auto line = triangles_->intersectLine(ShearedRay(toObject(ray)), hit.primitive);
    const auto corner = triangles_->corners(hit.primitive);
    const Vec3 p = line.weight[0] * corner[0] + line.weight[1] * corner[1] + line.weight[2] * corner[2];
    Intersection intersection = surface(hit, p, normalObject(hit.primitive));
    // p is a sum that may cancel: its error goes with its terms.
    const Vec3 terms = abs(line.weight[0] * corner[0]) + abs(line.weight[1] * corner[1]) + abs(line.weight[2] * corner[2]);
    intersection.positionError += transform_.pointError(terms);
    if (wantsTexCoord()) {
        const auto uv = triangles_->texCoords(hit.primitive);
        intersection.texCoord = line.weight[0] * uv[0] + line.weight[1] * uv[1] + line.weight[2] * uv[2];
    }
    return intersection;
}

bool Mesh::touches(const Vec3& point, const Vec3& pointError, std::uint32_t triangle) const {
    const auto corner = triangles_->corners(triangle);
    const Vec3 normal = normalObject(triangle), relative = transform_.pointToObject(point) - corner[0];
    const Vec3 error = transform_.objectError(point, pointError) + gamma(6) * (abs(relative) + abs(corner[0]));
    return std::abs(glm::dot(normal, relative)) <= glm::dot(abs(normal), error);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
