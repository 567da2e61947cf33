#include "raytracer/geometry/transform.h"

#include <stdexcept>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

Transform::Transform(const Affine& worldFromObject) {
    const auto inverse = inverseLinear(worldFromObject);
    if (!inverse) throw std::domain_error("singular transform");
    linear_ = glm::transpose(Mat3(worldFromObject.linear));
    inverse_ = glm::transpose(Mat3(*inverse));
    translation_ = Vec3(worldFromObject.translation);
}

Real Transform::conditioning() const { return maxComponent(abs(linear_) * (abs(inverse_) * Vec3(1))); }

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
