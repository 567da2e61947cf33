// The part of a line inside each convex solid: the algebra of shape.cpp, which alone includes this.
#pragma once

#include <algorithm>

#include "raytracer/shape.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

inline Real radius(const Vec3& p) { return std::sqrt(p.x * p.x + p.y * p.y); }

// Narrows the chord to low <= origin + t * direction <= high, along one axis. Ties keep the face that is there, which
// the caller has put there because it comes first.
inline void clip(Chord& chord, Real entry, Real exit, std::uint32_t entryFace, std::uint32_t exitFace) {
    if (entry > chord.entry) chord.entry = entry, chord.entryFace = entryFace;
    if (exit < chord.exit) chord.exit = exit, chord.exitFace = exitFace;
}

inline void clipAxis(Chord& chord, Real origin, Real direction, Real low, Real high, std::uint32_t lowFace, std::uint32_t highFace) {
    const Real toLow = (low - origin) / direction, toHigh = (high - origin) / direction;
    if (direction > 0)
        clip(chord, toLow, toHigh, lowFace, highFace);
    else
        clip(chord, toHigh, toLow, highFace, lowFace);
}

// Solids are closed: an edge or a rim that is met in a single point counts, as its first face, though the roundings of the
// two faces' t (of a quotient, of a quadratic's root) may have put the exit there before the entry. shift: how far along the
// line the origin of t has been moved, which has its own rounding.
inline void closeChord(Chord& chord, Real shift = 0) {
    const Real slack = gamma(16) * std::max(std::abs(shift), std::max(std::abs(chord.entry), std::abs(chord.exit)));
    chord.hit = chord.hit && chord.entry <= chord.exit + slack;
    if (!chord.hit || chord.entry < chord.exit) return;
    chord.exit = chord.entry;
    chord.entryFace = std::min(chord.entryFace, chord.exitFace);
}

// The chord by a direction whose squared length is not safe, such as a shadow ray's to a light 1e-200 away: by the same
// one in other units.
template <class Vec, class ChordFinder>
Chord inSafeUnits(const Vec& direction, ChordFinder chordOf) {
    Real largest = 0;
    for (int axis = 0; axis < direction.length(); ++axis) largest = std::max(largest, std::abs(direction[axis]));
    if (!(largest > 0 && largest < infinity)) return {};
    const int exponent = std::ilogb(largest);
    Vec safe;
    for (int axis = 0; axis < direction.length(); ++axis) safe[axis] = std::scalbn(direction[axis], -exponent);
    Chord chord = chordOf(safe);
    chord.entry = std::scalbn(chord.entry, -exponent);
    chord.exit = std::scalbn(chord.exit, -exponent);
    return chord;
}

// |origin + t direction| = 1, by the textbook; with two components, the same for the cylinder. Its discriminant loses digits
// with the square of the origin's distance, so a distant origin is first moved to the point of closest approach, where
// nothing cancels (Haines et al., Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, ch. 7).
template <class Vec>
Chord unitBallChord(Vec origin, const Vec& direction) {
    const Real a = glm::dot(direction, direction);
    if (!isSafeSquare(a)) return inSafeUnits(direction, [&](const Vec& safe) { return unitBallChord(origin, safe); });
    Real b = glm::dot(origin, direction), c = glm::dot(origin, origin) - 1, shift = 0;
    if (c > farSquared) {
        shift = -b / a;
        origin += shift * direction;
        b = glm::dot(origin, direction);
        c = glm::dot(origin, origin) - 1;
    }
    const Real discriminant = b * b - a * c;
    const Real root = discriminant > 0 ? std::sqrt(discriminant) : 0;
    return {discriminant >= 0, shift + (-b - root) / a, shift + (-b + root) / a, 0, 0};
}

inline Chord sphereChord(const ObjectRay& ray) { return unitBallChord(ray.origin, ray.direction); }

