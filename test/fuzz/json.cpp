// Any bytes as a scene file.
#include "memory_file.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/error.h"

extern "C" int LLVMFuzzerTestOneInput(Bytes data, std::size_t size) {
    static const MemoryFile file;
    try {
        raytracer::loadScene(file.write(data, size));
    } catch (const raytracer::Error&) {
    }
    return 0;
}
