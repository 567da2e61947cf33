#include "raytracer/geometry/solid.h"

#include "raytracer/geometry/shapes.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

template <class Kind>
Vec3 Solid<Kind>::endOfChord(const Shape& shape, const Ray& ray, Real t, bool entering) {
    const ObjectRay object = shape.transform().toObject(ray);
    Vec3 end = object.origin + t * object.direction;
    const bool isClamped = ray.departure.shape == &shape && t <= 0;
    if (!isDistant(object.origin) && !isClamped) return end;
    inSafeUnits(object.origin, object.direction, [&](Vec3 origin, const Vec3& direction, Real squared) {
        moveCloser(origin, direction, squared);
        const Chord<Real> chord = Kind::chord(origin, direction);
        if (chord.hit && !isDistant(origin)) end = origin + (entering ? chord.entry : chord.exit) * direction;
        return chord;
    });
    return end;
}

template Vec3 Solid<Sphere>::endOfChord(const Shape&, const Ray&, Real, bool);
template Vec3 Solid<Cylinder>::endOfChord(const Shape&, const Ray&, Real, bool);
template Vec3 Solid<Cone>::endOfChord(const Shape&, const Ray&, Real, bool);
template Vec3 Solid<Cube>::endOfChord(const Shape&, const Ray&, Real, bool);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
