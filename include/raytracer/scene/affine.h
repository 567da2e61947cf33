// Affine maps as the scene file describes them, composed and inverted in long double.
//
// The determinant of a matrix that scales by 1e100 or 1e-100 along all three axes fits the exponent range of
// long double. Its extra bits make the numbers that the core receives correctly rounded, in all but a few
// cases.
#pragma once

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

using ExtendedVec = glm::vec<3, long double>;
using ExtendedRows = glm::mat<3, 3, long double>;  // row by row: rows[row][column]

// v * 2^exponent.
ExtendedVec scaled(const ExtendedVec& v, int exponent);

// x -> linear * x + translation.
struct Affine {
    ExtendedRows linear{1};
    ExtendedVec translation{0};
};

// World from object: translate * rotate * scale * matrix. A rotation by a multiple of 90 degrees uses the
// exact sine and cosine. The axis may have any length but zero.
Affine compose(const TransformDescription& transform);

// The same for a shape: a mesh's object space is in the mesh's own unit.
Affine worldFromObject(const SceneDescription& scene, const ShapeDescription& shape);

// The inverse of the linear part, or nothing where it is singular. Rows and columns are scaled to
// similar size by powers of two, then eliminated with full pivoting (Higham, Accuracy and Stability of
// Numerical Algorithms, chapter 9). A pivot that is no larger than its rounding error counts as zero.
std::optional<ExtendedRows> inverseLinear(const Affine& affine);

}  // namespace raytracer
