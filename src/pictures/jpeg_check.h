// Checks what stb_image does not check in a JPEG. stb 2.27 writes past its tables if a Huffman table has too
// many codes, reads tables that the file does not have, and accepts half a picture as a whole one.
#pragma once

#include <optional>

#include "raytracer/pictures/image.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer {

bool isJpeg(const FileBytes& file);

// From the frame header; empty if there is none.
std::optional<ImageSize> sizeOfJpeg(const FileBytes& file);

// Checks a JPEG's segments (ITU-T T.81, annex B) up to its end marker. Throws Error if one is broken.
void requireSoundJpeg(const FileBytes& file);

}  // namespace raytracer
