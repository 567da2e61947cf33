#include "png_chunks.h"

#include <memory>
#include <new>
#include <span>
#include <utility>

#include "png_format.h"

namespace raytracer {

std::uint32_t bigEndian(std::string_view bytes) {
    std::uint32_t number = 0;
    for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
}

std::string_view typeOf(std::string_view chunk) { return chunk.substr(4, 4); }

namespace {

// A chunk is a length, a type, data of that length, and
// a CRC of type and data. This is its size without data.
constexpr std::size_t chunkFrame = 12;

// The chunk at the beginning of the text; empty if it is cut short or its checksum is wrong.
std::string_view firstChunk(std::string_view text) {
    if (text.size() < chunkFrame) return {};
    const std::size_t length = bigEndian(text);
    if (length > text.size() - chunkFrame) return {};
    const std::uint32_t crc = libdeflate_crc32(0, text.data() + 4, 4 + length);
    return crc == bigEndian(text.substr(8 + length)) ? text.substr(0, chunkFrame + length)
                                                     : std::string_view{};
}

constexpr std::size_t widthPlace = 8, heightPlace = 12;  // in the header's chunk

// A field of the header behind width and height: its place in the chunk, its name and the values it may have.
struct HeaderField {
    std::size_t place;
    const char* name;
    std::string_view values;
};
using namespace std::string_view_literals;
constexpr HeaderField colorType{17, "colour type", "\0\2\3\4\6"sv};
constexpr HeaderField interlaceMethod{20, "interlace method", "\0\1"sv};
constexpr HeaderField otherFields[] = {
    {18, "compression method", "\0"sv}, {19, "filter method", "\0"sv}, interlaceMethod};

bool isInterlaced(std::string_view header) { return header[interlaceMethod.place] != 0; }

constexpr std::size_t bitDepthPlace = 16;

HeaderField bitDepth(int ofColorType) {
    const std::string_view values = "\x10\x8\4\2\1";
    const bool isGrey = ofColorType == 0, hasPalette = ofColorType == 3;
    return {bitDepthPlace, "bit depth",
            isGrey       ? values
            : hasPalette ? values.substr(1)
                         : values.substr(0, 2)};
}

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
    for (const auto& [place, name] : {std::pair{widthPlace, "width"}, {heightPlace, "height"}}) {
        const std::uint32_t size = bigEndian(header.substr(place));
        if (size == 0 || size >> 31 != 0) fail(name, size, "no PNG");
    }
    require(colorType, "no PNG");
    require(bitDepth(colorTypeOf(header)), "no PNG of its colour type");
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

// Every dx-th pixel of every dy-th row, starting at (x, y).
struct Lattice {
    std::size_t x, y, dx, dy;
};
constexpr Lattice allPixels[] = {{0, 0, 1, 1}};
// The passes of an interlaced picture (PNG specification, 8.2).
constexpr Lattice adam7[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                             {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};

}  // namespace

ImageSize sizeOf(std::string_view header) {
    return {static_cast<int>(bigEndian(header.substr(widthPlace))),
            static_cast<int>(bigEndian(header.substr(heightPlace)))};
}

int colorTypeOf(std::string_view header) { return header[colorType.place]; }

bool isPaletted(std::string_view header) { return colorTypeOf(header) == 3; }

std::size_t channelsOf(std::string_view header) {
    constexpr std::size_t channels[] = {1, 0, 3, 1, 2, 0, 4};
    return channels[colorTypeOf(header)];
}

std::size_t bitDepthOf(std::string_view header) { return static_cast<std::size_t>(header[bitDepthPlace]); }

bool hasDeepTexels(std::string_view header) { return !header.empty() && bitDepthOf(header) == 16; }

std::size_t inflatedSize(std::string_view header) {
    const ImageSize size = sizeOf(header);
    const auto width = static_cast<std::size_t>(size.width), height = static_cast<std::size_t>(size.height);
    const auto count = [](std::size_t all, std::size_t first, std::size_t step) {
        return all > first ? (all - first - 1) / step + 1 : 0;
    };
    std::span<const Lattice> lattices = allPixels;
    if (isInterlaced(header)) lattices = adam7;
    std::size_t bytes = 0;
    for (const Lattice& some : lattices) {
        const std::size_t columns = count(width, some.x, some.dx), rows = count(height, some.y, some.dy);
        const std::size_t rowBits = columns * channelsOf(header) * bitDepthOf(header);
        if (columns > 0) bytes += rows * (1 + (rowBits + 7) / 8);
    }
    return bytes;
}

std::vector<std::string_view> readChunks(const FileBytes& file) {
    std::string_view png = file.text();
    std::vector<std::string_view> chunks;
    do {
        png.remove_prefix(chunks.empty() ? pngSignature.size() : chunks.back().size());
        chunks.push_back(firstChunk(png));
        if (chunks.back().empty())
            file.fail("broken PNG picture: it is cut short, or a checksum in it is wrong");
        // Apple's variant: its deflate stream has no header, and
        // its colours are in another order. stb would accept it.
        if (typeOf(chunks.back()) == "CgBI") file.fail("no PNG by the standard, but one made for iOS (CgBI)");
    } while (typeOf(chunks.back()) != "IEND");
    constexpr std::size_t headerSize = 13;
    if (typeOf(chunks.front()) != "IHDR" || chunks.front().size() != chunkFrame + headerSize)
        file.fail("broken PNG picture: it does not begin with its header");
    requireSoundHeader(file, chunks.front());
    requirePaletteAndPixels(file, chunks);
    return chunks;
}

std::string deflatedData(const std::vector<std::string_view>& chunks) {
    std::string deflated;
    for (const std::string_view chunk : chunks)
        if (typeOf(chunk) == "IDAT") deflated += chunk.substr(8, chunk.size() - chunkFrame);
    return deflated;
}

libdeflate_result inflate(const std::string& deflated, std::string_view header) {
    const std::size_t most = inflatedSize(header);
    const std::unique_ptr<char[]> inflated(new (std::nothrow) char[most]);  // unlike a vector: not cleared
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(
        libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
    if (!inflated || !decompressor) throw std::bad_alloc();
    std::size_t size = 0;
    return libdeflate_zlib_decompress(decompressor.get(), deflated.data(), deflated.size(), inflated.get(),
                                      most, &size);
}

}  // namespace raytracer
