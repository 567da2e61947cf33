// Rays, and what a secondary ray knows of the point that it leaves.
#pragma once

#include <cstdint>

#include "raytracer/numerics.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

class Shape;

// Where a ray starts when it starts on a surface. With it a ray never meets again the point that it leaves, and no
// offset along the ray is needed: the shape that it leaves is ruled out by geometry (Shape::intersect), another shape
// that goes through the same point by the bound on where that point can be (Shape::touches).
struct Departure {
    const Shape* shape = nullptr;    // null for a ray from the camera: every hit with t >= 0 counts
    std::uint32_t primitive = 0;     // of that shape: face or triangle
    bool inside = false;             // the ray runs on the inner side of that surface (against its exterior normal)
    Vec3 positionError{0};           // bound on |origin - surface|, for each axis, in world units
};

// The points origin + t * direction, t >= 0, in world space. The direction is not of unit length: t counts in its units.
struct Ray {
    Vec3 origin{0};
    Vec3 direction{0};
    Departure departure;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
