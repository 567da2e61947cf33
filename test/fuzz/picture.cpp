// Any bytes as a PNG or JPEG. Checksums are made right first, or hardly anything would get behind them.
#include <libdeflate.h>

#include <cstdint>
#include <optional>
#include <string_view>

#include "memory_file.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"

// What a picture may take: an input of some bytes may ask for gigabytes. libFuzzer itself takes 20 MB at
// once.
extern "C" const char* __asan_default_options() {
    return "allocator_may_return_null=1:max_allocation_size_mb=32";
}

namespace {

void setChecksums(std::string& png) {
    constexpr std::size_t signature = 8, frame = 12;
    for (std::size_t chunk = signature; chunk + frame <= png.size();) {
        std::size_t length = 0;
        for (std::size_t i = chunk; i < chunk + 4; ++i)
            length = length << 8 | static_cast<std::uint8_t>(png[i]);
        if (length > png.size() - chunk - frame) return;
        const std::uint32_t checksum = libdeflate_crc32(0, &png[chunk + 4], length + 4);
        for (std::size_t i = 0; i < 4; ++i)
            png[chunk + 8 + length + i] = static_cast<char>(checksum >> (24 - 8 * i));
        chunk += length + frame;
    }
}

// More pixels than show a fault, but not so many that the memory for them is refused above.
bool isSlow(const std::optional<raytracer::ImageSize>& size) {
    if (!size) return false;
    const std::int64_t pixels = std::int64_t{size->width} * size->height;
    return pixels > 1 << 14 && pixels < 1 << 28;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(Bytes data, std::size_t size) {
    static const MemoryFile file;
    std::string bytes(reinterpret_cast<const char*>(data), size);
    if (bytes.starts_with("\x89PNG")) setChecksums(bytes);
    try {
        const std::string& path = file.write(bytes);
        if (isSlow(raytracer::sizeInHeader(raytracer::FileBytes(path)))) return -1;
        const raytracer::Texture texture = raytracer::readTexture(path);
        const std::size_t channels = std::size_t{3} * texture.width * texture.height;
        MemoryFile::require(channels > 0 && texture.texels.size() + texture.deepTexels.size() == channels);
    } catch (const raytracer::Error&) {
    }
    return 0;
}
