#include "raytracer/pictures/image.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string_view>

#include <stb_image_write.h>

#include "deflate.h"
#include "png_format.h"
#include "raytracer/util/error.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"
#include "whole_picture.h"

namespace raytracer {
namespace {

constexpr std::size_t valuesPerPixel = 3;
constexpr std::size_t largestStbSize = std::numeric_limits<int>::max();

// The header of a PFM: "PF", width, height, scale and one blank. The rows follow, the bottom row first. The
// scale's sign tells the byte order (negative: little endian). Its magnitude is ignored: it is a unit on
// which programs disagree.
struct PfmHeader : ImageSize {
    std::endian order = std::endian::little;
    std::string_view rows;
};

constexpr std::string_view pfmBlanks = " \t\r\n";

std::string_view takeWord(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(pfmBlanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(pfmBlanks));
    text.remove_prefix(word.size());
    return word;
}

constexpr const char* noPixels = "not a PFM picture: it has no pixels";

template <class Number>
Number takeNumber(const FileBytes& file, std::string_view& text, const char* what) {
    const std::string_view word = takeWord(text);
    const std::optional<Number> number = numberOf<Number>(word);
    if (number) return *number;
    if (!isWholeNumber(word)) file.fail(std::string("not a PFM picture: its ") + what + " is no number");
    if (word[0] == '-') file.fail(noPixels);
    file.fail(std::string("cannot read: its ") + what + " is too large, " + inQuotes(word) + ": at most " +
              std::to_string(std::numeric_limits<Number>::max()));
}

std::size_t pixelBytes(const PfmHeader& header) { return header.area() * valuesPerPixel * sizeof(float); }

PfmHeader readPfmHeader(const FileBytes& file) {
    std::string_view text = file.text();
    if (takeWord(text) != "PF") file.fail("not a colour PFM picture: it does not begin with \"PF\"");
    PfmHeader header;
    header.width = takeNumber<int>(file, text, "width");
    header.height = takeNumber<int>(file, text, "height");
    const auto scale = takeNumber<double>(file, text, "scale");
    if (!std::isfinite(scale)) file.fail("not a PFM picture: its scale is no finite number");
    if (scale == 0) file.fail("not a PFM picture: its scale is 0, which has no sign to tell the byte order");
    if (header.width < 1 || header.height < 1) file.fail(noPixels);
    header.order = scale < 0 ? std::endian::little : std::endian::big;
    header.rows = text.substr(std::min<std::size_t>(1, text.size()));
    return header;
}

// GCC and Clang compile this to a byte swap.
float swapBytes(float value) {
    auto bytes = std::bit_cast<std::array<char, sizeof value>>(value);
    std::ranges::reverse(bytes);
    return std::bit_cast<float>(bytes);
}

PfmHeader readWholePfm(const FileBytes& file) {
    PfmHeader header = readPfmHeader(file);
    const std::size_t pixels = header.rows.size() / (valuesPerPixel * sizeof(float));
    if (pixels / static_cast<std::size_t>(header.width) < static_cast<std::size_t>(header.height))
        file.fail("broken PFM picture: it ends before its last pixel");
    // Some programs end the header with more than one blank, such as Windows' line end.
    const std::size_t excess = header.rows.size() - pixelBytes(header);
    if (header.rows.substr(0, excess).find_first_not_of(pfmBlanks) != header.rows.npos)
        file.fail("broken PFM picture: it goes on behind its last pixel");
    header.rows.remove_prefix(excess);
    return header;
}

// stb counts bytes in int: those of the pixels, with one filter byte for each row, and those of the
// compressed stream, which is at most a little larger. Half the range of int leaves room for that.
bool fitsPng(int width, int height) {
    const std::size_t rowBytes = static_cast<std::size_t>(width) * valuesPerPixel + 1;
    return rowBytes * static_cast<std::size_t>(height) <= largestStbSize / 2;
}

}  // namespace

ImageSize sizeOfWholePfm(const FileBytes& file) {
    const PfmHeader header = readWholePfm(file);
    const ImageSize& size = header;
    return size;
}

FloatImage readPfm(const FileBytes& file) {
    const PfmHeader header = readWholePfm(file);
    requireMemory(file.path(), pixelsInWords(header.width, header.height),
                  static_cast<double>(pixelBytes(header)));
    const ImageSize& size = header;
    FloatImage image{size, LargeVector<float>(pixelBytes(header) / sizeof(float))};
    const std::size_t rowBytes = pixelBytes(header) / static_cast<std::size_t>(header.height);
    const char* row = header.rows.data() + pixelBytes(header);
    for (float* to = image.pixels.data(); row != header.rows.data(); to += rowBytes / sizeof(float)) {
        row -= rowBytes;
        std::memcpy(to, row, rowBytes);
    }
    if (header.order != std::endian::native)
        std::ranges::transform(image.pixels, image.pixels.begin(), swapBytes);
    return image;
}

std::vector<char> encodePng(const ByteImage& image, const std::string& path, int threads) {
    if (!fitsPng(image.width, image.height))
        throw Error({path}, "cannot write: the picture is too large for PNG");
    [[maybe_unused]] static const bool stbIsSet = [] {  // once: stb's variables are global
        stbi_write_force_png_filter = pngFilter;
        stbi_write_png_compression_level = deflateLevel;
        return true;
    }();
    setDeflateThreads(threads);
    std::vector<char> png;
    const auto append = [](void* to, void* bytes, int count) {
        const auto* const begin = static_cast<const char*>(bytes);
        static_cast<std::vector<char>*>(to)->assign(begin, begin + count);
    };
    if (!stbi_write_png_to_func(append, &png, image.width, image.height, static_cast<int>(valuesPerPixel),
                                image.pixels.data(), 0))
        throw OutOfMemory({path}, "cannot write: not enough memory");
    return png;
}

void writePng(OutputFile&& file, const ByteImage& image, int threads) {
    file.write(encodePng(image, file.name(), threads));
}

}  // namespace raytracer
