// x^2 + y^2 + z^2 = 1.
#pragma once

#include "raytracer/geometry/solid.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct Sphere : Solid<Sphere> {
    static constexpr ShapeType type = ShapeType::Sphere;
    static constexpr const char* faces[] = {""};
    static constexpr bool isBall = true;

    template <class T>
    static Chord<T> chord(const Vec3T<T>& origin, const Vec3T<T>& direction) {
        return inSafeUnits(origin, direction,
                           [](const auto& o, const auto& d, const auto& a) { return ballChord(o, d, a); });
    }

    template <class T>
    static std::array<T, 1> offsets(const Vec3T<T>& p) {
        return {sqrt(glm::dot(p, p)) - T(1)};
    }

    template <class T>
    static std::array<T, 1> offsetErrors(const Vec3T<T>& error) {
        return {error.x + error.y + error.z};
    }

    static Real support(const Vec3& n) { return sqrt(glm::dot(n, n)); }

    template <class T>
    static SurfacePoint<T> onSurface(const Vec3T<T>& p, std::uint32_t) {
        const Vec3T<T> normal = offCenter(p);
        return {ontoUnit(normal), normal};
    }

    static Periodic periodic(const Shape&, std::uint32_t) { return {.u = true}; }

    template <class T>
    static Vec2T<T> texCoord(const Vec3T<T>& p, std::uint32_t) {
        const auto height = [](Real z) { return 1 - arcCosine(glm::clamp(z, Real(-1), Real(1))) / pi; };
        return {turn(p), laneByLane<T>(height, p.z)};
    }
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
