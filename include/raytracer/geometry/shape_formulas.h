// Where rays meet the shapes, and what their surfaces are like there: for one ray (shape.cpp) or several
// (packet_tracer.cpp).
#pragma once

#include "raytracer/geometry/chord.h"
#include "raytracer/geometry/shape.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

inline constexpr Real pi = static_cast<Real>(3.14159265358979323846264338327950288L);

template <class T>
T clamp(const T& x, Real low, Real high) {
    return min(max(x, T(low)), T(high));
}

// The angle about the z axis as a fraction of a turn, in [0, 1).
template <class T>
T turn(const Vec3T<T>& p) {
    const auto one = [](Real y, Real x) {
        const Real u = std::atan2(y, x) / (2 * pi);
        return u < 0 ? u + 1 : u;
    };
    return laneByLane<T>(one, p.y, p.x);
}

template <class T>
Vec2T<T> capTexCoord(const Vec3T<T>& p) {
    return {(p.x + T(1)) / T(2), (p.y + T(1)) / T(2)};
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

template <class T>
Vec3T<T> Shape::pointObject(const RayT<T>& ray, const HitT<T>& hit) const {
    const ObjectRayT<T> object = transform_.toObject(ray);
    return object.origin + hit.t * object.direction;
}

template <class T>
IntersectionT<T> Shape::place(const HitT<T>& hit, const Vec3T<T>& pointObject,
                              const Vec3T<T>& normalObject) const {
    IntersectionT<T> intersection;
    intersection.valid = true;
    intersection.t = hit.t;
    intersection.position = transform_.pointToWorld(pointObject);
    intersection.positionError = transform_.pointError(pointObject);
    intersection.normal = normalized(transform_.normalToWorld(normalObject));
    intersection.material = material_;
    intersection.shape = this;
    intersection.primitive = hit.primitive;
    intersection.entering = hit.entering;
    return intersection;
}

template <class T, class OffsetFinder>
Truth<T> Solid::touchesOffset(const Vec3T<T>& point, const Vec3T<T>& pointError,
                              OffsetFinder offsetOf) const {
    const Vec3T<T> error = transform_.objectError(point, pointError);
    return abs(offsetOf(transform_.pointToObject(point))) <= error.x + error.y + error.z;
}

template <class T, class Query, class ChordFinder, class OffsetFinder>
void Solid::offerChord(const RayT<T>& ray, Query& query, ChordFinder chordOf, OffsetFinder offsetOf) const {
    const bool leavesThis = ray.departure.shape == this;
    if (leavesThis && !ray.departure.inside) return;
    query.count();
    const Chord<T> chord = chordOf(transform_.toObject(ray));
    const Truth<T> never = T(0) < T(0);
    if (leavesThis) return query.offerFace(!never, max(T(0), chord.exit), *this, chord.exitFace, never);

    Truth<T> entering = chord.entry >= T(0);
    const T first = select(entering, chord.entry, chord.exit);
    Truth<T> hit = chord.hit & (chord.exit >= T(0)) & !(first > query.limit());
    if (!any(hit)) return;
    if (ray.departure.shape) {
        // Where one of the chord's ends is the ray's origin, it is the one nearer to it, and only the other
        // counts.
        const Truth<T> starts = hit & touchesOffset(ray.origin, ray.departure.positionError, offsetOf);
        hit = hit & !(starts & (abs(chord.exit) < abs(chord.entry)));
        entering = entering & !starts;
    }
    query.offerFace(hit, select(entering, chord.entry, chord.exit), *this,
                    select(entering, chord.entryFace, chord.exitFace), entering);
}

// Sphere

struct SphereOffset {
    template <class T>
    T operator()(const Vec3T<T>& p) const {
        return sqrt(glm::dot(p, p)) - T(1);
    }
};

template <class T, class Query>
void Sphere::meet(const RayT<T>& ray, Query& query) const {
    offerChord(ray, query, SphereChord(), SphereOffset());
}

template <class T>
IntersectionT<T> Sphere::surface(const RayT<T>& ray, const HitT<T>& hit) const {
    const Vec3T<T> normal = offCenter(pointObject(ray, hit)), p = ontoUnit(normal);
    IntersectionT<T> intersection = place(hit, p, normal);
    const auto height = [](Real z) { return 1 - std::acos(glm::clamp(z, Real(-1), Real(1))) / pi; };
    if (wantsTexCoord()) intersection.texCoord = {turn(p), laneByLane<T>(height, p.z)};
    return intersection;
}

// Cylinder

struct CylinderOffset {
    template <class T>
    T operator()(const Vec3T<T>& p) const {
        return max(radius(p) - T(1), max(-p.z, p.z - T(1)));
    }
};

template <class T, class Query>
void Cylinder::meet(const RayT<T>& ray, Query& query) const {
    offerChord(ray, query, CylinderChord(), CylinderOffset());
}

// A cap's point is within the rim; a body's on the circle.
template <class T>
Vec3T<T> withinCircle(const Vec3T<T>& p, bool body) {
    const Truth<T> onto = body ? T(0) == T(0) : glm::dot(p, p) > T(1);
    return any(onto) ? select(onto, ontoUnit(offCenter(p)), p) : p;
}

template <class T>
IntersectionT<T> Cylinder::surface(const RayT<T>& ray, const HitT<T>& hit) const {
    const std::uint32_t face = faceOf(hit.primitive);
    const bool body = face == 0;
    Vec3T<T> p = pointObject(ray, hit);
    const T z = body ? clamp(p.z, 0, 1) : T(Real(face == 1));
    p.z = T(0);
    const Vec3T<T> normal = body ? offCenter(p) : Vec3T<T>(T(0), T(0), T(2) * z - T(1));
    p = withinCircle(p, body);
    p.z = z;
    IntersectionT<T> intersection = place(hit, p, normal);
    if (wantsTexCoord()) intersection.texCoord = body ? Vec2T<T>(turn(p), p.z) : capTexCoord(p);
    return intersection;
}

// Cone

struct ConeOffset {
    template <class T>
    T operator()(const Vec3T<T>& p) const {
        constexpr auto perpendicular =
            static_cast<Real>(0.70710678118654752440084436210484904L);  // sqrt(1/2): a slope of 45 degrees
        return max((radius(p) - (T(1) - p.z)) * T(perpendicular), -p.z);
    }
};

template <class T, class Query>
void Cone::meet(const RayT<T>& ray, Query& query) const {
    offerChord(ray, query, ConeChord(), ConeOffset());
}

template <class T>
IntersectionT<T> Cone::surface(const RayT<T>& ray, const HitT<T>& hit) const {
    const bool body = faceOf(hit.primitive) == 0;
    Vec3T<T> p = pointObject(ray, hit);
    const T z = body ? clamp(p.z, 0, 1) : T(0), w = T(1) - z;
    p.z = T(0);
    p = withinCircle(p, body);
    if (body) p = w * p;
    Vec3T<T> normal(T(0), T(0), T(-1));
    if (body) {  // at the apex it's up
        const Truth<T> below = w > T(0);
        normal = {select(below, p.x, T(0)), select(below, p.y, T(0)), select(below, w, T(1))};
    }
    p.z = z;
    IntersectionT<T> intersection = place(hit, p, normal);
    if (wantsTexCoord()) intersection.texCoord = body ? Vec2T<T>(turn(p), p.z) : capTexCoord(p);
    return intersection;
}

// Cube

struct CubeOffset {
    template <class T>
    T operator()(const Vec3T<T>& p) const {
        return maxComponent(abs(p)) - T(1);
    }
};

template <class T, class Query>
void Cube::meet(const RayT<T>& ray, Query& query) const {
    offerChord(ray, query, CubeChord(), CubeOffset());
}

template <class T>
IntersectionT<T> Cube::surface(const RayT<T>& ray, const HitT<T>& hit) const {
    const std::uint32_t face = faceOf(hit.primitive);
    const int axis = static_cast<int>(face / 2);
    const Vec3T<T> q = pointObject(ray, hit);
    Vec3T<T> p(clamp(q.x, -1, 1), clamp(q.y, -1, 1), clamp(q.z, -1, 1)), normal(T(0));
    p[axis] = normal[axis] = T(face % 2 == 0 ? 1 : -1);
    IntersectionT<T> intersection = place(hit, p, normal);
    if (wantsTexCoord()) {
        const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
        intersection.texCoord = {(p[first] + T(1)) / T(2), (p[second] + T(1)) / T(2)};
    }
    return intersection;
}

// Plane

template <class T>
Truth<T> Plane::touchesPlane(const Vec3T<T>& point, const Vec3T<T>& pointError) const {
    return abs(transform_.pointToObject(point).z) <= transform_.objectError(point, pointError).z;
}

template <class T, class Query>
void Plane::meet(const RayT<T>& ray, Query& query) const {
    if (ray.departure.shape == this) return;
    query.count();
    const ObjectRayT<T> object = transform_.toObject(ray);
    const T t = -object.origin.z / object.direction.z;
    Truth<T> hit = (t >= T(0)) & (t <= query.limit()) & !(object.direction.z == T(0));
    if (!any(hit)) return;
    if (ray.departure.shape) hit = hit & !touchesPlane(ray.origin, ray.departure.positionError);
    query.offerFace(hit, t, *this, T(0), object.direction.z < T(0));
}

template <class T>
IntersectionT<T> Plane::surface(const RayT<T>& ray, const HitT<T>& hit) const {
    Vec3T<T> p = pointObject(ray, hit);
    p.z = T(0);
    IntersectionT<T> intersection = place(hit, p, Vec3T<T>(T(0), T(0), T(1)));
    const auto fraction = [](Real x) { return x - std::floor(x); };
    if (wantsTexCoord()) {
        const Vec2T<T> uv = capTexCoord(p);
        intersection.texCoord = {laneByLane<T>(fraction, uv.x), laneByLane<T>(fraction, uv.y)};
    }
    return intersection;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
