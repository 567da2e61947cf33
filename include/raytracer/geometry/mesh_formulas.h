// Where rays meet triangles, and what the surface is like there: for one ray (mesh.cpp) or several
// (packet_tracer.cpp).
#pragma once

#include "raytracer/geometry/mesh.h"
#include "raytracer/geometry/shape_formulas.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

template <class T>
ShearedRayT<T>::ShearedRayT(const ObjectRayT<T>& ray, const ShearAxes& shearAxes)
    : origin(ray.origin), axes(shearAxes) {
    shearX = ray.direction[axes.x] / ray.direction[axes.z];
    shearY = ray.direction[axes.y] / ray.direction[axes.z];
    scaleZ = T(1) / ray.direction[axes.z];
}

// On which side of the edge p -> q the origin lies, +1 or -1, as if the origin were displaced by (e, e^2)
// with e infinitesimal: never 0 unless p == q, and opposite for q -> p. (Simulation of Simplicity,
// Edelsbrunner and Mucke 1990.)
int sideOfEdge(Real px, Real py, Real qx, Real qy);

// Whether the origin is within a triangle of these corners, on an edge of which it seems to be.
bool isWithin(const Vec3& x, const Vec3& y);

// On which side of its edges the origin is, twice the area that it spans with each: 0 only where it is on it.
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
    // All three edges must have the origin on the same side. A rounded difference that is not zero has the
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
        // A sliver may be seen so closely that all three were rounded to zero.
        const Vec3T<T> exact = laneByLane<Vec3T<T>>(exactEdges, x, y);
        u = select(edge, exact.x, u), v = select(edge, exact.y, v), w = select(edge, exact.z, w);
    }
    const T sum = u + v + w;
    result.hit = result.hit & !(sum == T(0));
    result.entering = sum > T(0);
    result.weight[0] = u / sum, result.weight[1] = v / sum, result.weight[2] = w / sum;
    result.t = result.weight[0] * z.x + result.weight[1] * z.y + result.weight[2] * z.z;
    return result;
}

template <class T>
std::array<Vec3T<T>, 3> TriangleMesh::corners(const Primitive<T>& triangle) const {
    std::array<Vec3T<T>, 3> result;
    forEachLane(triangle, [&](int lane, std::uint32_t one) {
        const std::uint32_t* index = &data_->positionIndex[std::size_t{3} * one];
        for (std::size_t i = 0; i < 3; ++i) setLane(result[i], lane, position(index[i]));
    });
    return result;
}

// By the cross product, not of unit length.
template <class T>
Vec3T<T> normalOf(const std::array<Vec3T<T>, 3>& corner) {
    return glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
}

template <class T>
Truth<T> Mesh::touchesTriangle(const Vec3T<T>& point, const Vec3T<T>& pointError,
                               std::uint32_t triangle) const {
    const auto corner = triangles_->corners<Real>(triangle);
    const Vec3T<T> normal(normalOf(corner)), first(corner[0]),
        relative = transform_.pointToObject(point) - first;
    const Vec3T<T> error =
        transform_.objectError(point, pointError) + T(gamma(6)) * (abs(relative) + abs(first));
    return abs(glm::dot(normal, relative)) <= glm::dot(abs(normal), error);
}

template <class T, class Query>
void Mesh::meetTriangles(const MeshRay<T>& ray, std::span<const std::uint32_t> triangles,
                         Query& query) const {
    const DepartureT<T>& departure = ray.world.departure;
    for (const std::uint32_t triangle : triangles) {
        const Truth<T> others =
            !(departure.shape == this ? equals(departure.primitive, triangle) : T(0) < T(0));
        if (!any(others)) continue;
        query.count();
        const auto corner = triangles_->corners<Real>(triangle);
        const LineHit<T> line =
            intersectLine(ray.sheared, {Vec3T<T>(corner[0]), Vec3T<T>(corner[1]), Vec3T<T>(corner[2])});
        if (!any(line.hit)) continue;
        Truth<T> hit = others & line.hit & (line.t >= T(0)) & (line.t <= query.limit());
        if (!any(hit)) continue;
        if (departure.shape && departure.shape != this)
            hit = hit & !touchesTriangle(ray.world.origin, departure.positionError, triangle);
        query.offer(hit, line.t, *this, triangle, line.entering);
    }
}

// A ray that leaves this mesh starts off its triangle's plane, on its own side, and within the edges, by more
// than the point may be wrong: from there the exact test of the line tells truly what it enters and leaves.
// On the point itself, at an edge, rounding would decide, and a ray into the mesh might pass it by.
template <class T>
ObjectRayT<T> Mesh::toObject(const RayT<T>& ray) const {
    ObjectRayT<T> object = transform_.toObject(ray);
    if (ray.departure.shape != this) return object;
    const auto corner = triangles_->corners<T>(ray.departure.primitive);
    const Vec3T<T> error = transform_.objectError(ray.origin, ray.departure.positionError) +
                           T(gamma(4)) * (abs(corner[0]) + abs(corner[1]) + abs(corner[2]));
    const T margin = error.x + error.y + error.z;
    const Vec3T<T> normal = normalOf(corner), up = normalized(normal);
    const T area = glm::dot(normal, up);  // twice
    Vec3T<T> weight, edge;
    for (int i = 0; i < 3; ++i) {
        const Vec3T<T>&next = corner[static_cast<std::size_t>(i + 1) % 3],
              &last = corner[static_cast<std::size_t>(i + 2) % 3];
        weight[i] = glm::dot(glm::cross(next - object.origin, last - object.origin), up);
        edge[i] = sqrt(glm::dot(next - last, next - last));
    }
    // The distance from an edge is its weight over its length. A few margins, so that dihedral angles may be
    // sharp; no more than there is where the triangle is smaller than its error.
    const T longest = maxComponent(edge), least = min(T(8) * margin * longest, area / T(3));
    for (int i = 0; i < 3; ++i) weight[i] = max(weight[i], least);
    object.origin = (weight.x * corner[0] + weight.y * corner[1] + weight.z * corner[2]) /
                    (weight.x + weight.y + weight.z);
    const T off = least / (T(4) * longest);
    object.origin += (ray.departure.inside ? -off : off) * up;
    return object;
}

template <class T>
IntersectionT<T> Mesh::surface(const RayT<T>& ray, const HitT<T>& hit, const ShearAxes& axes) const {
    const auto corner = triangles_->corners<T>(hit.primitive);
    const LineHit<T> line = intersectLine(ShearedRayT<T>(toObject(ray), axes), corner);
    const T* weight = line.weight;
    const Vec3T<T> p = weight[0] * corner[0] + weight[1] * corner[1] + weight[2] * corner[2];
    IntersectionT<T> intersection = place(hit, p, normalOf(corner));
    // p is a sum that may cancel: its error goes with its terms.
    const Vec3T<T> terms =
        abs(weight[0] * corner[0]) + abs(weight[1] * corner[1]) + abs(weight[2] * corner[2]);
    intersection.positionError += transform_.pointError(terms);
    if (wantsTexCoord())
        forEachLane(hit.primitive, [&](int lane, std::uint32_t triangle) {
            const auto uv = triangles_->texCoords(triangle);
            setLane(intersection.texCoord, lane,
                    laneOf(weight[0], lane) * uv[0] + laneOf(weight[1], lane) * uv[1] +
                        laneOf(weight[2], lane) * uv[2]);
        });
    return intersection;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
