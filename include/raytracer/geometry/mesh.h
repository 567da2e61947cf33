// A mesh of triangles, which are its faces, numbered in the order of the file.
#pragma once

#include "raytracer/geometry/culling.h"
#include "raytracer/geometry/triangle_mesh.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct Mesh {
    static constexpr ShapeType type = ShapeType::Mesh;
    static constexpr bool isBall = false;

    static std::string faceName(std::size_t triangle) { return "triangle " + std::to_string(triangle); }

    // Of the bounding box, which contains the mesh.
    static Real support(const MeshData& mesh, const Vec3& n) {
        const Vec3 low(mesh.low), high(mesh.high);
        return n.x * (n.x > 0 ? high : low).x + n.y * (n.y > 0 ? high : low).y +
               n.z * (n.z > 0 ? high : low).z;
    }

    static Periodic periodic(const Shape& shape, std::uint32_t) {
        const bool repeats = shape.triangles().repeatsTexture();
        return {.u = repeats, .v = repeats};
    }

    // The cross product of two edges: not of unit length.
    template <class T>
    static Vec3T<T> normalOf(const std::array<Vec3T<T>, 3>& corner) {
        return glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    }

    // Whether the point may lie on the triangle's plane.
    template <class T>
    static Truth<T> touches(const Shape& shape, const Vec3T<T>& point, const Vec3T<T>& pointError,
                            std::uint32_t triangle) {
        const auto corner = shape.triangles().corners<Real>(triangle);
        // Of unit length: of a triangle far smaller than its mesh the products below would underflow.
        const Vec3T<T> normal(normalized(normalOf(corner))), first(corner[0]),
            relative = shape.transform().pointToObject(point) - first;
        const Vec3T<T> error =
            shape.transform().objectError(point, pointError) + T(gamma(7)) * (abs(relative) + abs(first));
        return abs(glm::dot(normal, relative)) <= glm::dot(abs(normal), error);
    }

    template <class T>
    static void meet(const Shape& shape, const RayT<T>& ray, HitQueryT<T>& query) {
        meetInObject(shape, ray, toObject(shape, ray), query);
    }

    // The same for a ray that is known in object space already: when a packet's rays go on alone, all of them
    // have been transformed together.
    static void meetAt(const Shape& shape, const Ray& ray, const ObjectRay& object, HitQuery& query);
    template <class T>
    static void meetInObject(const Shape& shape, const RayT<T>& ray, const ObjectRayT<T>& object,
                             HitQueryT<T>& query) {
        const TriangleMesh& mesh = shape.triangles();
        ShearAxes axes;
        if (commonAxes(object.direction, query.active(), axes) && !mesh.bvh().empty()) {
            const auto slackFrom = [&](Real farthest) { return mesh.slackFrom(farthest); };
            BvhCursor cursor(mesh.bvh(), cullingRay(object.origin, object.direction, slackFrom));
            if (cursor.usable()) {
                if (!nextPrimitives(cursor, query)) return;
                const ShearedRayT<T> sheared(object, axes);
                do meetTriangles(shape, ray, sheared, cursor.primitives(), query);
                while (nextPrimitives(cursor, query));
                return;
            }
        }
        if constexpr (laneCountOf<T> == 1) {
            const ShearedRayT<T> sheared(object, axes);
            for (std::uint32_t triangle = 0; triangle < mesh.triangleCount() && !query.done(); ++triangle)
                meetTriangles(shape, ray, sheared, {&triangle, 1}, query);
        } else {
            meetAlone(ray, query, [&](int lane, const Ray& one, HitQuery& alone) {
                meetAt(shape, one, {laneOf(object.origin, lane), laneOf(object.direction, lane)}, alone);
            });
        }
    }

    template <class T>
    static bool areCoherent(const Shape& shape, const RayT<T>& ray, LaneBits lanes) {
        ShearAxes axes;
        return commonAxes(shape.transform().toObject(ray).direction, lanes, axes);
    }

    template <class T>
    static IntersectionT<T> surface(const Shape& shape, const RayT<T>& ray, const HitT<T>& hit) {
        const auto corner = shape.triangles().corners<T>(hit.primitive);
        const ObjectRayT<T> object = toObject(shape, ray);
        const ShearAxes axes = shearAxes(laneOf(object.direction, 0));
        const LineHit<T> line = intersectLine(ShearedRayT<T>(object, axes), corner);
        const T* weight = line.weight;
        const Vec3T<T> p = weight[0] * corner[0] + weight[1] * corner[1] + weight[2] * corner[2];
        IntersectionT<T> intersection = shape.place(hit, p, normalOf(corner));
        // p is a sum that may cancel, so its error is proportional to the magnitudes of its terms.
        const Vec3T<T> terms =
            abs(weight[0] * corner[0]) + abs(weight[1] * corner[1]) + abs(weight[2] * corner[2]);
        intersection.positionError += shape.transform().pointError(terms);
        if (shape.wantsTexCoord())
            forEachLane(hit.primitive, [&](int lane, std::uint32_t triangle) {
                const Vec3 weights(laneOf(weight[0], lane), laneOf(weight[1], lane), laneOf(weight[2], lane));
                setLane(intersection.texCoord, lane, shape.triangles().texCoord(triangle, weights));
            });
        return intersection;
    }

  private:
    // The ray in object space. The origin of a ray that leaves this mesh is moved: off its triangle's plane,
    // to the side on which the ray runs, and away from the triangle's edges, by more than the error of the
    // point. From there the exact line test is right about what the ray enters and leaves. From the point
    // itself, at an edge, rounding would decide, and a ray into the mesh might miss it.
    template <class T>
    static ObjectRayT<T> toObject(const Shape& shape, const RayT<T>& ray) {
        ObjectRayT<T> object = shape.transform().toObject(ray);
        if (ray.departure.shape != &shape) return object;
        const auto corner = shape.triangles().corners<T>(ray.departure.primitive);
        const Vec3T<T> normal = normalOf(corner), up = normalized(normal);
        const T area = glm::dot(normal, up);  // twice
        Vec3T<T> weight, edge, terms(T(0));
        for (int i = 0; i < 3; ++i) {
            const Vec3T<T>&next = corner[static_cast<std::size_t>(i + 1) % 3],
                  &last = corner[static_cast<std::size_t>(i + 2) % 3];
            weight[i] = glm::dot(glm::cross(next - object.origin, last - object.origin), up);
            edge[i] = sqrt(glm::dot(next - last, next - last));
            terms += min(abs(weight[i]) / area, T(1)) * abs(corner[static_cast<std::size_t>(i)]);
        }
        // Of the point, and of the sum of corners below. Corners are as far off as they have a share in it:
        // far ones of a long triangle are next to nothing where it is small.
        const Vec3T<T> error =
            shape.transform().objectError(ray.origin, ray.departure.positionError) + T(gamma(4)) * terms;
        const T margin = error.x + error.y + error.z;
        // The distance from an edge is the edge's weight over its length. The origin is moved to at least
        // eight margins from each edge, since dihedral angles may be sharp; but not beyond the centroid,
        // whose weights are a third of the area: a triangle may be smaller than its error.
        for (int i = 0; i < 3; ++i) weight[i] = max(weight[i], min(T(8) * margin * edge[i], area / T(3)));
        weight /= weight.x + weight.y + weight.z;  // first: products of three small lengths underflow
        object.origin = weight.x * corner[0] + weight.y * corner[1] + weight.z * corner[2];
        const T off = min(T(2) * margin, area / (T(12) * maxComponent(edge)));
        object.origin += (ray.departure.inside ? -off : off) * up;
        return object;
    }

    // The t of a camera ray's hit. If the ray starts on the triangle, t is 0. Then the corners lie on both
    // sides of the origin, so the terms of the rounded t cancel: only where they do is the origin tested.
    template <class T>
    static T fromOrigin(const Shape& shape, const RayT<T>& ray, std::uint32_t triangle,
                        const LineHit<T>& line) {
        const Truth<T> near = line.hit & (abs(line.t) <= T(Real(0.5)) * line.terms);
        if (!any(near)) return line.t;
        const Truth<T> starts =
            near & touches(shape, ray.origin, shape.transform().writtenError(ray.origin), triangle);
        return select(starts, T(0), line.t);
    }

    template <class T>
    static void meetTriangles(const Shape& shape, const RayT<T>& ray, const ShearedRayT<T>& sheared,
                              std::span<const std::uint32_t> triangles, HitQueryT<T>& query) {
        const DepartureT<T>& departure = ray.departure;
        for (const std::uint32_t triangle : triangles) {
            const Truth<T> others =
                !(departure.shape == &shape ? equals(departure.primitive, triangle) : T(0) < T(0));
            if (!any(others)) continue;
            query.count();
            const auto corner = shape.triangles().corners<Real>(triangle);
            const LineHit<T> line =
                intersectLine(sheared, {Vec3T<T>(corner[0]), Vec3T<T>(corner[1]), Vec3T<T>(corner[2])});
            if (!any(line.hit)) continue;
            const T t = departure.shape ? line.t : fromOrigin(shape, ray, triangle, line);
            Truth<T> hit = others & line.hit & (t >= T(0)) & (t <= query.limit());
            if (!any(hit)) continue;
            if (departure.shape && departure.shape != &shape)
                hit = hit & !touches(shape, ray.origin, departure.positionError, triangle);
            query.offer(hit, t, shape, triangle, line.entering);
        }
    }
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
