// Chords by directions of any size: what is rare, and not for several rays at once.
#include "raytracer/geometry/chord.h"

#include "raytracer/geometry/cone.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// By the same direction in other units, where its own squared length is not safe.
template <int n, class ChordOf>
Chord<Real> inSafeUnits(const glm::vec<n, Real, glm::defaultp>& direction, ChordOf chordOf) {
    if (isSafeSquare(glm::dot(direction, direction))) return chordOf(direction);
    Real largest = 0;
    for (int axis = 0; axis < n; ++axis) largest = std::max(largest, std::abs(direction[axis]));
    if (!(largest > 0 && largest < infinity)) return {};
    const int exponent = std::ilogb(largest);
    glm::vec<n, Real, glm::defaultp> safe;
    for (int axis = 0; axis < n; ++axis) safe[axis] = std::scalbn(direction[axis], -exponent);
    Chord<Real> chord = chordOf(safe);
    chord.entry = std::scalbn(chord.entry, -exponent);
    chord.exit = std::scalbn(chord.exit, -exponent);
    return chord;
}

}  // namespace

Chord<Real> UnitBall::ofAnySize(const Vec2& origin, const Vec2& direction) {
    return inSafeUnits(direction, [&](const Vec2& safe) { return UnitBall()(origin, safe); });
}

Chord<Real> UnitBall::ofAnySize(const Vec3& origin, const Vec3& direction) {
    return inSafeUnits(direction, [&](const Vec3& safe) { return UnitBall()(origin, safe); });
}

Chord<Real> Cone::chordOfAnySize(const Vec3& origin, const Vec3& direction) {
    return inSafeUnits(direction, [&](const Vec3& safe) { return chord(ObjectRay{origin, safe}); });
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
