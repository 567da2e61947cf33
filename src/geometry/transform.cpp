#include "raytracer/geometry/transform.h"

#include <stdexcept>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

Transform::Transform(const Affine& worldFromObject) {
    const auto inverse = inverseLinear(worldFromObject);
    if (!inverse) throw std::domain_error("singular transform");
    const auto fromRows = [](const ExtendedVec(&row)[3]) {
        return glm::transpose(Mat3(row[0], row[1], row[2]));
    };
    linear_ = fromRows(worldFromObject.linear);
    inverse_ = fromRows(inverse->entry);
    translation_ = Vec3(worldFromObject.translation);
}

Real Transform::conditioning() const { return maxComponent(abs(linear_) * (abs(inverse_) * Vec3(1))); }

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
