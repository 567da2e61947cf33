// Reads the header of a picture before it is decoded. This does not use stb: to find a JPEG's size, stb
// parses tables that have not been checked yet.
#include "jpeg_check.h"
#include "png_chunks.h"
#include "png_format.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/memory.h"

namespace raytracer {

std::optional<ImageSize> sizeInHeader(const FileBytes& file) {
    if (isJpeg(file)) return sizeOfJpeg(file);
    constexpr std::size_t untilSize = 16;  // bytes of the header's chunk: length, type, width, height
    const std::string_view text = file.text();
    if (!text.starts_with(pngSignature)) return std::nullopt;
    const std::string_view header = text.substr(pngSignature.size());
    if (header.size() < untilSize || typeOf(header) != "IHDR") return std::nullopt;
    const ImageSize size = sizeOf(header);
    return size.width > 0 && size.height > 0 ? std::optional(size) : std::nullopt;
}

// While it decodes, stb holds up to three copies of the picture, of up to 4 channels each. The result has 3.
void requireMemoryToDecode(const FileBytes& file, std::size_t channelBytes) {
    const auto size = sizeInHeader(file);
    if (!size) return;
    const double channel = static_cast<double>(channelBytes) * size->width * size->height;
    requireMemory(file.path(), pixelsInWords(size->width, size->height), (3 + 12) * channel);
}

std::string pixelsInWords(int width, int height) {
    return std::to_string(width) + " × " + std::to_string(height) + " pixels";
}

}  // namespace raytracer
