// What shapes with an equation have in common; and more of that, the convex solids.
//
// Every type of shape has what shapes.h and shape.cpp call: `type`, `isBall`, `faceName`, `support` (how far
// it reaches in a direction), `meet`, `touches`, `areCoherent`, `surface`, `periodic`. `Equation` gives
// `isBall`, `faceName`, `areCoherent`, `surface` and `periodic` to a type with `faces` (their names in the
// order of the assignment), `onSurface` (the point of its surface at a computed hit) and `texCoord`. `Solid`
// gives `meet` and `touches`, too, to a convex type with `chord` (the part of a line inside it), `offsets`
// (for each face a signed measure of a point's distance from it, negative inside, the greatest at most the
// Euclidean distance) and `offsetErrors` (what these are off by, where the point is off by that much along
// each axis). All in object space.
#pragma once

#include <array>

#include "raytracer/geometry/chord.h"
#include "raytracer/geometry/culling.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// A point of a surface and the normal there, which is not of unit length.
template <class T>
struct SurfacePoint {
    Vec3T<T> point, normal;
};

template <class Kind>
struct Equation {
    static constexpr bool isBall = false;  // FloatBox::ball, where the transform scales alike

    static std::string faceName(std::size_t face) { return Kind::faces[face]; }

    static Periodic periodic(const Shape&, std::uint32_t) { return {}; }

    template <class T>
    static bool areCoherent(const Shape&, const RayT<T>&, LaneBits) {
        return true;
    }

    // Of rays that all meet the same face.
    template <class T>
    static IntersectionT<T> surface(const Shape& shape, const RayT<T>& ray, const HitT<T>& hit) {
        const std::uint32_t face = faceOf(hit.primitive);
        const ObjectRayT<T> object = shape.transform().toObject(ray);
        const SurfacePoint<T> at = Kind::onSurface(Vec3T<T>(object.origin + hit.t * object.direction), face);
        IntersectionT<T> intersection = shape.place(hit, at.point, at.normal);
        if (shape.wantsTexCoord()) intersection.texCoord = Kind::texCoord(at.point, face);
        return intersection;
    }
};

template <class Kind>
struct Solid : Equation<Kind> {
    // Whether a point that is off by at most `error` may be on the surface: outside no face, and on one.
    template <class T>
    static Truth<T> mayTouch(const Vec3T<T>& point, const Vec3T<T>& error) {
        const auto offsets = Kind::offsets(point), errors = Kind::offsetErrors(error);
        Truth<T> within = offsets[0] <= errors[0], on = offsets[0] >= -errors[0];
        for (std::size_t face = 1; face < offsets.size(); ++face) {
            within = within & (offsets[face] <= errors[face]);
            on = on | (offsets[face] >= -errors[face]);
        }
        return within & on;
    }

    template <class T>
    static Truth<T> touches(const Shape& shape, const Vec3T<T>& point, const Vec3T<T>& pointError,
                            std::uint32_t = 0) {
        const Transform& transform = shape.transform();
        return mayTouch(transform.pointToObject(point), transform.objectError(point, pointError));
    }

    // The part of any line inside the solid. Of one that comes from afar by its point that is closest to the
    // solid: all faces have the roundings of that one point, and so no seams.
    template <class T>
    static Chord<T> chordOf(const ObjectRayT<T>& ray) {
        if (!any(glm::dot(ray.origin, ray.origin) > T(distantSquared)))
            return Kind::chord(ray.origin, ray.direction);
        return inSafeUnits(ray.origin, ray.direction, [](auto origin, const auto& direction, const auto& a) {
            const auto shift = moveCloser(origin, direction, a);
            auto chord = Kind::chord(origin, direction);
            chord.entry += shift;
            chord.exit += shift;
            return chord;
        });
    }

