// PNG and JPEG, by way of stb_image, which takes more for a picture than we do.
#include <algorithm>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include <libdeflate.h>
#include <stb_image.h>

#include "jpeg_check.h"
#include "png_format.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/memory.h"
#include "whole_picture.h"

namespace raytracer {
namespace {

constexpr int rgb = 3;

std::uint32_t bigEndian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

// A chunk of a PNG: length, type, data of that length, and a CRC of type and data.
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

std::string_view typeOf(std::string_view chunk) { return chunk.substr(4, 4); }

// What the header says, after width and height, and the values that there are.
struct HeaderField {
    std::size_t place;
    const char* name;
    std::string_view values;
};
using namespace std::string_view_literals;
constexpr HeaderField colorType{17, "colour type", "\0\2\3\4\6"sv};
constexpr HeaderField otherFields[] = {
    {18, "compression method", "\0"sv}, {19, "filter method", "\0"sv}, {20, "interlace method", "\0\1"sv}};

HeaderField bitDepth(char ofColorType) {
    const std::string_view values = "\x10\x8\4\2\1";
    const bool isGrey = ofColorType == 0, hasPalette = ofColorType == 3;
    return {16, "bit depth", isGrey ? values : hasPalette ? values.substr(1) : values.substr(0, 2)};
}

bool isPaletted(std::string_view header) { return header[colorType.place] == 3; }

void requireSoundHeader(const FileBytes& file, std::string_view header) {
    const auto fail = [&](const std::string& name, std::uint32_t value, const char* none) {
        file.fail("broken PNG picture: its " + name + " is " + std::to_string(value) + ", which " + none +
                  " has");
    };
    const auto require = [&](const HeaderField& field, const char* none) {
        const char value = header[field.place];
        if (field.values.find(value) == field.values.npos)
            fail(field.name, static_cast<unsigned char>(value), none);
    };
    for (const auto& [place, name] : {std::pair{8U, "width"}, {12U, "height"}}) {
        const std::uint32_t size = bigEndian(header.substr(place));
        if (size == 0 || size >> 31 != 0) fail(name, size, "no PNG");
    }
    require(colorType, "no PNG");
    require(bitDepth(header[colorType.place]), "no PNG of its colour type");
    for (const HeaderField& field : otherFields) require(field, "no PNG");
}

void requirePaletteAndPixels(const FileBytes& file, const std::vector<std::string_view>& chunks) {
    bool hasPalette = !isPaletted(chunks.front());
    for (const std::string_view chunk : chunks) {
        const std::size_t size = chunk.size() - chunkFrame;
        if (typeOf(chunk) == "PLTE" && (size == 0 || size % 3 != 0 || size > std::size_t{3} * 256))
            file.fail("broken PNG picture: its palette has " + std::to_string(size) +
                      " bytes, not 3 for each of 1 to 256 colours");
        if (typeOf(chunk) == "PLTE") hasPalette = true;
        if (typeOf(chunk) != "IDAT") continue;
        if (!hasPalette) file.fail("broken PNG picture: it has no palette before its pixels");
        return;
    }
    file.fail("broken PNG picture: it has no pixels (no chunk IDAT)");
}

std::vector<std::string_view> readChunks(const FileBytes& file) {
    std::string_view png = file.text();
    std::vector<std::string_view> chunks;
    do {
        png.remove_prefix(chunks.empty() ? pngSignature.size() : chunks.back().size());
        chunks.push_back(firstChunk(png));
        if (chunks.back().empty())
            file.fail("broken PNG picture: it is cut short, or a checksum in it is wrong");
        // Apple's own form, which stb takes: its deflate stream has no header, and its colours another order.
        if (typeOf(chunks.back()) == "CgBI") file.fail("no PNG by the standard, but one made for iOS (CgBI)");
    } while (typeOf(chunks.back()) != "IEND");
    constexpr std::size_t headerSize = 13;
    if (typeOf(chunks.front()) != "IHDR" || chunks.front().size() != chunkFrame + headerSize)
        file.fail("broken PNG picture: it does not begin with its header");
    requireSoundHeader(file, chunks.front());
    requirePaletteAndPixels(file, chunks);
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
        if (typeOf(own) != "tRNS") png += own;
        if (&own == &chunks.front()) png += chunk({"\0\0\3\0PLTE", 8}, 768) + chunk({"\0\0\1\0tRNS", 8}, 256);
    }
    return png;
}

// The bytes of the pixels, with one more for each row, and at most twice that where the picture is
// interlaced.
std::size_t mostInflated(std::string_view header) {
    constexpr std::size_t width = 8, height = 12, bitDepth = 16, mostChannels = 4;
    const std::size_t rowBits =
        bigEndian(header.substr(width)) * mostChannels * static_cast<std::size_t>(header[bitDepth]);
    return 2 * bigEndian(header.substr(height)) * (rowBits / 8 + 2);
}

// stb inflates whatever is there, however small the picture is. Where that could be more than the memory
// holds, it is inflated here before, but not beyond the picture's size.
void requireFewInflated(const FileBytes& file, const std::vector<std::string_view>& chunks) {
    constexpr double mostRatio = 1032;  // of deflate: 258 bytes of 2 bits
    std::string deflated;
    for (const std::string_view chunk : chunks)
        if (typeOf(chunk) == "IDAT") deflated += chunk.substr(8, chunk.size() - chunkFrame);
    if (!sizeInHeader(file) || hasMemory(mostRatio * static_cast<double>(deflated.size()))) return;
    requireMemoryToDecode(file);
    std::vector<char> inflated(mostInflated(chunks.front()));
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(
        libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
    std::size_t size = 0;
    if (libdeflate_zlib_decompress(decompressor.get(), deflated.data(), deflated.size(), inflated.data(),
                                   inflated.size(), &size) == LIBDEFLATE_INSUFFICIENT_SPACE)
        file.fail("broken PNG picture: it has more data than pixels");
}

bool hasDeepTexels(std::string_view header) {
    constexpr std::size_t bitDepth = 16;
    return header.size() > bitDepth && header[bitDepth] == 16;
}

template <class Channel>
using Decoder = Channel* (*)(const stbi_uc*, int, int*, int*, int*, int);

// The pixels, each of `wanted` channels, of `text`: the file's own, or the same with another palette.
template <class Channel>
LargeVector<Channel> decode(const FileBytes& file, std::string_view text, int wanted, Texture& image,
                            Decoder<Channel> decoder) {
    requireMemoryToDecode(file, sizeof(Channel));
    int channelsInFile = 0;
    const std::unique_ptr<Channel, decltype(&stbi_image_free)> pixels(
        decoder(reinterpret_cast<const stbi_uc*>(text.data()), static_cast<int>(text.size()), &image.width,
                &image.height, &channelsInFile, wanted),
        &stbi_image_free);
    if (!pixels) file.fail(std::string("cannot decode as PNG or JPEG: ") + stbi_failure_reason());
    const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    return {pixels.get(), pixels.get() + count * static_cast<std::size_t>(wanted)};
}

void decodePaletted(const FileBytes& file, const std::vector<std::string_view>& chunks, Texture& image) {
    const auto pixels = decode(file, withWholePalette(chunks), 4, image, &stbi_load_from_memory);
    image.texels.resize(pixels.size() / 4 * rgb);
    auto to = image.texels.begin();
    for (std::size_t i = 0; i < pixels.size(); i += 4) {
        if (pixels[i + 3] == 0) file.fail("broken PNG picture: a texel has a colour beyond its palette");
        to = std::copy_n(&pixels[i], rgb, to);
    }
}

Texture decode(const FileBytes& file) {
    const std::string_view text = file.text();
    if (text.size() > std::numeric_limits<int>::max() / 2) file.fail("cannot decode: the file is over 1 GiB");
    const bool isPng = text.starts_with(pngSignature);
    if (isJpeg(file)) requireSoundJpeg(file);
    else if (!isPng) file.fail("it is no PNG and no JPEG");
    std::vector<std::string_view> chunks{{}};
    if (isPng) {
        chunks = readChunks(file);
        requireFewInflated(file, chunks);
    }
    Texture image;
    if (isPng && isPaletted(chunks.front())) decodePaletted(file, chunks, image);
    else if (hasDeepTexels(chunks.front()))
        image.deepTexels = decode(file, text, rgb, image, &stbi_load_16_from_memory);
    else image.texels = decode(file, text, rgb, image, &stbi_load_from_memory);
    return image;
}

}  // namespace

ImageSize sizeOfWholePng(const FileBytes& file) {
    const auto size = sizeInHeader(file);
    if (!size || !file.text().starts_with(pngSignature)) file.fail("not a PNG picture");
    readChunks(file);
    return *size;
}

Texture readTexture(const std::string& path) { return decode(FileBytes(path, FileKind::Regular)); }

ByteImage readImage(const std::string& path, FileKind kind) {
    Texture texture = decode(FileBytes(path, kind));
    for (const std::uint32_t texel : texture.deepTexels)
        texture.texels.push_back(static_cast<std::uint8_t>((255 * texel + 32767) / 65535));
    return {texture.width, texture.height, std::move(texture.texels)};
}

}  // namespace raytracer
