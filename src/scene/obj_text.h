// Parses the text of a whole OBJ file in chunks, in parallel. Neither the mesh nor an Error depends on their
// number.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "raytracer/scene/mesh_file.h"

namespace raytracer {

MeshData parseObjInChunks(std::string_view text, std::size_t chunkCount, const std::string& path = {});

}  // namespace raytracer
