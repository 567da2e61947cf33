// Triangle meshes from Wavefront OBJ files.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raytracer/util/large_vector.h"

namespace raytracer {

// An indexed triangle mesh in object space. Triangle i has the corners positions[positionIndex[3i + 0..2]],
// counter-clockwise seen from outside, in file order. A polygon of n corners is n - 2 triangles: the fan
// about its first corner, if it is convex.
struct MeshData {
    LargeVector<glm::dvec3> positions;         // in units of 2^exponent of the file's
    LargeVector<glm::dvec2> texCoords;         // (u, v), v up
    LargeVector<std::uint32_t> positionIndex;  // 3 for each triangle
    LargeVector<std::uint32_t> texCoordIndex;  // 3 for each triangle, or empty where no face has vt
    static constexpr std::uint32_t noTexCoord = ~std::uint32_t{0};  // for a corner without vt: (0, 0)
    // At most 10 words each in the leaves of the tree, where a place has 31 bits.
    static constexpr std::size_t mostTriangles = 200'000'000;

    // The smallest box around all positions. Code that fills `positions` then calls findBounds once.
    glm::dvec3 low{0}, high{0};
    void findBounds();

    // Chooses the unit in which the largest coordinate is of the order of 1, so that products of positions do
    // not over- or underflow. No coordinate loses a digit. Called once, after findBounds.
    void chooseUnit();
    int exponent = 0;
    double finest = 1;  // a lower bound on the mesh's thickness and its least triangle, relative to its size

    std::size_t triangleCount() const { return positionIndex.size() / 3; }
};

// Reads positions, texture coordinates and faces (any polygons, negative indices, v, v/vt, v//vn, v/vt/vn);
// ignores groups, objects, normals, materials and smoothing. Throws Error, with the line where it can, if the
// file is missing, unreadable or not an OBJ of this kind. `threads`: as threadCount's.
MeshData loadObj(const std::string& path, int threads = 0);

// The same from text in memory. `path` is the file's name in an Error.
MeshData parseObj(std::string_view text, const std::string& path = {}, int threads = 0);

}  // namespace raytracer
