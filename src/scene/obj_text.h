// The text of a whole OBJ file, in chunks that are parsed at the same time. The answer, errors included, does
// not depend on how many there are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "raytracer/scene/mesh_file.h"

namespace raytracer {

MeshData parseObjInChunks(std::string_view text, std::size_t chunkCount, const std::string& path = {});

}  // namespace raytracer
