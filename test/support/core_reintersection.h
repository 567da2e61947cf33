// Rays that leave a shape's surface, from everywhere and at every angle: what must not happen to them,
// counted. After pbrt's shapes_test. The CTest run and the long run in bench/ share it.
#pragma once

#include "core_random.h"
#include "raytracer/tracer/shading.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {
namespace test {

struct Reintersections {
    std::uint64_t points = 0,
                  missed = 0;  // places aimed at, and of them those that the rounded ray passed by
    std::uint64_t rays = 0;
    std::uint64_t metAgain =
        0;  // left the shape and met it: convex shapes only, so it can only be the same place
    std::uint64_t neverOut = 0;      // entered a solid and never came out
    std::uint64_t stuck = 0;         // came out though the solid goes on along the ray
    std::uint64_t oddCrossings = 0;  // straight on through a solid: not in, out and gone
};

class Reintersection {
  public:
    Reintersection(Kind kind, std::shared_ptr<const MeshData> mesh, std::uint64_t seed,
                   const Extents& extents)
        : kind_(kind), mesh_(std::move(mesh)), random_(seed), extents_(extents) {
        if (mesh_) facets_ = facetsOf(*mesh_);
    }

    // In poses of 64 places each, with 16 rays from each place.
    Reintersections run(std::uint64_t rays) {
        while (result_.rays < rays) tryPose();
        return result_;
    }

  private:
    using Side = ShadingPoint::Side;

    void tryPose() {
        affine_ = randomAffine(random_, extents_);
        inverse_.emplace(affine_);
        shape_ = makeShape(kind_, affine_, material_, mesh_);
        for (int place = 0; place < 64; ++place) tryPlace();
    }

    void tryPlace() {
        const Wide target = placeOn(kind_, mesh_.get(), static_cast<Place>(random_.below(3)), random_);
        const Wide from =
            random_.below(4) == 0 && kind_ != Kind::Plane
                ? placeInside(random_)
                : target + Wide(random_.direction()) * static_cast<long double>(random_.magnitude(3));
        const Vec3 eye(pointToWorld(affine_, from));
        const Ray ray{eye, Vec3(pointToWorld(affine_, target) - Wide(eye)), {}};
        ++result_.points;
        const Intersection hit = shape_->rayIntersect(ray);
        if (!hit.valid) {
            ++result_.missed;
            return;
        }
        const ShadingPoint point(ray, hit, false);
        for (int i = 0; i < 16; ++i) leave(point);
        if (kind_ != Kind::Plane) goStraightOn(point, ray);
    }

    // A direction off the surface, on the side of N: anywhere, or within 1e-9 of the tangent plane.
    Vec3 direction(const Vec3& N) {
        const Vec3 any(random_.direction());
        const Real above = glm::dot(any, N);
        if (random_.below(2) == 0) return above < 0 ? any - 2 * above * N : any;
        const Vec3 tangent = any - above * N;
        const auto steepness = static_cast<Real>(std::pow(10, random_.between(-9, -1)));
        return normalized(normalized(tangent) + steepness * N);
    }

    void leave(const ShadingPoint& point) {
        const bool far = random_.bits() & 1;
        Vec3 way = direction(point.N);
        if (!(glm::dot(way, point.N) > 0)) return;  // turned over by rounding
        if (far) way = -way;
        const Ray ray =
            point.leave(way * static_cast<Real>(random_.magnitude(2)), far ? Side::Far : Side::Near);
        ++result_.rays;
        if (ray.departure.inside && kind_ != Kind::Plane) comeOut(ray);
        else result_.metAgain += shape_->rayIntersect(ray).valid;
    }

    void comeOut(const Ray& ray) {
        const Intersection out = shape_->rayIntersect(ray);
        if (!out.valid || !(out.t >= 0) || !(out.t < infinity)) ++result_.neverOut;
        else result_.stuck += goesOn(ray, out);
    }

    // Whether the ray is well inside the solid somewhere beyond the place where it is said to come out.
    bool goesOn(const Ray& ray, const Intersection& out) const {
        constexpr auto u = static_cast<long double>(unitRoundoff);
        const Wide origin = inverse_->point(Wide(ray.origin)), way = inverse_->direction(Wide(ray.direction));
        const Wide from = inverse_->error(Wide(ray.departure.positionError) + 4 * u * Wide(abs(ray.origin)));
        const Wide turned = inverse_->error(4 * u * Wide(abs(ray.direction)));
        const long double step = 1 / std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
        for (long double ahead = 1e-6L; ahead < 4; ahead *= 3) {
            const long double t = out.t + ahead * step;
            const Wide unsure = from + t * turned;
            const long double tolerance = 64 * (unsure.x + unsure.y + unsure.z) + 256 * u;
            if (isDeepInside(kind_, facets_, origin + t * way, tolerance)) return true;
        }
        return false;
    }

    // On along the same line: in and out in turn, and gone at last. From inside it starts with out.
    void goStraightOn(const ShadingPoint& first, const Ray& ray) {
        Intersection hit = *first.hit;
        bool entering = first.entering;
        Ray onwards = first.leave(ray.direction, Side::Far);
        for (int crossings = 1; crossings < 5; ++crossings) {
            hit = shape_->rayIntersect(onwards);
            if (!hit.valid) {
                result_.oddCrossings += entering;
                return;
            }
            const ShadingPoint point(onwards, hit, false);
            if (point.entering == entering) break;
            entering = point.entering;
            onwards = point.leave(ray.direction, Side::Far);
        }
        ++result_.oddCrossings;
    }

    Kind kind_;
    std::shared_ptr<const MeshData> mesh_;
    std::vector<Facet> facets_;  // of the mesh
    Random random_;
    Extents extents_;
    Material material_;
    Affine affine_;
    std::optional<WideInverse> inverse_;
    std::unique_ptr<Shape> shape_;
    Reintersections result_;
};

}  // namespace test
}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
