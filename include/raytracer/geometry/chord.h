// The chord of a line in a convex solid, and the parts that the solids compute theirs from.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "raytracer/numerics/numerics.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// The part of a line inside a convex solid, as an interval of the ray's t. A face is stored as a T, so that
// `select` chooses it with the same masks as t.
template <class T>
struct Chord {
    Truth<T> hit;
    T entry, exit;  // entry <= exit where hit; exit also serves a ray known to start inside, hit or not
    T entryFace, exitFace;
};
template <class T>
inline constexpr int laneCountOf<Chord<T>> = laneCountOf<T>;
template <class T>
void setLane(Chord<T>& to, int lane, const Chord<Real>& chord) {
    setLane(to.hit, lane, chord.hit);
    setLane(to.entry, lane, chord.entry);
    setLane(to.exit, lane, chord.exit);
    setLane(to.entryFace, lane, chord.entryFace);
    setLane(to.exitFace, lane, chord.exitFace);
}

template <class T>
T radius(const Vec3T<T>& p) {
    return sqrt(p.x * p.x + p.y * p.y);
}

// Clips the chord to the slab between two planes perpendicular to an axis, which the line meets at t `toLow`
// and `toHigh`. In a tie the chord keeps the face that it has: callers clip by the preferred face first. A
// line parallel to the planes is inside or outside of the slab as a whole (`within`).
template <class T>
void clipAxis(Chord<T>& chord, const T& direction, const T& toLow, const T& toHigh, Real lowFace,
              Real highFace, const Truth<T>& within) {
    const Truth<T> rising = direction > T(0), still = direction == T(0);
    T entry = select(rising, toLow, toHigh), exit = select(rising, toHigh, toLow);
    if (any(still)) {
        entry = select(still, T(-infinity), entry);
        exit = select(still, T(infinity), exit);
        chord.hit = chord.hit & ((!still) | within);
    }
    const Truth<T> later = entry > chord.entry, earlier = exit < chord.exit;
    chord.entryFace = select(later, select(rising, T(lowFace), T(highFace)), chord.entryFace);
    chord.entry = select(later, entry, chord.entry);
    chord.exitFace = select(earlier, select(rising, T(highFace), T(lowFace)), chord.exitFace);
    chord.exit = select(earlier, exit, chord.exit);
}

// Solids are closed: a line that only touches an edge or a rim hits it. Rounding of the two faces' t (a
// quotient, a root of a quadratic) may have put the exit before the entry there, so some slack is allowed.
// Such a chord becomes the single point `entry`, with the face that faces the ray. The same serves a thin
// solid seen from afar, whose two faces have one t. shift: how far along the line the origin of t has been
// moved; the slack also covers the rounding of that move.
template <class T>
void closeChord(Chord<T>& chord, const T& shift = T(0)) {
    const T slack = T(gamma(16)) * max(abs(shift), max(abs(chord.entry), abs(chord.exit)));
    chord.hit = chord.hit & (chord.entry <= chord.exit + slack);
    const Truth<T> single = chord.hit & !(chord.entry < chord.exit);
    if (!any(single)) return;
    chord.exit = select(single, chord.entry, chord.exit);
}

// Solves |origin + t direction| = 1 by the quadratic formula: the unit sphere, or with two components the
// cylinder's body. The discriminant loses digits with the square of the origin's distance. A far origin is
// therefore first moved to the line's point of closest approach, where nothing cancels (Haines et al.,
// Precision Improvements for Ray/Sphere Intersection, Ray Tracing Gems, ch. 7). a: the direction's squared
// length, which must be safe (isSafeSquare).
template <int n, class T>
Chord<T> ballChord(glm::vec<n, T, glm::defaultp> origin, const glm::vec<n, T, glm::defaultp>& direction,
                   const T& a) {
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
    if (!any(hit)) {  // as below, with a root of 0
        const T closest = shift + (-b + T(0)) / a;
        return {hit, closest, closest, T(0), T(0)};
    }
    const T root = sqrt(select(discriminant > T(0), discriminant, T(0)));
    return {hit, shift + (-b - root) / a, shift + (-b + root) / a, T(0), T(0)};
}

