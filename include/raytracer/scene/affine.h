// Affine maps as the scene file describes them, composed and inverted in long double.
//
// long double has the exponent range for scales of 1e+-100 in all three directions at once (their product is
// the determinant) and bits to spare, so that what the core receives is correctly rounded in all but a few
// cases.
#pragma once

#include <optional>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// x -> linear * x + translation, both row by row: linear[row][column].
struct Affine {
    long double linear[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    long double translation[3] = {0, 0, 0};
};

// World from object: translate * rotate * scale * matrix. A rotation by a multiple of 90 degrees about any
// axis uses the exact sine and cosine. The axis need not be of unit length but must not be zero.
Affine compose(const TransformDescription& transform);

// The inverse of the linear part (row by row), or nothing where it is singular: rows and columns are first
// brought to comparable size by powers of two, then eliminated with full pivoting (Higham, Accuracy and
// Stability, ch. 9); a pivot that is all rounding error counts as zero.
struct Matrix3 {
    long double entry[3][3];
};
std::optional<Matrix3> inverseLinear(const Affine& affine);

}  // namespace raytracer