    // What a chord means for a ray: entry or exit, or neither because the ray starts there.
    template <class T>
    static void meet(const Shape& shape, const RayT<T>& ray, HitQueryT<T>& query) {
        const bool leavesThis = ray.departure.shape == &shape;
        if (leavesThis && !ray.departure.inside) return;
        const ObjectRayT<T> object = shape.transform().toObject(ray);
        if (!ray.departure.shape && any(mayTouch(object.origin, Vec3T<T>(T(coincidenceWindow))))) {
            if constexpr (laneCountOf<T> == 1) {
                if (meetOrigin(shape, ray, object, query)) return;
            } else {
                return meetAlone(ray, query,
                                 [&](int, const Ray& one, HitQuery& alone) { shape.intersect(one, alone); });
            }
        }
        query.count();
        const Chord<T> chord = chordOf(object);
        const Truth<T> never = T(0) < T(0);
        if (leavesThis) return query.offerFace(!never, max(T(0), chord.exit), shape, chord.exitFace, never);

        Truth<T> entering = chord.entry >= T(0);
        const T first = select(entering, chord.entry, chord.exit);
        Truth<T> hit = chord.hit & (chord.exit >= T(0)) & !(first > query.limit());
        if (!any(hit)) return;
        if (ray.departure.shape) {
            // Where one of the chord's ends is the ray's origin, it is the one nearer to it, and only the
            // other counts.
            const Truth<T> starts = hit & touches(shape, ray.origin, ray.departure.positionError);
            hit = hit & !(starts & (abs(chord.exit) < abs(chord.entry)));
            entering = entering & !starts;
        }
        query.offerFace(hit, select(entering, chord.entry, chord.exit), shape,
                        select(entering, chord.entryFace, chord.exitFace), entering);
    }

  private:
    // A ray of the camera that starts on the surface meets it there: by its origin, the same for all of them.
    // The rounded t of a chord lies on either side of 0.
    static bool meetOrigin(const Shape& shape, const Ray& ray, const ObjectRay& object, HitQuery& query) {
        const Transform& transform = shape.transform();
        const Vec3 error = transform.objectError(ray.origin, transform.writtenError(ray.origin));
        if (!mayTouch(object.origin, error)) return false;
        const auto offsets = Kind::offsets(object.origin), errors = Kind::offsetErrors(error);
        std::uint32_t face = 0;
        while (offsets[face] < -errors[face]) ++face;
        const Vec3 normal = Kind::onSurface(object.origin, face).normal;
        query.count();
        query.offer(true, 0, shape, face, glm::dot(normal, object.direction) < 0);
        return true;
    }
};

inline constexpr Real pi = static_cast<Real>(3.14159265358979323846264338327950288L);

template <class T>
T clamp(const T& x, Real low, Real high) {
    return min(max(x, T(low)), T(high));
}

// The angle about the z axis as a fraction of a turn, in [0, 1).
template <class T>
T turn(const Vec3T<T>& p) {
    const auto one = [](Real y, Real x) {
        const Real u = arcTangent(y, x) / (2 * pi);
        return u < 0 ? u + 1 : u;
    };
    return laneByLane<T>(one, p.y, p.x);
}

template <class T>
Vec2T<T> capTexCoord(const Vec3T<T>& p) {
    return {(p.x + T(1)) / T(2), (p.y + T(1)) / T(2)};
}

// Of a body round about the z axis, or of its caps.
template <class T>
Vec2T<T> roundTexCoord(const Vec3T<T>& p, bool body) {
    return body ? Vec2T<T>(turn(p), p.z) : capTexCoord(p);
}

// Puts a point back onto the unit sphere; one without z, onto the circle. By one Newton step for 1 / sqrt
// where that is exact to rounding.
template <class T>
Vec3T<T> ontoUnit(const Vec3T<T>& p) {
    const T squared = glm::dot(p, p);
    const Truth<T> close = abs(squared - T(1)) < T(coincidenceWindow);
    const Vec3T<T> near = p * (T(Real(1.5)) - squared / T(2));
    return all(close) ? near : select(close, near, normalized(p));
}

// Rounding may put the hit of a ray that comes from very far into the very centre, where there is no
// direction outwards: then any.
template <class T>
Vec3T<T> offCenter(const Vec3T<T>& p) {
    const Truth<T> center = (p.x == T(0)) & (p.y == T(0)) & (p.z == T(0));
    return {select(center, T(1), p.x), p.y, p.z};
}

// Of cylinder and cone: a cap's point is within the rim, a body's on the circle.
template <class T>
Vec3T<T> withinCircle(const Vec3T<T>& p, bool body) {
    const Truth<T> onto = body ? T(0) == T(0) : glm::dot(p, p) > T(1);
    return any(onto) ? select(onto, ontoUnit(offCenter(p)), p) : p;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
