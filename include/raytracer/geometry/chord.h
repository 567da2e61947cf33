// The part of a line inside each convex solid: the algebra of shape_formulas.h, which alone includes this.
#pragma once

#include "raytracer/geometry/transform.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// The part of a line inside a convex solid, in t of the ray. A face is a number of T, so that it is chosen as
// the t are.
template <class T>
struct Chord {
    Truth<T> hit;
    T entry, exit;  // entry <= exit where hit; exit is meaningful for a line through the inside regardless
    T entryFace, exitFace;
};

template <class T>
T radius(const Vec3T<T>& p) {
    return sqrt(p.x * p.x + p.y * p.y);
}

// Narrows the chord to low <= origin + t * direction <= high, along one axis. Ties keep the face that is
// there, which the caller has put there because it comes first. A line that does not move along this axis is
// in or out as a whole
// (`within`).
template <class T>
void clipAxis(Chord<T>& chord, const T& origin, const T& direction, Real low, Real high, Real lowFace,
              Real highFace, const Truth<T>& within) {
    const T toLow = (T(low) - origin) / direction, toHigh = (T(high) - origin) / direction;
    const Truth<T> rising = direction > T(0), still = direction == T(0);
    const T entry = select(still, T(-infinity), select(rising, toLow, toHigh));
    const T exit = select(still, T(infinity), select(rising, toHigh, toLow));
    const Truth<T> later = entry > chord.entry, earlier = exit < chord.exit;
    chord.entryFace = select(later, select(rising, T(lowFace), T(highFace)), chord.entryFace);
    chord.entry = select(later, entry, chord.entry);
    chord.exitFace = select(earlier, select(rising, T(highFace), T(lowFace)), chord.exitFace);
    chord.exit = select(earlier, exit, chord.exit);
    chord.hit = chord.hit & ((!still) | within);
}

// Solids are closed: an edge or a rim that is met in a single point counts, as its first face, though the
// roundings of the two faces' t (of a quotient, of a quadratic's root) may have put the exit there before the
// entry. shift: how far along the line the origin of t has been moved, which has its own rounding.
template <class T>
void closeChord(Chord<T>& chord, const T& shift = T(0)) {
    const T slack = T(gamma(16)) * max(abs(shift), max(abs(chord.entry), abs(chord.exit)));
    chord.hit = chord.hit & (chord.entry <= chord.exit + slack);
    const Truth<T> single = chord.hit & !(chord.entry < chord.exit);
    if (!any(single)) return;
    chord.exit = select(single, chord.entry, chord.exit);
    chord.entryFace = select(single, min(chord.entryFace, chord.exitFace), chord.entryFace);
}

// The chord by a direction whose squared length is not safe, such as a shadow ray's to a light 1e-200 away:
// by the same one in other units.
template <class Vec, class ChordFinder>
Chord<Real> inSafeUnits(const Vec& direction, ChordFinder chordOf) {
    Real largest = 0;
    for (int axis = 0; axis < direction.length(); ++axis)
        largest = std::max(largest, std::abs(direction[axis]));
    if (!(largest > 0 && largest < infinity)) return {};
    const int exponent = std::ilogb(largest);
    Vec safe;
    for (int axis = 0; axis < direction.length(); ++axis)
        safe[axis] = std::scalbn(direction[axis], -exponent);
    Chord<Real> chord = chordOf(safe);
    chord.entry = std::scalbn(chord.entry, -exponent);
    chord.exit = std::scalbn(chord.exit, -exponent);
    return chord;
}

// |origin + t direction| = 1, by the textbook; with two components, the same for the cylinder. Its
// discriminant loses digits with the square of the origin's distance, so a distant origin is first moved to
// the point of closest approach, where nothing cancels (Haines et al., Precision Improvements for Ray/Sphere
// Intersection, Ray Tracing Gems, ch. 7).
struct UnitBall {
    template <int n, class T>
    Chord<T> operator()(glm::vec<n, T, glm::defaultp> origin,
                        const glm::vec<n, T, glm::defaultp>& direction) const {
        const T a = glm::dot(direction, direction);
        if (!all(isSafeSquare(a))) return laneByLane<Chord<T>>(ofAnySize<n>, origin, direction);
        T b = glm::dot(origin, direction), c = glm::dot(origin, origin) - T(1), shift(0);
        const Truth<T> far = c > T(farSquared);
        if (any(far)) {
            shift = select(far, -b / a, shift);
            origin += shift * direction;
            b = select(far, glm::dot(origin, direction), b);
            c = select(far, glm::dot(origin, origin) - T(1), c);
        }
        const T discriminant = b * b - a * c;
        const Truth<T> hit = discriminant >= T(0);
        if (!any(hit)) {  // as if the root were 0
            const T closest = shift + (-b + T(0)) / a;
            return {hit, closest, closest, T(0), T(0)};
        }
        const T root = sqrt(select(discriminant > T(0), discriminant, T(0)));
        return {hit, shift + (-b - root) / a, shift + (-b + root) / a, T(0), T(0)};
    }

    template <int n>
    static Chord<Real> ofAnySize(const glm::vec<n, Real, glm::defaultp>& origin,
                                 const glm::vec<n, Real, glm::defaultp>& direction) {
        if (isSafeSquare(glm::dot(direction, direction))) return UnitBall()(origin, direction);
        return inSafeUnits(direction, [&](const auto& safe) { return UnitBall()(origin, safe); });
    }
};

