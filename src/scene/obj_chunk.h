// One chunk of an OBJ file: whole lines of its text. Each chunk is counted first. Then it is parsed with two
// counts: of everything above it, and of the whole file. So chunks can be parsed in parallel, and an Error is
// the same as in one pass.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "raytracer/scene/mesh_file.h"

namespace raytracer {

struct ObjCounts {
    std::size_t lines = 0, positions = 0, texCoords = 0, faces = 0, triangles = 0;
    bool hasReturns = false;  // line ends that are a carriage return alone
    bool hasNul = false;

    ObjCounts& operator+=(const ObjCounts& other);
};

// What is known of a chunk's faces besides the mesh.
struct ObjFaces {
    // A face of more than three corners: the fan of its triangles.
    struct Polygon {
        std::uint32_t firstTriangle, corners;
    };

    std::vector<Polygon> polygons;
    bool textured = false;  // one has texture coordinates
};

struct ObjChunk {
    std::string_view text;
    const std::string& path;  // of the whole file, for errors
};

// Counts nothing in a chunk that has either of hasReturns and hasNul.
ObjCounts countObjChunk(std::string_view chunk);

// Fills the chunk's part of the mesh, whose vectors have their final sizes already (texCoordIndex where there
// are texture coordinates). Throws Error at the first line with a mistake.
ObjFaces parseObjChunk(const ObjChunk& chunk, const ObjCounts& above, const ObjCounts& whole, MeshData& mesh);

// Replaces the fans of polygons that are not convex by triangles that cover exactly the polygon. All
// positions of the mesh must have been parsed.
void cutConcavePolygons(const ObjFaces& faces, MeshData& mesh);

// Parses the whole text in so many chunks, in parallel. Neither the mesh nor an Error depends on their
// number.
MeshData parseObjInChunks(std::string_view text, std::size_t chunkCount, const std::string& path = {},
                          int threads = 0);

// Throws Error where a mesh of so many triangles is too large.
void requireTriangles(std::size_t count, const std::string& path);

}  // namespace raytracer
