// Reads the header of a picture before it is decoded. This does not use stb: to find a JPEG's size, stb
// parses tables that have not been checked yet.
#include <algorithm>

#include "jpeg_check.h"
#include "png_chunks.h"
#include "png_format.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/text.h"

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

std::string inWords(const ImageSize& size) {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
}

bool isPicture(const std::string& file) {
    static constexpr const char* endings[] = {".png", ".jpg", ".jpeg", ".pfm", ".ppm",
                                              ".bmp", ".gif", ".tif",  ".tiff"};
    return std::ranges::any_of(endings, [&](const char* ending) { return endsIn(file, ending); });
}

std::string rgbInWords(const std::uint8_t* pixel) {
    return formatted("(%d, %d, %d)", pixel[0], pixel[1], pixel[2]);
}

std::string pixelsInWords(int width, int height) {
    return std::to_string(width) + " × " + std::to_string(height) + " pixels";
}

}  // namespace raytracer
