// The one file that compiles stb's implementation. Readers: PNG and JPEG only. Writers: PNG, with libdeflate for stb's
// own deflate, which is several times slower and makes larger files (bench/png_levels.cpp).
#include <cstddef>
#include <cstdlib>

#include <libdeflate.h>

namespace {

// stb's hook: a zlib stream in memory from malloc, or null. `level` is stbi_write_png_compression_level, 1 to 12.
unsigned char* compressZlib(unsigned char* data, int length, int* outLength, int level) {
    libdeflate_compressor* const compressor = libdeflate_alloc_compressor(level);
    if (!compressor) return nullptr;
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor, static_cast<std::size_t>(length));
    auto* const out = static_cast<unsigned char*>(std::malloc(bound));
    if (out) {
        *outLength = static_cast<int>(
            libdeflate_zlib_compress(compressor, data, static_cast<std::size_t>(length), out, bound));
    }
    libdeflate_free_compressor(compressor);
    return out;
}

}  // namespace

// For broken files stb 2.27 returns memory that it has not written.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC std::realloc
#define STBI_FREE std::free
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_FAILURE_USERMSG
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

#define STBIW_ZLIB_COMPRESS compressZlib
#define STBIW_CRC32(buffer, length) libdeflate_crc32(0, buffer, static_cast<std::size_t>(length))
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
