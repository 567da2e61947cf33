// The one file that compiles stb's implementation. Readers: PNG and JPEG only. Writers: PNG, with libdeflate, on
// all threads, for stb's own deflate, which is several times slower and makes larger files (bench/png_levels.cpp).
#include <cstddef>
#include <cstdlib>

#include <libdeflate.h>

// src/pictures/deflate.cpp
extern "C" unsigned char* raytracerCompressZlib(unsigned char* data, int length, int* outLength, int level);
extern "C" void* raytracerAllocate(std::size_t size);

// For broken files stb 2.27 returns memory that it has not written.
#define STBI_MALLOC(size) std::calloc(1, size)
#define STBI_REALLOC std::realloc
#define STBI_FREE std::free
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_FAILURE_USERMSG
#define STB_IMAGE_IMPLEMENTATION
#include <stb_image.h>

#define STBIW_MALLOC raytracerAllocate
#define STBIW_REALLOC std::realloc
#define STBIW_FREE std::free
#define STBIW_ZLIB_COMPRESS raytracerCompressZlib
#define STBIW_CRC32(buffer, length) libdeflate_crc32(0, buffer, static_cast<std::size_t>(length))
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>