inline Chord cylinderChord(const ObjectRay& ray) {
    const Vec2 origin(ray.origin), direction(ray.direction);
    Chord chord{true, -infinity, infinity, 0, 0};
    if (direction != Vec2(0))
        chord = unitBallChord(origin, direction);
    else
        chord.hit = glm::dot(origin, origin) < 1;
    if (ray.direction.z != 0)
        clipAxis(chord, ray.origin.z, ray.direction.z, 0, 1, 2, 1);
    else
        chord.hit = chord.hit && ray.origin.z > 0 && ray.origin.z < 1;
    closeChord(chord);
    return chord;
}

// x^2 + y^2 - w^2 = 0 with w = 1 - z, the height below the apex: A t^2 + 2 B t + C = 0.
struct ConeRoots {
    bool real;       // a point of the line is on the double cone
    bool steep;      // A < 0: the line runs inside one nappe, then outside, then inside the other
    Real low, high;  // the roots, low <= high
};

inline ConeRoots coneRoots(const Vec3& p, const Vec3& d) {
    const Real a = d.x * d.x + d.y * d.y - d.z * d.z;
    const Real b = p.x * d.x + p.y * d.y - p.z * d.z;
    const Real r = radius(p), c = (r - p.z) * (r + p.z);
    // B^2 - A C by Lagrange's identity for this form: products of differences instead of a difference of products.
    const Vec3 m = glm::cross(p, d);
    const Real h = std::sqrt(m.x * m.x + m.y * m.y);
    const Real discriminant = (h - std::abs(m.z)) * (h + std::abs(m.z));
    const Real root = std::sqrt(std::max(discriminant, Real(0)));
    const Real q = -(b + std::copysign(root, b));
    const bool real = discriminant >= 0 || a < 0;  // a steep line always passes the level of the apex, outside
    if (q == 0) return {real && a != 0, a < 0, 0, 0};
    const Real first = q / a, second = c / q;  // a == 0: the first is infinite, on the side where the line stays outside
    return {real, a < 0, std::min(first, second), std::max(first, second)};
}

inline Chord coneChord(const ObjectRay& ray) {
    // From the closest approach to the middle of the axis, so that the coefficients are of order 1 (Haines et al.).
    const Vec3 fromMiddle = ray.origin - Vec3(0, 0, Real(0.5));
    const Real squared = glm::dot(ray.direction, ray.direction);
    if (!isSafeSquare(squared))
        return inSafeUnits(ray.direction, [&](const Vec3& safe) { return coneChord({ray.origin, safe}); });
    const Real shift = -glm::dot(fromMiddle, ray.direction) / squared;
    const Vec3 closest = ray.origin + shift * ray.direction;
    const Vec3 p(closest.x, closest.y, 1 - closest.z), d(ray.direction.x, ray.direction.y, -ray.direction.z);

    const ConeRoots roots = coneRoots(p, d);
    Chord chord{roots.real, roots.low, roots.high, 0, 0};
    if (roots.steep) {  // the part in the nappe below the apex
        chord.entry = d.z > 0 ? roots.high : -infinity;
        chord.exit = d.z > 0 ? infinity : roots.low;
    }
    if (d.z != 0)  // w = 0 is no face but the apex, which belongs to the body
        clipAxis(chord, p.z, d.z, 0, 1, 0, 1);
    else
        chord.hit = chord.hit && p.z >= 0 && p.z < 1;
    closeChord(chord, shift);
    chord.entry += shift;
    chord.exit += shift;
    return chord;
}

inline Chord cubeChord(const ObjectRay& ray) {
    Chord chord{true, -infinity, infinity, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        const Real origin = ray.origin[axis], direction = ray.direction[axis];
        const auto highFace = static_cast<std::uint32_t>(2 * axis), lowFace = highFace + 1;
        if (direction != 0)
            clipAxis(chord, origin, direction, -1, 1, lowFace, highFace);
        else
            chord.hit = chord.hit && std::abs(origin) <= 1;
    }
    closeChord(chord);
    return chord;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
