#include "raytracer/shape.h"

#include <algorithm>

#include "chord.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

namespace {

constexpr Real pi = static_cast<Real>(3.14159265358979323846264338327950288L);

// The angle about the z axis as a fraction of a turn, in [0, 1).
Real turn(const Vec3& p) {
    const Real u = std::atan2(p.y, p.x) / (2 * pi);
    return u < 0 ? u + 1 : u;
}

Vec2 capTexCoord(const Vec3& p) { return {(p.x + 1) / 2, (p.y + 1) / 2}; }

// Puts a point back onto the unit sphere; one without z, onto the circle. By one Newton step for 1 / sqrt where that is
// exact to rounding.
Vec3 ontoUnit(const Vec3& p) {
    const Real squared = glm::dot(p, p);
    return std::abs(squared - 1) < coincidenceWindow ? p * (Real(1.5) - squared / 2) : normalized(p);
}

// Rounding may put the hit of a ray that comes from very far into the very centre, where there is no direction outwards:
// then any.
Vec3 offCenter(const Vec3& p) { return p == Vec3(0) ? Vec3(1, 0, 0) : p; }

// Whether it scales alike in all directions, to within 1/256: close enough for culling by FloatBox::ball.
bool isUniform(const Mat3& m) {
    const Mat3 squares = glm::transpose(m) * m;
    Real off = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) off = std::max(off, std::abs(squares[i][j] - (i == j ? squares[0][0] : 0)));
    return off <= squares[0][0] / 1024;
}

}  // namespace

Intersection Shape::rayIntersect(const Ray& ray) const {
    HitQuery query;
    intersect(ray, query);
    return query.found() ? surfaceAt(ray, query.nearest()) : Intersection{};
}

Intersection Shape::surface(const Hit& hit, const Vec3& pointObject, const Vec3& normalObject) const {
    Intersection intersection;
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

bool Shape::widened(const Vec3& centerObject, const Vec3& sizeObject, const Vec3& half, FloatBox& box) const {
    constexpr Real worst = 1 << 20;  // a worse transform would widen the whole tree's rays: better no box for this one
    const Mat3 sizes = abs(transform_.linear());
    const Real conditioning = transform_.conditioning();
    if (!(conditioning <= worst)) return false;
    // A hit may lie off the surface by as much as a root of the roundoff (at a cone's apex), in units of the shape's size; and
    // by some roundings of the numbers that place it.
    const Vec3 size = sizes * sizeObject;
    const Real place = maxComponent(abs(transform_.translation()) + sizes * abs(centerObject) + size);
    const Vec3 margin = 16 * coincidenceWindow * size + gamma(32) * conditioning * place;
    const Vec3 center = transform_.pointToWorld(centerObject), low = center - half - margin, high = center + half + margin;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = floatBelow(static_cast<double>(low[axis]));
        box.high[axis] = floatAbove(static_cast<double>(high[axis]));
    }
    return Bvh::usable(box);
}

bool Solid::touches(const Vec3& point, const Vec3& pointError, std::uint32_t) const {
    const Vec3 error = transform_.objectError(point, pointError);
    return std::abs(surfaceOffset(transform_.pointToObject(point))) <= error.x + error.y + error.z;
}

Vec3 Solid::pointObject(const Ray& ray, const Hit& hit) const {
    const ObjectRay object = transform_.toObject(ray);
    return object.origin + hit.t * object.direction;
}

template <class ChordFinder>
void Solid::offerChord(const Ray& ray, HitQuery& query, ChordFinder chordOf) const {
    const bool leavesThis = ray.departure.shape == this;
    if (leavesThis && !ray.departure.inside) return;
    ++query.tests;
    const Chord chord = chordOf(transform_.toObject(ray));
    if (leavesThis) return query.offer(std::max(Real(0), chord.exit), *this, chord.exitFace, false);
    if (!chord.hit || !(chord.exit >= 0)) return;

    bool entering = chord.entry >= 0;
    if ((entering ? chord.entry : chord.exit) > query.limit()) return;
    if (ray.departure.shape && touches(ray.origin, ray.departure.positionError, 0)) {
        // One of the chord's ends is the ray's origin: the one nearer to it. Only the other counts.
        if (std::abs(chord.exit) < std::abs(chord.entry)) return;
        entering = false;
    }
    if (entering)
        query.offer(chord.entry, *this, chord.entryFace, true);
    else
        query.offer(chord.exit, *this, chord.exitFace, false);
}

// Sphere

void Sphere::intersect(const Ray& ray, HitQuery& query) const { offerChord(ray, query, sphereChord); }

Intersection Sphere::surfaceAt(const Ray& ray, const Hit& hit) const {
    const Vec3 normal = offCenter(pointObject(ray, hit)), p = ontoUnit(normal);
    Intersection intersection = surface(hit, p, normal);
    if (wantsTexCoord()) intersection.texCoord = {turn(p), 1 - std::acos(glm::clamp(p.z, Real(-1), Real(1))) / pi};
    return intersection;
}

bool Sphere::bounds(FloatBox& box) const {
    const Mat3& m = transform_.linear();
    box.ball = isUniform(m);
    return widened(Vec3(0), Vec3(1), glm::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]), box);
}

