// A mesh of any size.
#pragma once

#include <cmath>
#include <memory>

#include "raytracer/scene/mesh_file.h"

namespace raytracer::test {

// A closed sphere of 16 n^2 triangles, those at the poles without an area. `radius(u, v)`, of the longitude
// and of the angle from the z axis, may give it bumps.
template <class Radius>
std::shared_ptr<const MeshData> ballMesh(std::uint32_t n, Radius radius) {
    auto mesh = std::make_shared<MeshData>();
    const std::uint32_t rows = 2 * n, columns = 4 * n;
    constexpr double pi = 3.14159265358979;
    for (std::uint32_t row = 0; row <= rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double v = pi * row / rows, u = 2 * pi * column / columns, r = radius(u, v);
            mesh->positions.emplace_back(r * std::sin(v) * std::cos(u), r * std::sin(v) * std::sin(u),
                                         r * std::cos(v));
        }
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t next = (column + 1) % columns, top = row * columns, bottom = top + columns;
            for (const std::uint32_t index :
                 {top + column, bottom + column, bottom + next, top + column, bottom + next, top + next})
                mesh->positionIndex.push_back(index);
        }
    mesh->findBounds();
    return mesh;
}

}  // namespace raytracer::test
