// Object space to world space and back, with bounds on the rounding.
#pragma once

#include "raytracer/affine.h"
#include "raytracer/ray.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// A ray in object space, with the t of the ray in the world. Where the transform's scale is 1e-200 its direction's square
// overflows: who squares it looks at that (isSafeSquare).
struct ObjectRay {
    Vec3 origin{0};
    Vec3 direction{0};
};

// x_world = linear * x_object + translation. Invertible.
class Transform {
  public:
    Transform() : Transform(Affine{}) {}

    // Throws std::domain_error where the linear part is singular.
    explicit Transform(const Affine& worldFromObject);

    ObjectRay toObject(const Ray& ray) const {
        return {inverse_ * (ray.origin - translation_), inverse_ * ray.direction};
    }
    Vec3 pointToObject(const Vec3& world) const { return inverse_ * (world - translation_); }

    Vec3 pointToWorld(const Vec3& object) const { return linear_ * object + translation_; }

    // A bound, for each axis in world units, on how far pointToWorld(p) is from the true image of a point p that lies
    // on its surface to within a few roundings of its own coordinates: the matrix product, its rounded entries and the
    // roundings of p (gamma_8), the sum and the rounded translation (gamma_2).
    Vec3 pointError(const Vec3& object) const {
        return gamma(8) * (abs(linear_) * abs(object)) + gamma(2) * abs(translation_);
    }

    // A bound, for each axis in object units, on the error of pointToObject(world) when `world` is uncertain by
    // worldError: the roundings of difference and product (gamma_5) and this transform's own rounded numbers (gamma_2).
    Vec3 objectError(const Vec3& world, const Vec3& worldError) const {
        const Vec3 uncertain =
            worldError + gamma(5) * abs(world - translation_) + gamma(2) * abs(translation_);
        return abs(inverse_) * uncertain;
    }

    // How much larger, at most, an error can become on the way to object space and back: the largest sum of a row of
    // |linear| |inverse|. At most 3 for any rotation times a scale, at most 1 without a rotation.
    Real conditioning() const;

    // The world direction of a surface normal: inverse transpose, not of unit length, the sign kept under mirroring.
    Vec3 normalToWorld(const Vec3& object) const { return glm::transpose(inverse_) * object; }

    const Mat3& linear() const { return linear_; }
    const Vec3& translation() const { return translation_; }

  private:
    // What rays need comes first, together.
    Mat3 inverse_{1};  // of linear_
    Vec3 translation_{0};
    Mat3 linear_{1};
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