struct SphereChord {
    template <class T>
    Chord<T> operator()(const ObjectRayT<T>& ray) const {
        return UnitBall()(ray.origin, ray.direction);
    }
};

struct CylinderChord {
    template <class T>
    Chord<T> operator()(const ObjectRayT<T>& ray) const {
        const Vec2T<T> origin(ray.origin.x, ray.origin.y);
        Vec2T<T> direction(ray.direction.x, ray.direction.y);
        // A line along the axis never meets the body.
        const Truth<T> along = (direction.x == T(0)) & (direction.y == T(0));
        direction.x = select(along, T(1), direction.x);
        Chord<T> chord = UnitBall()(origin, direction);
        if (any(along)) {
            chord.hit = (chord.hit & !along) | (along & (glm::dot(origin, origin) < T(1)));
            chord.entry = select(along, T(-infinity), chord.entry);
            chord.exit = select(along, T(infinity), chord.exit);
        }
        clipAxis(chord, ray.origin.z, ray.direction.z, 0, 1, 2, 1,
                 (ray.origin.z > T(0)) & (ray.origin.z < T(1)));
        closeChord(chord);
        return chord;
    }
};

// x^2 + y^2 - w^2 = 0 with w = 1 - z, the height below the apex: A t^2 + 2 B t + C = 0.
template <class T>
struct ConeRoots {
    Truth<T> real;   // a point of the line is on the double cone
    Truth<T> steep;  // A < 0: the line runs inside one nappe, then outside, then inside the other
    T low, high;     // the roots, low <= high
};

template <class T>
ConeRoots<T> coneRoots(const Vec3T<T>& p, const Vec3T<T>& d) {
    const T a = d.x * d.x + d.y * d.y - d.z * d.z;
    const T b = p.x * d.x + p.y * d.y - p.z * d.z;
    const T r = radius(p), c = (r - p.z) * (r + p.z);
    // B^2 - A C by Lagrange's identity for this form: products of differences instead of a difference of
    // products.
    const Vec3T<T> m = glm::cross(p, d);
    const T h = sqrt(m.x * m.x + m.y * m.y);
    const T discriminant = (h - abs(m.z)) * (h + abs(m.z));
    const T root = sqrt(max(discriminant, T(0)));
    const T q = -(b + copysign(root, b));
    const Truth<T> steep = a < T(0);
    const T first = q / a,
            second = c / q;  // a == 0: the first is infinite, on the side where the line stays outside
    const Truth<T> touching = q == T(0);  // both roots are 0
    // A steep line always passes the level of the apex, outside.
    const Truth<T> real = ((discriminant >= T(0)) | steep) & ((!touching) | !(a == T(0)));
    return {real, steep, select(touching, T(0), min(first, second)),
            select(touching, T(0), max(first, second))};
}

struct ConeChord {
    template <class T>
    Chord<T> operator()(const ObjectRayT<T>& ray) const {
        // From the closest approach to the middle of the axis, so that the coefficients are of order 1
        // (Haines et al.).
        const Vec3T<T> fromMiddle = ray.origin - Vec3T<T>(T(0), T(0), T(Real(0.5)));
        const T squared = glm::dot(ray.direction, ray.direction);
        if (!all(isSafeSquare(squared))) return laneByLane<Chord<T>>(ofAnySize, ray.origin, ray.direction);
        const T shift = -glm::dot(fromMiddle, ray.direction) / squared;
        const Vec3T<T> closest = ray.origin + shift * ray.direction;
        const Vec3T<T> p(closest.x, closest.y, T(1) - closest.z),
            d(ray.direction.x, ray.direction.y, -ray.direction.z);

        const ConeRoots<T> roots = coneRoots(p, d);
        const Truth<T> down = d.z > T(0);
        Chord<T> chord{roots.real, roots.low, roots.high, T(0), T(0)};
        // Of a steep line the part in the nappe below the apex.
        chord.entry = select(roots.steep, select(down, roots.high, T(-infinity)), chord.entry);
        chord.exit = select(roots.steep, select(down, T(infinity), roots.low), chord.exit);
        // w = 0 is no face but the apex, which belongs to the body.
        clipAxis(chord, p.z, d.z, 0, 1, 0, 1, (p.z >= T(0)) & (p.z < T(1)));
        closeChord(chord, shift);
        chord.entry += shift;
        chord.exit += shift;
        return chord;
    }

    static Chord<Real> ofAnySize(const Vec3& origin, const Vec3& direction) {
        if (isSafeSquare(glm::dot(direction, direction))) return ConeChord()(ObjectRay{origin, direction});
        return inSafeUnits(direction, [&](const Vec3& safe) { return ConeChord()(ObjectRay{origin, safe}); });
    }
};

struct CubeChord {
    template <class T>
    Chord<T> operator()(const ObjectRayT<T>& ray) const {
        Chord<T> chord{Truth<T>(T(0) == T(0)), T(-infinity), T(infinity), T(0), T(0)};
        for (int axis = 0; axis < 3; ++axis) {
            const T &origin = ray.origin[axis], &direction = ray.direction[axis];
            const auto highFace = static_cast<Real>(2 * axis);
            clipAxis(chord, origin, direction, -1, 1, highFace + 1, highFace, abs(origin) <= T(1));
        }
        closeChord(chord);
        return chord;
    }
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
