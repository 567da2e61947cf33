// Affine maps as the scene file describes them, composed and inverted in long double.
//
// The determinant of a matrix that scales by 1e100 or 1e-100 along all three axes fits the exponent range of
// long double. Its extra bits round what the core receives correctly in all but a few cases.
#pragma once

#include <optional>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// x -> linear * x + translation, both row by row: linear[row][column].
struct Affine {
    long double linear[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    long double translation[3] = {0, 0, 0};
};

// World from object: translate * rotate * scale * matrix. A rotation by a multiple of 90 degrees uses the
// exact sine and cosine. The axis may have any length but zero.
Affine compose(const TransformDescription& transform);

// The same of a shape: a mesh's object space is in the mesh's own unit.
Affine worldFromObject(const SceneDescription& scene, const ShapeDescription& shape);

// The inverse of the linear part, row by row, or nothing where it is singular. Rows and columns are scaled to
// similar size by powers of two, then eliminated with full pivoting (Higham, Accuracy and Stability of
// Numerical Algorithms, chapter 9). A pivot no larger than its rounding error counts as zero.
struct Matrix3 {
    long double entry[3][3];
};
std::optional<Matrix3> inverseLinear(const Affine& affine);

}  // namespace raytracer
