// Reads the chunks of a PNG, checks them, and reads its header's fields.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <libdeflate.h>

#include "raytracer/pictures/image.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer {

std::uint32_t bigEndian(std::string_view bytes);

// All chunks, the header first and IEND last. Throws Error if one is broken or missing. The checksums are
// checked here since stb ignores them: a flipped bit would pass for another colour.
std::vector<std::string_view> readChunks(const FileBytes& file);

std::string_view typeOf(std::string_view chunk);

// These take a header that readChunks has checked: the whole IHDR chunk.
ImageSize sizeOf(std::string_view header);
int colorTypeOf(std::string_view header);
bool isPaletted(std::string_view header);
std::size_t channelsOf(std::string_view header);  // in the file; 1 for a palette
std::size_t bitDepthOf(std::string_view header);
std::size_t inflatedSize(std::string_view header);  // bytes of all rows, with each one's filter byte
bool hasDeepTexels(std::string_view header);        // 16 bits; false for an empty header

std::string deflatedData(const std::vector<std::string_view>& chunks);

// Inflates the data, but not beyond the picture's size, and returns whether that worked. Throws bad_alloc.
libdeflate_result inflate(const std::string& deflated, std::string_view header);

}  // namespace raytracer
