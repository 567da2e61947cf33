#include "raytracer/scene/affine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "raytracer/scene/mesh_file.h"

namespace raytracer {
namespace {

using Extended = long double;
using Rows = ExtendedRows;

struct SineCosine {
    Extended sine, cosine;
};

// Quarter turns are exact. Any other angle is converted to radians in double, as the course framework's
// glm::radians does, because the reference pictures contain that rounding: the normals of a cylinder turned
// by 45 degrees show it.
SineCosine sineCosine(double degrees) {
    int quarters = 0;
    if (std::remquo(degrees, 90.0, &quarters) == 0) {
        constexpr Extended sines[] = {0, 1, 0, -1};
        return {sines[quarters & 3], sines[(quarters + 1) & 3]};
    }
    const Extended radians = glm::radians(degrees);
    return {std::sin(radians), std::cos(radians)};
}

// Scales first, so that no square overflows or underflows, however wide long double is.
ExtendedVec normalised(const glm::dvec3& vector) {
    const int exponent = std::ilogb(std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)}));
    const ExtendedVec nearUnit = scaled(vector, -exponent);
    return nearUnit / glm::length(nearUnit);
}

// Rodrigues' formula: R = cos I + sin [a]x + (1 - cos) a aT.
void rotationMatrix(const TransformDescription::Rotation& rotation, Rows& matrix) {
    const ExtendedVec a = normalised(rotation.axis);
    const auto [sine, cosine] = sineCosine(rotation.degrees);
    for (int i = 0; i < 3; ++i) matrix[i] = (1 - cosine) * a[i] * a;
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3, last = (i + 2) % 3;
        matrix[i][i] += cosine;
        matrix[last][next] += sine * a[i];
        matrix[next][last] -= sine * a[i];
    }
}

void appendMatrix(Affine& affine, const glm::dmat4& matrix) {
    const glm::dmat4 rows = glm::transpose(matrix);
    for (int i = 0; i < 3; ++i) {
        ExtendedVec& row = affine.linear[i];
        for (int j = 0; j < 3; ++j) affine.translation[i] += row[j] * matrix[3][j];
        row = row.x * ExtendedVec(rows[0]) + row.y * ExtendedVec(rows[1]) + row.z * ExtendedVec(rows[2]);
    }
}

// The power of two that brings the largest of the three into [1/2, 1); 1 if all are zero.
Extended balance(const ExtendedVec& v) {
    int exponent = 0;
    std::frexp(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}), &exponent);
    return std::ldexp(Extended(1), -exponent);
}

// B = diag(row) A diag(column), where the largest entry of every row and column is near 1. Columns are scaled
// first: where A is a rotation after scales that differ by any factor, only the rotation is left.
struct Balanced {
    Rows entry;
    ExtendedVec row, column;
};

Balanced balanced(const Rows& a) {
    Balanced b;
    for (int j = 0; j < 3; ++j) b.column[j] = balance({a[0][j], a[1][j], a[2][j]});
    for (int i = 0; i < 3; ++i) {
        const ExtendedVec row = a[i] * b.column;
        b.row[i] = balance(row);
        b.entry[i] = row * b.row[i];
    }
    return b;
}

// Gauss-Jordan elimination of [B | I] with full pivoting. Rows are swapped; pivotColumn stands for swapping
// columns.
struct Elimination {
    Rows& left;
    Rows right{1};
    int pivotColumn[3] = {0, 1, 2};  // of each finished row, then the columns without a pivot
    Extended largestPivot = 0;

    void choosePivot(int step);
    bool isRoundingError(Extended pivot) const;
    void eliminate(int step);
};

void Elimination::choosePivot(int step) {
    const auto size = [&](int row, int i) { return std::abs(left[row][pivotColumn[i]]); };
    int bestRow = step, best = step;
    for (int row = step; row < 3; ++row)
        for (int i = step; i < 3; ++i)
            if (size(row, i) > size(bestRow, best)) std::tie(bestRow, best) = std::pair(row, i);
    std::swap(left[step], left[bestRow]);
    std::swap(right[step], right[bestRow]);
    std::swap(pivotColumn[step], pivotColumn[best]);
}

// Higham, Theorem 9.3: the backward error of eliminating a 3 x 3 matrix is at most gamma_3 |L||U|, and full
// pivoting keeps |L||U| below 3 * 2.25 times the largest entry. A factor of 2 is for the roundings in
// compose().
bool Elimination::isRoundingError(Extended pivot) const {
    constexpr Extended unitRoundoff = std::numeric_limits<Extended>::epsilon() / 2;
    return std::abs(pivot) <= 2 * 3 * 3 * Extended(2.25) * unitRoundoff * largestPivot;
}

void Elimination::eliminate(int step) {
    const int column = pivotColumn[step];
    const Extended pivot = left[step][column];
    left[step] /= pivot;
    right[step] /= pivot;
    for (int row = 0; row < 3; ++row) {
        if (row == step) continue;
        const Extended factor = left[row][column];
        left[row] -= factor * left[step];
        right[row] -= factor * right[step];
    }
}

// Whether the matrix only scales, by positive factors, as most do.
bool isPositiveDiagonal(const Rows& a) {
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if (row == column ? !(a[row][column] > 0) : a[row][column] != 0) return false;
    return true;
}

}  // namespace

ExtendedVec scaled(const ExtendedVec& v, int exponent) {
    return {std::scalbn(v.x, exponent), std::scalbn(v.y, exponent), std::scalbn(v.z, exponent)};
}

Affine compose(const TransformDescription& transform) {
    Affine affine;
    if (transform.translate) affine.translation = *transform.translate;
    if (transform.rotate) rotationMatrix(*transform.rotate, affine.linear);
    if (transform.scale)
        for (int i = 0; i < 3; ++i) affine.linear[i] *= ExtendedVec(*transform.scale);
    if (transform.matrix) appendMatrix(affine, *transform.matrix);
    return affine;
}

Affine worldFromObject(const SceneDescription& scene, const ShapeDescription& shape) {
    Affine affine = compose(scene.transforms[shape.transform]);
    if (shape.mesh && shape.mesh->exponent != 0)
        for (int i = 0; i < 3; ++i) affine.linear[i] = scaled(affine.linear[i], shape.mesh->exponent);
    return affine;
}

std::optional<ExtendedRows> inverseLinear(const Affine& affine) {
    const Rows& a = affine.linear;
    // The same result as by elimination, only faster.
    if (isPositiveDiagonal(a)) return Rows{{1 / a[0].x, 0, 0}, {0, 1 / a[1].y, 0}, {0, 0, 1 / a[2].z}};
    Balanced b = balanced(affine.linear);
    Elimination elimination{b.entry};
    for (int step = 0; step < 3; ++step) {
        elimination.choosePivot(step);
        const Extended pivot = b.entry[step][elimination.pivotColumn[step]];
        if (step == 0) elimination.largestPivot = std::abs(pivot);
        if (elimination.isRoundingError(pivot)) return std::nullopt;
        elimination.eliminate(step);
    }
    Rows inverse(1);
    for (int step = 0; step < 3; ++step) {
        const int row = elimination.pivotColumn[step];
        inverse[row] = b.column[row] * elimination.right[step] * b.row;
    }
    return inverse;
}

}  // namespace raytracer
