// x^2 + y^2 = (1 - z)^2, 0 < z <= 1 (face 0), bottom z = 0 (1).
#pragma once

#include "raytracer/geometry/solid.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Where a line meets the double cone x^2 + y^2 - w^2 = 0, with w = 1 - z the depth below the apex: the roots
// of A t^2 + 2 B t + C = 0.
template <class T>
struct ConeRoots {
    Truth<T> real;   // the line meets the double cone
    Truth<T> steep;  // A < 0: the line runs inside one nappe, then outside, then inside the other
    T low, high;     // the roots, low <= high

    // For the line p + t d, whose third coordinate is w instead of z.
    ConeRoots(const Vec3T<T>& p, const Vec3T<T>& d) {
        const T a = d.x * d.x + d.y * d.y - d.z * d.z;
        const T b = p.x * d.x + p.y * d.y - p.z * d.z;
        const T r = radius(p), c = (r - p.z) * (r + p.z);
        // B^2 - A C would cancel. It is m.x^2 + m.y^2 - m.z^2 with m = p x d (Lagrange's identity for this
        // form), computed in factors.
        const Vec3T<T> m = glm::cross(p, d);
        const T h = sqrt(m.x * m.x + m.y * m.y);
        const T discriminant = (h - abs(m.z)) * (h + abs(m.z));
        const T root = sqrt(max(discriminant, T(0)));
        const T q = -(b + copysign(root, b));
        steep = a < T(0);
        // a == 0: `first` is infinite, on the side where the line stays inside.
        const T first = q / a, second = c / q;
        const Truth<T> touching = q == T(0);  // both roots are 0
        // A steep line always has roots: where it crosses the plane w = 0 of the apex, it is not inside.
        real = ((discriminant >= T(0)) | steep) & ((!touching) | !(a == T(0)));
        low = select(touching, T(0), min(first, second));
        high = select(touching, T(0), max(first, second));
    }
};

struct Cone : Solid<Cone> {
    static constexpr ShapeType type = ShapeType::Cone;
    static constexpr const char* faces[] = {"body", "bottom"};

    template <class T>
    static Chord<T> chord(const Vec3T<T>& origin, const Vec3T<T>& direction) {
        return inSafeUnits(origin, direction, [](const auto& o, const auto& d, const auto& squared) {
            return chordOfSafe(o, d, squared);
        });
    }

    template <class T>
    static Chord<T> chordOfSafe(const Vec3T<T>& origin, const Vec3T<T>& direction, const T& squared) {
        // Starts from the line's point closest to the middle of the axis, so that the coefficients are of
        // order 1 (Haines et al., as in ballChord).
        const T shift = -glm::dot(origin - Vec3T<T>(T(0), T(0), T(Real(0.5))), direction) / squared;
        const Vec3T<T> closest = origin + shift * direction;
        const Vec3T<T> p(closest.x, closest.y, T(1) - closest.z), d(direction.x, direction.y, -direction.z);

        const ConeRoots<T> roots(p, d);
        const Truth<T> down = d.z > T(0);
        Chord<T> chord{roots.real, roots.low, roots.high, T(0), T(0)};
        // A steep line is inside both nappes: the chord is its part in the nappe below the apex.
        chord.entry = select(roots.steep, select(down, roots.high, T(-infinity)), chord.entry);
        chord.exit = select(roots.steep, select(down, T(infinity), roots.low), chord.exit);
        // The slab 0 <= w <= 1. The plane w = 0 is not a face: it meets the solid only at the apex, which
        // belongs to the body. The base's t is computed from the ray's own origin, which may be nearer to the
        // base than the rounding error of the shift.
        const T toApex = (T(0) - p.z) / d.z, toBase = (T(0) - origin.z) / direction.z;
        clipAxis(chord, d.z, toApex, toBase - shift, 0, 1, (p.z >= T(0)) & (p.z < T(1)));
        closeChord(chord, shift);
        chord.entry = select(chord.entryFace == T(1), toBase, chord.entry + shift);
        chord.exit = max(chord.entry, select(chord.exitFace == T(1), toBase, chord.exit + shift));
        return chord;
    }

    template <class T>
    static std::array<T, 2> offsets(const Vec3T<T>& p) {
        constexpr auto perpendicular =
            static_cast<Real>(0.70710678118654752440084436210484904L);  // sqrt(1/2): a slope of 45 degrees
        return {(radius(p) - (T(1) - p.z)) * T(perpendicular), -p.z};
    }

    template <class T>
    static std::array<T, 2> offsetErrors(const Vec3T<T>& error) {
        return {error.x + error.y + error.z, error.z};
    }

    // The farthest point is on the rim of the base or at the apex.
    static Real support(const Vec3& n) { return max(radius(n), n.z); }

    template <class T>
    static SurfacePoint<T> onSurface(Vec3T<T> p, std::uint32_t face) {
        const bool body = face == 0;
        const T z = body ? clamp(p.z, 0, 1) : T(0), w = T(1) - z;
        p.z = T(0);
        p = withinCircle(p, body);
        if (body) p = w * p;
        Vec3T<T> normal(T(0), T(0), T(-1));
        if (body) {  // the normal at the apex is +z
            const Truth<T> below = w > T(0);
            normal = {select(below, p.x, T(0)), select(below, p.y, T(0)), select(below, w, T(1))};
        }
        p.z = z;
        return {p, normal};
    }

    static Periodic periodic(const Shape&, std::uint32_t face) { return {.u = face == 0}; }

    template <class T>
    static Vec2T<T> texCoord(const Vec3T<T>& p, std::uint32_t face) {
        return roundTexCoord(p, face == 0);
    }
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
