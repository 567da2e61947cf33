#include "raytracer/geometry/transform.h"

#include <stdexcept>

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

Transform::Transform(const Affine& worldFromObject) {
    const auto inverse = inverseLinear(worldFromObject);
    if (!inverse) throw std::domain_error("singular transform");
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            linear_[column][row] = static_cast<Real>(worldFromObject.linear[row][column]);
            inverse_[column][row] = static_cast<Real>(inverse->entry[row][column]);
        }
        translation_[row] = static_cast<Real>(worldFromObject.translation[row]);
    }
}

Real Transform::conditioning() const { return maxComponent(abs(linear_) * (abs(inverse_) * Vec3(1))); }

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
