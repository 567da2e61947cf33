// Object space to world space and back, with bounds on the rounding.
#pragma once

#include "raytracer/geometry/ray.h"
#include "raytracer/scene/affine.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// A ray in object space, with the t of the ray in the world. Where the transform's scale is 1e-200 its
// direction's square overflows: who squares it checks that (isSafeSquare).
template <class T>
struct ObjectRayT {
    Vec3T<T> origin{0};
    Vec3T<T> direction{0};
};
using ObjectRay = ObjectRayT<Real>;

// x_world = linear * x_object + translation. Invertible.
class Transform {
  public:
    Transform() : Transform(Affine{}) {}

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

    // What pointToObject adds up, without signs: where that is much less, it has cancelled.
    template <class T>
    Vec3T<T> pointTerms(const Vec3T<T>& world) const {
        return absoluteProduct(inverse_, world - Vec3T<T>(translation_));
    }

    template <class T>
    Vec3T<T> pointToWorld(const Vec3T<T>& object) const {
        return product(linear_, object) + Vec3T<T>(translation_);
    }

    // A bound, for each axis in world units, on how far pointToWorld(p) is from the true image of a point p
    // that lies on its surface to within a few roundings of its own coordinates: the matrix product, its
    // rounded entries and the roundings of p (gamma_8), the sum and the rounded translation (gamma_2).
    template <class T>
    Vec3T<T> pointError(const Vec3T<T>& object) const {
        return T(gamma(8)) * absoluteProduct(linear_, object) + Vec3T<T>(gamma(2) * abs(translation_));
    }

    // A bound, for each axis in object units, on the error of pointToObject(world) when `world` is uncertain
    // by worldError: the roundings of difference and product (gamma_5) and this transform's own rounded
    // numbers (gamma_2).
    template <class T>
    Vec3T<T> objectError(const Vec3T<T>& world, const Vec3T<T>& worldError) const {
        const Vec3T<T> uncertain = worldError + T(gamma(5)) * abs(world - Vec3T<T>(translation_)) +
                                   Vec3T<T>(gamma(2) * abs(translation_));
        return absoluteProduct(inverse_, uncertain);
    }

    // How far, for each axis in world units, a point that the author wrote may be from where it was meant to
    // be, seen from this transform: as many roundings as in objectError, of what both were written with.
    template <class T>
    Vec3T<T> writtenError(const Vec3T<T>& world) const {
        return T(5 * writtenRoundoff) * abs(world - Vec3T<T>(translation_)) +
               Vec3T<T>(2 * writtenRoundoff * abs(translation_));
    }

    // How much larger, at most, an error can become on the way to object space and back: the largest sum of a
    // row of |linear| |inverse|. At most 3 for any rotation times a scale, at most 1 without a rotation.
    Real conditioning() const;

    // The world direction of a surface normal: inverse transpose, not of unit length, the sign kept under
    // mirroring.
    template <class T>
    Vec3T<T> normalToWorld(const Vec3T<T>& object) const {
        return product(object, inverse_);
    }

    // The largest numbers on the way to object space, and back from there.
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
