// What the header of a picture says, before it is decoded.
#include <limits>

#include <stb_image.h>

#include "raytracer/pictures/image.h"
#include "raytracer/util/memory.h"

namespace raytracer {

std::optional<ImageSize> sizeInHeader(const FileBytes& file) {
    const std::string_view text = file.text();
    ImageSize size;
    int channels = 0;
    if (text.size() > std::numeric_limits<int>::max() ||
        !stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(text.data()), static_cast<int>(text.size()),
                               &size.width, &size.height, &channels))
        return std::nullopt;
    return size;
}

// While it decodes, stb holds the picture up to three times, with up to 4 channels; the result has 3.
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
