// Rays, and what a secondary ray knows of the point that it leaves.
#pragma once

#include "raytracer/numerics/numerics.h"
#include "raytracer/numerics/primitive.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

class Shape;

// The point of a surface that a ray starts on. With it, a ray never hits that point again, and needs no
// offset along the ray. Geometry excludes the shape that the ray leaves (Shape::intersect). The error bound
// of the point excludes any other shape that goes through it (Shape::touches).
template <class T>
struct DepartureT {
    const Shape* shape = nullptr;  // null for a ray from the camera: every hit with t >= 0 counts
    Primitive<T> primitive{};      // of that shape: face or triangle
    bool inside = false;       // the ray runs on the inner side of that surface (against its exterior normal)
    bool isScattered = false;  // the direction was reflected or refracted: rounded, of unit length
    Vec3T<T> positionError{0};  // bound on |origin - surface|, for each axis, in world units
};

// The points origin + t * direction, t >= 0, in world space. The direction need not have unit length: t is in
// units of the direction. With Lanes for T, the rays of a packet, which start together: at one camera, or on
// one shape on the same side.
template <class T>
struct RayT {
    Vec3T<T> origin{0};
    Vec3T<T> direction{0};
    DepartureT<T> departure;
};
using Departure = DepartureT<Real>;
using Ray = RayT<Real>;

template <class T>
Ray laneOf(const RayT<T>& ray, int lane) {
    const DepartureT<T>& departure = ray.departure;
    return {laneOf(ray.origin, lane),
            laneOf(ray.direction, lane),
            {departure.shape, laneOf(departure.primitive, lane), departure.inside, departure.isScattered,
             laneOf(departure.positionError, lane)}};
}

template <class T>
RayT<T> filled(const RayT<T>& ray, LaneBits used) {
    const DepartureT<T>& departure = ray.departure;
    return {filled(ray.origin, used),
            filled(ray.direction, used),
            {departure.shape, filled(departure.primitive, used), departure.inside, departure.isScattered,
             filled(departure.positionError, used)}};
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
