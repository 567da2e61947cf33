// Chords by directions of any size: what is rare, and not for several rays at once.
#include "raytracer/geometry/chord.h"

#include "raytracer/geometry/cone.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// chordOf(direction, its squared length) by the same direction in other units, where its own squared length
// is not safe: the largest component is then in [1, 2), and the square in [1, 12), so chordOf needs no third.
// A direction that is zero or not finite has no line.
template <int n, class ChordOf>
Chord<Real> inSafeUnits(const glm::vec<n, Real, glm::defaultp>& direction, ChordOf chordOf) {
    const Real squared = glm::dot(direction, direction);
    if (isSafeSquare(squared)) return chordOf(direction, squared);
    Real largest = 0;
    for (int axis = 0; axis < n; ++axis) {
        if (!std::isfinite(direction[axis])) return {};
        largest = std::max(largest, std::abs(direction[axis]));
    }
    if (largest == 0) return {};
    const int exponent = std::ilogb(largest);
    glm::vec<n, Real, glm::defaultp> safe;
    for (int axis = 0; axis < n; ++axis) safe[axis] = std::scalbn(direction[axis], -exponent);
    Chord<Real> chord = chordOf(safe, glm::dot(safe, safe));
    chord.entry = std::scalbn(chord.entry, -exponent);
    chord.exit = std::scalbn(chord.exit, -exponent);
    return chord;
}

}  // namespace

Chord<Real> UnitBall::ofAnySize(const Vec2& origin, const Vec2& direction) {
    return inSafeUnits(direction, [&](const Vec2& safe, Real a) { return ofSafeSquare(origin, safe, a); });
}

Chord<Real> UnitBall::ofAnySize(const Vec3& origin, const Vec3& direction) {
    return inSafeUnits(direction, [&](const Vec3& safe, Real a) { return ofSafeSquare(origin, safe, a); });
}

Chord<Real> Cone::chordOfAnySize(const Vec3& origin, const Vec3& direction) {
    return inSafeUnits(
        direction, [&](const Vec3& safe, Real squared) { return chordOfSafeSquare(origin, safe, squared); });
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