// The chord of a line whose direction has a squared length that over- or underflows, such as that of a shadow
// ray to a light 1e-200 away. The direction is first scaled by a power of two, so that its largest component
// is in [1, 2). A direction that is zero or not finite has no chord.
template <int n, class ChordOf>
Chord<Real> scaledChord(const glm::vec<n, Real, glm::defaultp>& origin,
                        const glm::vec<n, Real, glm::defaultp>& direction, ChordOf chordOf) {
    Real largest = 0;
    for (int axis = 0; axis < n; ++axis) {
        if (!std::isfinite(direction[axis])) return {};
        largest = std::max(largest, std::abs(direction[axis]));
    }
    if (largest == 0) return {};
    const int exponent = std::ilogb(largest);
    glm::vec<n, Real, glm::defaultp> safe;
    for (int axis = 0; axis < n; ++axis) safe[axis] = std::scalbn(direction[axis], -exponent);
    Chord<Real> chord = chordOf(origin, safe, glm::dot(safe, safe));
    chord.entry = std::scalbn(chord.entry, -exponent);
    chord.exit = std::scalbn(chord.exit, -exponent);
    return chord;
}

// Lane by lane, where some direction's length is not safe.
template <int n, class T, class ChordOf>
[[gnu::noinline, gnu::cold]] Chord<T> chordsAlone(const glm::vec<n, T, glm::defaultp>& origin,
                                                  const glm::vec<n, T, glm::defaultp>& direction,
                                                  ChordOf chordOf) {
    using Vector = glm::vec<n, Real, glm::defaultp>;
    return laneByLane<Chord<T>>(
        [chordOf](const Vector& from, const Vector& way) -> Chord<Real> {
            const Real squared = glm::dot(way, way);
            return isSafeSquare(squared) ? chordOf(from, way, squared) : scaledChord(from, way, chordOf);
        },
        origin, direction);
}

// Calls chordOf(origin, direction, squared length of the direction), for a direction of any length. Inlined:
// the chords of eight lanes are more than the registers hold.
template <int n, class T, class ChordOf>
[[gnu::always_inline]] inline Chord<T> inSafeUnits(const glm::vec<n, T, glm::defaultp>& origin,
                                                   const glm::vec<n, T, glm::defaultp>& direction,
                                                   ChordOf chordOf) {
    const T squared = glm::dot(direction, direction);
    if (all(isSafeSquare(squared))) return chordOf(origin, direction, squared);
    return chordsAlone(origin, direction, chordOf);
}

// Moves a distant origin to the line's point closest to zero, and returns the t of that move. squared: the
// direction's squared length. Each move leaves a rounding error along the line: for a shape that is 1e-20
// thick, many thicknesses. The next move reduces that error by as many digits again; `moves` are enough for
// Real's whole range of exponents. The moves end where one is less than half of the digits of the distance
// that is left: no other would bring the line closer, and it passes the shape by.
template <class T>
T moveCloser(Vec3T<T>& origin, const Vec3T<T>& direction, const T& squared) {
    constexpr int moves = 2 * std::numeric_limits<Real>::max_exponent / std::numeric_limits<Real>::digits;
    T shift(0), distance = glm::dot(origin, origin);
    Truth<T> moving = distance > T(distantSquared);
    for (int i = 0; i < moves && any(moving); ++i) {
        const T move = select(moving, -glm::dot(origin, direction) / squared, T(0));
        shift += move;
        origin += move * direction;
        distance = glm::dot(origin, origin);
        const Truth<T> passes = move * move * squared < distance * T(unitRoundoff);
        moving = moving & (distance > T(distantSquared)) & !passes;
    }
    return shift;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
