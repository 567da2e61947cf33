// Whether a JPEG is what stb_image takes it for: stb 2.27 writes past its tables where a Huffman table has
// too many codes, reads tables that the file does not have, and takes half a picture for a whole one.
#pragma once

#include <optional>

#include "raytracer/pictures/image.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer {

bool isJpeg(const FileBytes& file);

// By its frame header; nothing where there is none.
std::optional<ImageSize> sizeOfJpeg(const FileBytes& file);

// Reads a JPEG's segments (ITU-T T.81, annex B) up to its end marker. Throws Error.
void requireSoundJpeg(const FileBytes& file);

}  // namespace raytracer
