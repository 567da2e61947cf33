// What the shapes with an equation have in common (Equation), and what convex solids add to that (Solid).
//
// Every type of shape has `type`, `isBall`, `faceName`, `support` (the largest n . p of its points p),
// `meet`, `touches`, `areCoherent`, `surface` and `periodic`; visit() of shapes.h calls them.
//
// `Equation` gives `isBall`, `faceName`, `areCoherent`, `surface` and `periodic` to a type that has
//   - `faces`, their names in the order of the assignment;
//   - `onSurface`, the surface's point at a computed hit;
//   - `texCoord`.
// `Solid` also gives `meet` and `touches` to a convex type that has
//   - `chord`, the part of a line inside it, for an origin that is not distant (chordOf);
//   - `offsets`, for each face a signed measure of a point's distance from it, negative inside. The greatest
//     is at most the Euclidean distance;
//   - `offsetErrors`, the errors of these if the point has the given error along each axis.
// All in object space.
#pragma once

#include "raytracer/geometry/chord.h"
#include "raytracer/geometry/culling.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// A point of a surface and the normal there, which need not have unit length.
template <class T>
struct SurfacePoint {
    Vec3T<T> point, normal;
};

template <class Kind>
struct Equation {
    static constexpr bool isBall = false;  // FloatBox::ball, where the transform is uniform

    static std::string faceName(std::size_t face) { return Kind::faces[face]; }

    static Periodic periodic(const Shape&, std::uint32_t) { return {}; }

    template <class T>
    static bool areCoherent(const Shape&, const RayT<T>&, LaneBits) {
        return true;
    }

    // The hit's point in object space, before onSurface projects it.
    template <class T>
    static Vec3T<T> pointOf(const Shape&, const RayT<T>&, const ObjectRayT<T>& object, const HitT<T>& hit) {
        return object.origin + hit.t * object.direction;
    }

    // For rays that all hit the same face.
    template <class T>
    static IntersectionT<T> surface(const Shape& shape, const RayT<T>& ray, const HitT<T>& hit) {
        const std::uint32_t face = faceOf(hit.primitive);
        const ObjectRayT<T> object = shape.transform().toObject(ray);
        const SurfacePoint<T> at = Kind::onSurface(Kind::pointOf(shape, ray, object, hit), face);
        IntersectionT<T> intersection = shape.place(hit, at.point, at.normal);
        if (shape.wantsTexCoord()) intersection.texCoord = Kind::texCoord(at.point, face);
        return intersection;
    }
};

template <class Kind>
struct Solid : Equation<Kind> {
    // Whether a point known to within `error` may be on the surface: outside of no face, and on at least one.
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

    // The part of any line inside the solid. A distant ray is first moved to the line's point closest to the
    // solid. All faces then share the rounding error of that one point, so there are no seams between them.
    template <class T>
    static Chord<T> chordOf(const ObjectRayT<T>& ray) {
        if (!any(glm::dot(ray.origin, ray.origin) > T(distantSquared)))
            return Kind::chord(ray.origin, ray.direction);
        return distantChordOf(ray);
    }

    template <class T>
    [[gnu::noinline, gnu::cold]] static Chord<T> distantChordOf(const ObjectRayT<T>& ray) {
        return inSafeUnits(ray.origin, ray.direction, [](auto origin, const auto& direction, const auto& a) {
            using Number = std::remove_cvref_t<decltype(a)>;
            const auto shift = moveCloser(origin, direction, a);
            auto chord = Kind::chord(origin, direction);
            // A line that is still distant passes the solid by; its squares may have overflowed.
            chord.hit = chord.hit & (glm::dot(origin, origin) <= Number(distantSquared));
            chord.entry += shift;
            chord.exit += shift;
            return chord;
        });
    }

    template <class T>
    static Vec3T<T> pointOf(const Shape& shape, const RayT<T>& ray, const ObjectRayT<T>& object,
                            const HitT<T>& hit) {
        const bool leavesThis = ray.departure.shape == &shape;
        if (any(isDistant(object.origin)) || (leavesThis && any(hit.t <= T(0)))) {
            const auto alone = [&](const Ray& one, const Real& t) {
                return endOfChord(shape, one, t, hit.entering);
            };
            return laneByLane<Vec3T<T>>(alone, ray, hit.t);
        }
        return Equation<Kind>::pointOf(shape, ray, object, hit);
    }

    // Finds the ray's hit by the chord of its line: the entry or the exit, but not an end at which the ray
    // starts.
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
            // If the ray starts on the surface, the chord's end nearer to t = 0 is its origin. Only the other
            // end can be a hit.
            const Truth<T> starts = hit & touches(shape, ray.origin, ray.departure.positionError);
            hit = hit & !(starts & (abs(chord.exit) < abs(chord.entry)));
            entering = entering & !starts;
        }
        query.offerFace(hit, select(entering, chord.entry, chord.exit), shape,
                        select(entering, chord.entryFace, chord.exitFace), entering);
    }

  private:
    // True for NaN, too.
    template <class T>
    static Truth<T> isDistant(const Vec3T<T>& origin) {
        return !(glm::dot(origin, origin) <= T(distantSquared));
    }

    // The hit at t. The t of a distant ray is rounded by more than a thin solid is thick, and `meet` clamps
    // to 0 the t of a ray that leaves a thin solid. There the hit is the end of the chord, as chordOf sees it
    // from nearby.
    static Vec3 endOfChord(const Shape& shape, const Ray& ray, Real t, bool entering);

    // A camera ray that starts on the surface hits it there. The origin alone decides, so all rays from it
    // agree; the rounded t of a chord may lie on either side of 0.
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

// Of the body of a cylinder or cone, or of a cap.
template <class T>
Vec2T<T> roundTexCoord(const Vec3T<T>& p, bool body) {
    return body ? Vec2T<T>(turn(p), p.z) : capTexCoord(p);
}

// Projects a point onto the unit sphere; with z = 0, onto the unit circle. Near it, one Newton step for 1 /
// sqrt is exact to rounding.
template <class T>
Vec3T<T> ontoUnit(const Vec3T<T>& p) {
    const T squared = glm::dot(p, p);
    const Truth<T> close = abs(squared - T(1)) < T(coincidenceWindow);
    const Vec3T<T> near = p * (T(Real(1.5)) - squared / T(2));
    return all(close) ? near : select(close, near, normalized(p));
}

// Replaces the centre, where no outward direction exists, by another point. Rounding may put the hit of a ray
// from very far away there.
template <class T>
Vec3T<T> offCenter(const Vec3T<T>& p) {
    const Truth<T> center = (p.x == T(0)) & (p.y == T(0)) & (p.z == T(0));
    return {select(center, T(1), p.x), p.y, p.z};
}

// Of a cylinder or cone: puts a point of a cap within the rim, and one of the body onto the circle.
template <class T>
Vec3T<T> withinCircle(const Vec3T<T>& p, bool body) {
    const Truth<T> onto = body ? T(0) == T(0) : glm::dot(p, p) > T(1);
    return any(onto) ? select(onto, ontoUnit(offCenter(p)), p) : p;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
