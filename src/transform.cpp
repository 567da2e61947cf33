#include "raytracer/transform.h"

#include <algorithm>
#include <stdexcept>

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

Transform::Transform(const Affine& worldFromObject) {
    const auto inverse = inverseLinear(worldFromObject);
    if (!inverse) throw std::domain_error("singular transform");
    long double largest = 0;
    for (const auto& row : inverse->entry)
        for (const long double entry : row) largest = std::max(largest, std::abs(entry));
    const int exponent = std::ilogb(largest);
    inverseScale_ = std::scalbn(Real(1), exponent);
    worldPerObjectT_ = std::scalbn(Real(1), -exponent);
    const long double unit = std::scalbn(1.0L, -exponent);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            linear_[column][row] = static_cast<Real>(worldFromObject.linear[row][column]);
            inverse_[column][row] = static_cast<Real>(inverse->entry[row][column] * unit);
        }
        translation_[row] = static_cast<Real>(worldFromObject.translation[row]);
    }
}

Real Transform::conditioning() const {
    return maxComponent(abs(linear_) * (abs(inverse_) * Vec3(1) * inverseScale_));
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
