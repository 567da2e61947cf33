// The chunks of a PNG, checked, and what its header says.
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

// All, the header first and IEND last. Throws Error where one is broken or missing. stb ignores checksums, so
// a flipped bit would pass for another colour.
std::vector<std::string_view> readChunks(const FileBytes& file);

std::string_view typeOf(std::string_view chunk);

// Of a sound header.
ImageSize sizeOf(std::string_view header);
int colorTypeOf(std::string_view header);
bool isPaletted(std::string_view header);
std::size_t channelsOf(std::string_view header);  // in the file: one of a palette
std::size_t bitDepthOf(std::string_view header);
std::size_t inflatedSize(std::string_view header);  // the bytes of all rows, with one more for each
bool hasDeepTexels(std::string_view header);        // 16 bits; false for an empty one

std::string deflatedData(const std::vector<std::string_view>& chunks);

// What becomes of the data, which are not inflated beyond the picture's size. Throws bad_alloc.
libdeflate_result inflate(const std::string& deflated, std::string_view header);

}  // namespace raytracer
