// -1 <= x, y, z <= 1; faces x = 1 (0), x = -1 (1), y = 1 (2), y = -1 (3), z = 1 (4), z = -1 (5).
#pragma once

#include "raytracer/geometry/solid.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct Cube : Solid<Cube> {
    static constexpr ShapeType type = ShapeType::Cube;
    static constexpr const char* faces[] = {"x = 1", "x = -1", "y = 1", "y = -1", "z = 1", "z = -1"};

    template <class T>
    static Chord<T> chord(const Vec3T<T>& from, const Vec3T<T>& along) {
        Chord<T> chord{Truth<T>(T(0) == T(0)), T(-infinity), T(infinity), T(0), T(0)};
        for (int axis = 0; axis < 3; ++axis) {
            const T &origin = from[axis], &direction = along[axis];
            const auto highFace = static_cast<Real>(2 * axis);
            clipAxis(chord, direction, (T(-1) - origin) / direction, (T(1) - origin) / direction,
                     highFace + 1, highFace, abs(origin) <= T(1));
        }
        closeChord(chord);
        return chord;
    }

    template <class T>
    static std::array<T, 6> offsets(const Vec3T<T>& p) {
        return {p.x - T(1), -p.x - T(1), p.y - T(1), -p.y - T(1), p.z - T(1), -p.z - T(1)};
    }

    template <class T>
    static std::array<T, 6> offsetErrors(const Vec3T<T>& error) {
        return {error.x, error.x, error.y, error.y, error.z, error.z};
    }

    static Real support(const Vec3& n) { return abs(n.x) + abs(n.y) + abs(n.z); }

    template <class T>
    static SurfacePoint<T> onSurface(const Vec3T<T>& q, std::uint32_t face) {
        Vec3T<T> p(clamp(q.x, -1, 1), clamp(q.y, -1, 1), clamp(q.z, -1, 1)), normal(T(0));
        const int axis = static_cast<int>(face / 2);
        p[axis] = normal[axis] = T(face % 2 == 0 ? 1 : -1);
        return {p, normal};
    }

    template <class T>
    static Vec2T<T> texCoord(const Vec3T<T>& p, std::uint32_t face) {
        const int axis = static_cast<int>(face / 2), first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
        return {(p[first] + T(1)) / T(2), (p[second] + T(1)) / T(2)};
    }
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
