// x^2 + y^2 = 1, 0 < z < 1 (face 0), top z = 1 (1), bottom z = 0 (2).
#pragma once

#include "raytracer/geometry/solid.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct Cylinder : Solid<Cylinder> {
    static constexpr ShapeType type = ShapeType::Cylinder;
    static constexpr const char* faces[] = {"body", "top", "bottom"};

    // The chord of the body, as of a circle in x and y, clipped by the caps.
    template <class T>
    static Chord<T> chord(const Vec3T<T>& from, const Vec3T<T>& way) {
        const Vec2T<T> origin(from.x, from.y);
        Vec2T<T> direction(way.x, way.y);
        // A line parallel to the axis never meets the body.
        const Truth<T> along = (direction.x == T(0)) & (direction.y == T(0));
        direction.x = select(along, T(1), direction.x);
        Chord<T> chord = inSafeUnits(origin, direction, [](const auto& o, const auto& d, const auto& a) {
            return ballChord(o, d, a);
        });
        if (any(along)) {
            chord.hit = (chord.hit & !along) | (along & (glm::dot(origin, origin) < T(1)));
            chord.entry = select(along, T(-infinity), chord.entry);
            chord.exit = select(along, T(infinity), chord.exit);
        }
        const T &z = from.z, &dz = way.z;
        clipAxis(chord, dz, (T(0) - z) / dz, (T(1) - z) / dz, 2, 1, (z > T(0)) & (z < T(1)));
        closeChord(chord);
        return chord;
    }

    template <class T>
    static std::array<T, 3> offsets(const Vec3T<T>& p) {
        return {radius(p) - T(1), p.z - T(1), -p.z};
    }

    template <class T>
    static std::array<T, 3> offsetErrors(const Vec3T<T>& error) {
        return {error.x + error.y, error.z, error.z};
    }

    static Real support(const Vec3& n) { return radius(n) + max(n.z, Real(0)); }

    template <class T>
    static SurfacePoint<T> onSurface(Vec3T<T> p, std::uint32_t face) {
        const bool body = face == 0;
        const T z = body ? clamp(p.z, 0, 1) : T(Real(face == 1));
        p.z = T(0);
        const Vec3T<T> normal = body ? offCenter(p) : Vec3T<T>(T(0), T(0), T(2) * z - T(1));
        p = withinCircle(p, body);
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
