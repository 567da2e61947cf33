// Object space to world space and back, with bounds on the rounding.
#pragma once

#include "raytracer/geometry/ray.h"
#include "raytracer/scene/affine.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// A ray in object space; t is that of the ray in the world. The square of the direction may overflow, as
// where the transform's scale is 1e-200: code that squares it checks for that (isSafeSquare).
template <class T>
struct ObjectRayT {
    Vec3T<T> origin{0};
    Vec3T<T> direction{0};
};
using ObjectRay = ObjectRayT<Real>;

// x_world = linear * x_object + translation. Invertible.
class Transform {
  public:
    // Throws std::domain_error where the linear part is singular.
    explicit Transform(const Affine& worldFromObject);

    template <class T>
    ObjectRayT<T> toObject(const RayT<T>& ray) const {
        return {pointToObject(ray.origin), product(inverse_, ray.direction)};
    }
    template <class T>
    Vec3T<T> pointToObject(const Vec3T<T>& world) const {
        return product(inverse_, world - Vec3T<T>(translation_));
    }

    // The sums that pointToObject computes, with every term's magnitude. A result much smaller than this has
    // cancelled.
    template <class T>
    Vec3T<T> pointTerms(const Vec3T<T>& world) const {
        return absoluteProduct(inverse_, world - Vec3T<T>(translation_));
    }

    // A bound, for each axis, on what toObject makes of a direction whose coordinates are at most 1.
    Vec3 largestDirection() const { return absoluteProduct(inverse_, Vec3(1)); }

    template <class T>
    Vec3T<T> pointToWorld(const Vec3T<T>& object) const {
        return product(linear_, object) + Vec3T<T>(translation_);
    }

    // A bound, for each axis in world units, on the distance of pointToWorld(p) from the true image of p, for
    // a point p that lies on its surface to within a few roundings of its own coordinates. gamma_8: the
    // matrix product, the matrix's rounded entries and the roundings of p. gamma_2: the sum and the rounded
    // translation.
    template <class T>
    Vec3T<T> pointError(const Vec3T<T>& object) const {
        return T(gamma(8)) * absoluteProduct(linear_, object) + Vec3T<T>(gamma(2) * abs(translation_));
    }

    // A bound, for each axis in object units, on the error of pointToObject(world), where `world` has the
    // error worldError. gamma_5: the difference, the matrix product and the rounded entries of the inverse.
    // gamma_2: the rounded translation.
    template <class T>
    Vec3T<T> objectError(const Vec3T<T>& world, const Vec3T<T>& worldError) const {
        const Vec3T<T> uncertain = worldError + T(gamma(5)) * abs(world - Vec3T<T>(translation_)) +
                                   Vec3T<T>(gamma(2) * abs(translation_));
        return absoluteProduct(inverse_, uncertain);
    }

    // A bound, for each axis in world units, on the error that a point written by the scene's author has
    // relative to this transform. Counts as many roundings as objectError, but of the numbers as they were
    // written (writtenRoundoff).
    template <class T>
    Vec3T<T> writtenError(const Vec3T<T>& world) const {
        return T(5 * writtenRoundoff) * abs(world - Vec3T<T>(translation_)) +
               Vec3T<T>(2 * writtenRoundoff * abs(translation_));
    }

    // The factor by which an error can grow, at most, on the way to object space and back: the largest row
    // sum of |linear| |inverse|. At most 3 for any rotation times a scale, at most 1 without a rotation.
    Real conditioning() const;

    // A surface normal in the world, by the inverse transpose. Not of unit length. Its sign is kept under
    // mirroring.
    template <class T>
    Vec3T<T> normalToWorld(const Vec3T<T>& object) const {
        return product(object, inverse_);
    }

    // The largest numbers on the way to object space (`finest`) and on the way back.
    Real finest() const { return largest(inverse_); }
    Real farthest() const { return std::max(largestScale(), maxComponent(abs(translation_))); }
    Real largestScale() const { return largest(linear_); }

    const Mat3& linear() const { return linear_; }
    const Vec3& translation() const { return translation_; }

  private:
    static Real largest(const Mat3& m) {
        return maxComponent(Vec3(maxComponent(abs(m[0])), maxComponent(abs(m[1])), maxComponent(abs(m[2]))));
    }

    // What rays need comes first, together.
    Mat3 inverse_{1};  // of linear_
    Vec3 translation_{0};
    Mat3 linear_{1};
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