Real Sphere::surfaceOffset(const Vec3& p) const { return glm::length(p) - 1; }

// Cylinder

void Cylinder::intersect(const Ray& ray, HitQuery& query) const { offerChord(ray, query, cylinderChord); }

Intersection Cylinder::surfaceAt(const Ray& ray, const Hit& hit) const {
    Vec3 p = pointObject(ray, hit);
    const bool body = hit.primitive == 0;
    const Real z = body ? glm::clamp(p.z, Real(0), Real(1)) : Real(hit.primitive == 1);
    p.z = 0;
    const Vec3 normal = body ? offCenter(p) : Vec3(0, 0, 2 * z - 1);
    if (body || glm::dot(p, p) > 1) p = ontoUnit(offCenter(p));
    p.z = z;
    Intersection intersection = surface(hit, p, normal);
    if (wantsTexCoord()) intersection.texCoord = body ? Vec2(turn(p), p.z) : capTexCoord(p);
    return intersection;
}

bool Cylinder::bounds(FloatBox& box) const {
    const Mat3& m = transform_.linear();
    const Vec3 half = glm::sqrt(m[0] * m[0] + m[1] * m[1]) + abs(m[2]) / Real(2);
    return widened({0, 0, Real(0.5)}, {1, 1, Real(0.5)}, half, box);
}

Real Cylinder::surfaceOffset(const Vec3& p) const {
    return std::max(radius(p) - 1, std::max(-p.z, p.z - 1));
}

// Cone

void Cone::intersect(const Ray& ray, HitQuery& query) const { offerChord(ray, query, coneChord); }

Intersection Cone::surfaceAt(const Ray& ray, const Hit& hit) const {
    Vec3 p = pointObject(ray, hit);
    const bool body = hit.primitive == 0;
    const Real z = body ? glm::clamp(p.z, Real(0), Real(1)) : Real(0), w = 1 - z;
    p.z = 0;
    if (body || glm::dot(p, p) > 1) p = w * ontoUnit(offCenter(p));
    const Vec3 normal = !body ? Vec3(0, 0, -1) : w > 0 ? Vec3(p.x, p.y, w) : Vec3(0, 0, 1);  // at the apex it's up
    p.z = z;
    Intersection intersection = surface(hit, p, normal);
    if (wantsTexCoord()) intersection.texCoord = body ? Vec2(turn(p), p.z) : capTexCoord(p);
    return intersection;
}

// Around the base and the apex.
bool Cone::bounds(FloatBox& box) const {
    const Mat3& m = transform_.linear();
    const Vec3 base = glm::sqrt(m[0] * m[0] + m[1] * m[1]), middle = m[2] / Real(2);
    return widened({0, 0, Real(0.5)}, {1, 1, Real(0.5)}, glm::max(base + abs(middle), abs(middle)), box);
}

Real Cone::surfaceOffset(const Vec3& p) const {
    constexpr auto perpendicular = static_cast<Real>(0.70710678118654752440084436210484904L);  // sqrt(1/2): a slope of 45 degrees
    return std::max((radius(p) - (1 - p.z)) * perpendicular, -p.z);
}

// Cube

void Cube::intersect(const Ray& ray, HitQuery& query) const { offerChord(ray, query, cubeChord); }

Intersection Cube::surfaceAt(const Ray& ray, const Hit& hit) const {
    const int axis = static_cast<int>(hit.primitive / 2);
    const Real side = hit.primitive % 2 == 0 ? 1 : -1;
    Vec3 p = glm::clamp(pointObject(ray, hit), Real(-1), Real(1)), normal(0);
    p[axis] = normal[axis] = side;
    Intersection intersection = surface(hit, p, normal);
    if (wantsTexCoord()) {
        const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
        intersection.texCoord = {(p[first] + 1) / 2, (p[second] + 1) / 2};
    }
    return intersection;
}

bool Cube::bounds(FloatBox& box) const {
    return widened(Vec3(0), Vec3(1), abs(transform_.linear()) * Vec3(1), box);
}

Real Cube::surfaceOffset(const Vec3& p) const { return maxComponent(abs(p)) - 1; }

// Plane

void Plane::intersect(const Ray& ray, HitQuery& query) const {
    if (ray.departure.shape == this) return;
    ++query.tests;
    const ObjectRay object = transform_.toObject(ray);
    const Real t = -object.origin.z / object.direction.z;
    if (!(t >= 0 && t <= query.limit()) || object.direction.z == 0) return;
    if (ray.departure.shape && touches(ray.origin, ray.departure.positionError, 0)) return;
    query.offer(t, *this, 0, object.direction.z < 0);
}

Intersection Plane::surfaceAt(const Ray& ray, const Hit& hit) const {
    const ObjectRay object = transform_.toObject(ray);
    Vec3 p = object.origin + hit.t * object.direction;
    p.z = 0;
    Intersection intersection = surface(hit, p, {0, 0, 1});
    if (wantsTexCoord()) intersection.texCoord = capTexCoord(p) - glm::floor(capTexCoord(p));
    return intersection;
}

bool Plane::bounds(FloatBox&) const { return false; }

bool Plane::touches(const Vec3& point, const Vec3& pointError, std::uint32_t) const {
    return std::abs(transform_.pointToObject(point).z) <= transform_.objectError(point, pointError).z;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
