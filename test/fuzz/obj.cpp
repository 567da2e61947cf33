// Any bytes as an OBJ mesh: what comes out can be rendered.
#include <algorithm>
#include <string_view>

#include "memory_file.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/util/error.h"

namespace {

using raytracer::MeshData;

void requireUsable(const MeshData& mesh) {
    const auto within = [](std::size_t count) {
        return [count](std::uint32_t index) { return index < count; };
    };
    MemoryFile::require(!mesh.positionIndex.empty() && mesh.positionIndex.size() % 3 == 0);
    MemoryFile::require(std::ranges::all_of(mesh.positionIndex, within(mesh.positions.size())));
    MemoryFile::require(mesh.texCoordIndex.empty() || mesh.texCoordIndex.size() == mesh.positionIndex.size());
    MemoryFile::require(std::ranges::all_of(mesh.texCoordIndex, [&](std::uint32_t index) {
        return index == MeshData::noTexCoord || index < mesh.texCoords.size();
    }));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(Bytes data, std::size_t size) {
    try {
        requireUsable(raytracer::parseObj({reinterpret_cast<const char*>(data), size}));
    } catch (const raytracer::Error&) {
    }
    return 0;
}
