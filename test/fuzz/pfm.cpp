// Any bytes as a PFM.
#include "memory_file.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/error.h"

extern "C" int LLVMFuzzerTestOneInput(Bytes data, std::size_t size) {
    static const MemoryFile file;
    try {
        const raytracer::FloatImage image = raytracer::readPfm(file.write(data, size));
        MemoryFile::require(image.width > 0 && image.height > 0 &&
                            image.pixels.size() == std::size_t{3} * image.width * image.height);
    } catch (const raytracer::Error&) {
    }
    return 0;
}
