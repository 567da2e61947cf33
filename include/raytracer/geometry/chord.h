// The part of a line inside a convex solid: what the solids' chords are made of.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <glm/geometric.hpp>

#include "raytracer/numerics/numerics.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// The part of a line inside a convex solid, in t of the ray. A face is a number of T, so that it is chosen as
// the t are.
template <class T>
struct Chord {
    Truth<T> hit;
    T entry, exit;  // entry <= exit where hit; exit is meaningful for a line through the inside regardless
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

// Narrows the chord to the part between two planes across an axis, of t `toLow` and `toHigh`. Ties keep the
// face that is there, which the caller has put there because it comes first. A line that does not move along
// this axis is in or out as a whole (`within`).
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

// Solids are closed: an edge or a rim that is met in a single point counts, though the roundings of the two
// faces' t (of a quotient, of a quadratic's root) may have put the exit there before the entry. Of two faces
// with one t, as those of a thin solid from afar, the entry faces the ray. shift: how far along the line the
// origin of t has been moved, which has its own rounding.
template <class T>
void closeChord(Chord<T>& chord, const T& shift = T(0)) {
    const T slack = T(gamma(16)) * max(abs(shift), max(abs(chord.entry), abs(chord.exit)));
    chord.hit = chord.hit & (chord.entry <= chord.exit + slack);
    const Truth<T> single = chord.hit & !(chord.entry < chord.exit);
    if (!any(single)) return;
    chord.exit = select(single, chord.entry, chord.exit);
}

// |origin + t direction| = 1, by the textbook; with two components, the same for the cylinder. Its
// discriminant loses digits with the square of the origin's distance, so a far origin is first moved to
// the point of closest approach, where nothing cancels (Haines et al., Precision Improvements for Ray/Sphere
// Intersection, Ray Tracing Gems, ch. 7). a: the direction's squared length, which is safe.
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
    if (!any(hit)) {  // as if the root were 0
        const T closest = shift + (-b + T(0)) / a;
        return {hit, closest, closest, T(0), T(0)};
    }
    const T root = sqrt(select(discriminant > T(0), discriminant, T(0)));
    return {hit, shift + (-b - root) / a, shift + (-b + root) / a, T(0), T(0)};
}

// chordOf(origin, direction, its squared length), for any direction. Where its squared length is not safe,
// such as a shadow ray's to a light 1e-200 away, by the same direction in other units: the largest component
// is then in [1, 2). A direction that is zero or not finite has no line.
template <int n, class T, class ChordOf>
Chord<T> inSafeUnits(const glm::vec<n, T, glm::defaultp>& origin,
                     const glm::vec<n, T, glm::defaultp>& direction, ChordOf chordOf) {
    using Vector = glm::vec<n, Real, glm::defaultp>;
    const T squared = glm::dot(direction, direction);
    if (all(isSafeSquare(squared))) return chordOf(origin, direction, squared);
    const auto alone = [chordOf](const Vector& from, const Vector& way) -> Chord<Real> {
        const Real ownSquare = glm::dot(way, way);
        if (isSafeSquare(ownSquare)) return chordOf(from, way, ownSquare);
        Real largest = 0;
        for (int axis = 0; axis < n; ++axis) {
            if (!std::isfinite(way[axis])) return {};
            largest = std::max(largest, std::abs(way[axis]));
        }
        if (largest == 0) return {};
        const int exponent = std::ilogb(largest);
        Vector safe;
        for (int axis = 0; axis < n; ++axis) safe[axis] = std::scalbn(way[axis], -exponent);
        Chord<Real> chord = chordOf(from, safe, glm::dot(safe, safe));
        chord.entry = std::scalbn(chord.entry, -exponent);
        chord.exit = std::scalbn(chord.exit, -exponent);
        return chord;
    };
    return laneByLane<Chord<T>>(alone, origin, direction);
}

// Moves an origin, where it is distant, to the point of the line that is closest to zero, and returns how
// far along the line. squared: the direction's squared length. A move leaves its own rounding error: along
// the line of a shape that is 1e-20 thick, a distance of many thicknesses. Each further one leaves that part
// of what the one before has left. A line is as near as it comes where a move is below half of the digits of
// its distance, and passes the shape by.
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
        const Truth<T> passes = move * move * squared < distance / T(passingSquared);
        moving = moving & (distance > T(distantSquared)) & !passes;
    }
    return shift;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
