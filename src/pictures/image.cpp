#include "raytracer/pictures/image.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

#include <libdeflate.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/number.h"

namespace raytracer {
namespace {

// Measured by bench/png_levels (bench/README.md).
constexpr int pngFilter = 2;
constexpr int deflateLevel = 1;

constexpr std::size_t channels = 3;
constexpr std::size_t largestStbSize = std::numeric_limits<int>::max();

// stb 2.27 refuses a JPEG that stops in the middle; 2.29 reads it as if it were whole (its issue 1608). The
// bytes 0xff 0xd9 are the end marker, and never occur in a picture's data.
bool isTruncatedJpeg(std::string_view file) {
    return file.starts_with("\xff\xd8") && file.find("\xff\xd9") == file.npos;
}

std::uint32_t bigEndian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

// A chunk of a PNG: length, type, data of that length, and a CRC of type and data.
constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t chunkFrame = 12;

// The whole chunk that the text begins with; empty where it is cut short or its checksum is wrong. stb
// ignores checksums, so a flipped bit would pass for another colour.
std::string_view firstChunk(std::string_view text) {
    if (text.size() < chunkFrame) return {};
    const std::size_t length = bigEndian(text);
    if (length > text.size() - chunkFrame) return {};
    const std::uint32_t crc = libdeflate_crc32(0, text.data() + 4, 4 + length);
    return crc == bigEndian(text.substr(8 + length)) ? text.substr(0, chunkFrame + length)
                                                     : std::string_view{};
}

std::vector<std::string_view> readChunks(const FileBytes& file) {
    std::string_view png = file.text();
    std::vector<std::string_view> chunks;
    do {
        png.remove_prefix(chunks.empty() ? pngSignature.size() : chunks.back().size());
        chunks.push_back(firstChunk(png));
        if (chunks.back().empty())
            file.fail("broken PNG picture: it is cut short, or a checksum in it is wrong");
    } while (chunks.back().substr(4, 4) != "IEND");
    return chunks;
}

// For a texel beyond the palette, stb returns whatever its memory holds. So a palette of 256 transparent
// colours is put before the file's own, and the file's transparency is left out: a texel that is still
// transparent is beyond the file's palette.
std::string withWholePalette(const std::vector<std::string_view>& chunks) {
    const auto chunk = [](std::string_view head, std::size_t size) {
        return std::string(head) +
               std::string(size + 4, '\0');  // black, or transparent; and a checksum, which stb ignores
    };
    std::string png(pngSignature);
    for (const std::string_view& own : chunks) {
        if (own.substr(4, 4) != "tRNS") png += own;
        if (&own == &chunks.front()) png += chunk({"\0\0\3\0PLTE", 8}, 768) + chunk({"\0\0\1\0tRNS", 8}, 256);
    }
    return png;
}

bool hasPalette(std::string_view header) {
    constexpr std::size_t colorType = 17;
    return header.size() > colorType && (header[colorType] & 3) == 3;
}

using Decoded = std::unique_ptr<stbi_uc, decltype(&stbi_image_free)>;

// The pixels, each of `wanted` bytes, of `text`: the file's own, or the same with another palette.
Decoded decode(const FileBytes& file, std::string_view text, int wanted, ByteImage& image) {
    int channelsInFile = 0;
    stbi_uc* const pixels =
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(text.data()), static_cast<int>(text.size()),
                              &image.width, &image.height, &channelsInFile, wanted);
    if (!pixels) file.fail(std::string("cannot decode as PNG or JPEG: ") + stbi_failure_reason());
    return {pixels, &stbi_image_free};
}

ByteImage decodePaletted(const FileBytes& file, const std::vector<std::string_view>& chunks) {
    ByteImage image;
    const Decoded pixels = decode(file, withWholePalette(chunks), 4, image);
    const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    for (const stbi_uc* p = pixels.get(); p != pixels.get() + 4 * count; p += 4) {
        if (p[3] == 0) file.fail("broken PNG picture: a texel has a colour beyond its palette");
        image.pixels.insert(image.pixels.end(), p, p + channels);
    }
    return image;
}

ByteImage decode(const FileBytes& file) {
    const std::string_view text = file.text();
    if (text.size() > largestStbSize / 2) file.fail("cannot decode: the file is over 1 GiB");
    if (isTruncatedJpeg(text)) file.fail("broken JPEG picture: it has no end marker");
    if (text.starts_with(pngSignature)) {
        const auto chunks = readChunks(file);
        if (hasPalette(chunks.front())) return decodePaletted(file, chunks);
    }
    ByteImage image;
    const Decoded pixels = decode(file, text, static_cast<int>(channels), image);
    const auto count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * channels;
    image.pixels.assign(pixels.get(), pixels.get() + count);
    return image;
}

// stb counts in int: the pixels, one filter byte for each row, and the compressed stream, which is at most a
// little larger than both. Half the range of int leaves room for that.
void requireEncodable(const ByteImage& image, const std::string& path) {
    const std::size_t rowBytes = static_cast<std::size_t>(image.width) * channels + 1;
    if (rowBytes * static_cast<std::size_t>(image.height) > largestStbSize / 2)
        throw Error({path}, "cannot write: the picture is too large for PNG");
}

// The header of a PFM: "PF", width, height, scale, whose sign is the byte order (negative: little endian) and
// whose size, a unit on which programs disagree, is ignored; one blank; then the rows, the bottom row first.
struct PfmHeader {
    int width = 0, height = 0;
    std::endian order = std::endian::little;
    std::string_view rows;
};

std::string_view takeWord(std::string_view& text) {
    constexpr std::string_view blanks = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

template <class Number>
Number takeNumber(const FileBytes& file, std::string_view& text, const char* what) {
    const std::optional<Number> number = numberOf<Number>(takeWord(text));
    if (!number) file.fail(std::string("not a PFM picture: its ") + what + " is no number");
    return *number;
}

PfmHeader readPfmHeader(const FileBytes& file) {
    std::string_view text = file.text();
    if (takeWord(text) != "PF") file.fail("not a colour PFM picture: it does not begin with \"PF\"");
    PfmHeader header;
    header.width = takeNumber<int>(file, text, "width");
    header.height = takeNumber<int>(file, text, "height");
    const auto scale = takeNumber<double>(file, text, "scale");
    if (header.width < 1 || header.height < 1) file.fail("not a PFM picture: it has no pixels");
    header.order = scale < 0 ? std::endian::little : std::endian::big;
    header.rows = text.substr(std::min<std::size_t>(1, text.size()));
    return header;
}

std::size_t pixelBytes(const PfmHeader& header) {
    return static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height) * channels *
           sizeof(float);
}

// GCC and Clang compile this to a byte swap.
float swapBytes(float value) {
    auto bytes = std::bit_cast<std::array<char, sizeof value>>(value);
    std::ranges::reverse(bytes);
    return std::bit_cast<float>(bytes);
}

FloatImage decodePfm(const FileBytes& file) {
    const PfmHeader header = readPfmHeader(file);
    if (header.rows.size() < pixelBytes(header))
        file.fail("broken PFM picture: it ends before its last pixel");
    FloatImage image{header.width, header.height, std::vector<float>(pixelBytes(header) / sizeof(float))};
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

}  // namespace

ByteImage readImage(const std::string& path) { return decode(FileBytes(path)); }

FloatImage readPfm(const std::string& path) { return decodePfm(FileBytes(path)); }

std::vector<char> encodePng(const ByteImage& image, const std::string& path) {
    requireEncodable(image, path);
    stbi_write_force_png_filter = pngFilter;
    stbi_write_png_compression_level = deflateLevel;
    std::vector<char> png;
    const auto append = [](void* to, void* bytes, int count) {
        const auto* const begin = static_cast<const char*>(bytes);
        static_cast<std::vector<char>*>(to)->assign(begin, begin + count);
    };
    if (!stbi_write_png_to_func(append, &png, image.width, image.height, static_cast<int>(channels),
                                image.pixels.data(), 0))
        throw Error({path}, "cannot write: not enough memory");
    return png;
}

void writePng(const std::string& path, const ByteImage& image) {
    const std::vector<char> png = encodePng(image, path);
    const std::span<const char> whole = png;
    writeFile(path, {&whole, 1});
}

void writePfm(const std::string& path, const FloatImage& image) {
    const char* const scale = std::endian::native == std::endian::little ? "-1.0" : "1.0";
    const std::string header =
        "PF\n" + std::to_string(image.width) + ' ' + std::to_string(image.height) + '\n' + scale + '\n';
    const std::size_t rowFloats = static_cast<std::size_t>(image.width) * channels;
    std::vector<std::span<const char>> parts{header};
    for (auto y = static_cast<std::size_t>(image.height); y-- > 0;)
        parts.emplace_back(reinterpret_cast<const char*>(image.pixels.data() + y * rowFloats),
                           rowFloats * sizeof(float));
    writeFile(path, parts);
}

}  // namespace raytracer
