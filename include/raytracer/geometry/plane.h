// z = 0.
#pragma once

#include "raytracer/geometry/solid.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct Plane : Equation<Plane> {
    static constexpr ShapeType type = ShapeType::Plane;
    static constexpr const char* faces[] = {""};

    template <class T>
    static Truth<T> touches(const Shape& shape, const Vec3T<T>& point, const Vec3T<T>& pointError,
                            std::uint32_t = 0) {
        const Transform& transform = shape.transform();
        return abs(transform.pointToObject(point).z) <= transform.objectError(point, pointError).z;
    }

    // Whether a reflected or refracted ray is parallel to this plane, up to rounding. Between parallel faces
    // of glass a ray leaves as it came, maybe parallel to the plane. Rounding must not decide that it hits
    // the plane, almost infinitely far away. gamma_16: some eight roundings of the direction, at each of two
    // faces.
    template <class T>
    static Truth<T> isParallel(const Shape& shape, const Vec3T<T>& objectDirection) {
        return abs(objectDirection.z) <= T(gamma(16) * shape.transform().largestDirection().z);
    }

    template <class T>
    static void meet(const Shape& shape, const RayT<T>& ray, HitQueryT<T>& query) {
        if (ray.departure.shape == &shape) return;
        query.count();
        const ObjectRayT<T> object = shape.transform().toObject(ray);
        T t = -object.origin.z / object.direction.z;
        if (!ray.departure.shape) {  // a camera ray that starts on the plane hits it there
            const T terms = shape.transform().pointTerms(ray.origin).z;
            const Truth<T> near = abs(object.origin.z) <= T(coincidenceWindow) * terms;
            if (any(near))
                t = select(near & touches(shape, ray.origin, shape.transform().writtenError(ray.origin)),
                           T(0), t);
        }
        Truth<T> hit = (t >= T(0)) & (t <= query.limit()) & !(object.direction.z == T(0));
        if (!any(hit)) return;
        if (ray.departure.shape) {
            hit = hit & !touches(shape, ray.origin, ray.departure.positionError);
            if (ray.departure.isScattered) hit = hit & !isParallel(shape, object.direction);
        }
        query.offer(hit, t, shape, 0, object.direction.z < T(0));
    }

    static Real support(const Vec3&) { return infinity; }

    template <class T>
    static SurfacePoint<T> onSurface(const Vec3T<T>& p, std::uint32_t) {
        return {{p.x, p.y, T(0)}, {T(0), T(0), T(1)}};
    }

    static Periodic periodic(const Shape&, std::uint32_t) { return {.u = true, .v = true}; }

    template <class T>
    static Vec2T<T> texCoord(const Vec3T<T>& p, std::uint32_t) {
        const auto fraction = [](Real x) { return x - std::floor(x); };
        const Vec2T<T> uv = capTexCoord(p);
        return {laneByLane<T>(fraction, uv.x), laneByLane<T>(fraction, uv.y)};
    }
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
