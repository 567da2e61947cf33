// Decodes PNG and JPEG with stb_image. stb accepts broken files, so the files are checked first.
#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include <stb_image.h>

#include "jpeg_check.h"
#include "png_chunks.h"
#include "png_format.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/memory.h"
#include "whole_picture.h"

namespace raytracer {
namespace {

constexpr int rgb = 3;

// For a texel beyond the palette, stb returns whatever its memory holds. To find such texels, this puts a
// palette of 256 transparent colours before the file's own, and leaves out the file's transparency. A texel
// that is decoded as transparent is beyond the file's palette.
std::string withWholePalette(const std::vector<std::string_view>& chunks) {
    const auto chunk = [](std::string_view head, std::size_t size) {
        return std::string(head) +
               std::string(size + 4, '\0');  // zeros: the data, and a checksum, which stb ignores
    };
    std::string png(pngSignature);
    for (const std::string_view& own : chunks) {
        if (typeOf(own) != "tRNS") png += own;
        if (&own == &chunks.front()) png += chunk({"\0\0\3\0PLTE", 8}, 768) + chunk({"\0\0\1\0tRNS", 8}, 256);
    }
    return png;
}

// The channels that stb decodes of a PNG; paletted pictures are decoded as RGBA.
std::size_t decodedChannels(const std::vector<std::string_view>& chunks) {
    if (isPaletted(chunks.front())) return 4;
    const bool hasAlpha = std::ranges::find(chunks, "tRNS", typeOf) != chunks.end();
    return std::max<std::size_t>(rgb, channelsOf(chunks.front()) + hasAlpha);
}

// Of each pixel, stb holds the channels twice while it decodes a PNG; withWholePalette holds the file once
// more. Of a JPEG, stb holds up to 12 bytes: 4 channels, and 2 bytes of coefficients for each. The result has
// 3 channels.
void requireMemoryToDecode(const FileBytes& file, const std::vector<std::string_view>& chunks) {
    const auto size = sizeInHeader(file);
    if (!size) return;
    const bool isPng = !chunks.front().empty();
    const std::size_t channelBytes = hasDeepTexels(chunks.front()) ? 2 : 1,
                      held = isPng ? 2 * decodedChannels(chunks) : 12,
                      copied = isPng && isPaletted(chunks.front()) ? file.text().size() : 0;
    const double pixels = static_cast<double>(size->width) * size->height;
    requireMemory(file.path(), pixelsInWords(size->width, size->height),
                  static_cast<double>((rgb + held) * channelBytes) * pixels + static_cast<double>(copied));
}

constexpr const char* moreData = "broken PNG picture: it has more data than pixels";

// stb checks no checksum of the data. It inflates all of them, however small the picture is, and they may be
// larger than the memory. So the data are inflated here first, up to the size of the pixels. Longer data are
// accepted if the memory could hold the most that they can become; their checksum is not checked. Returns
// whether they are longer.
bool requireSoundData(const FileBytes& file, const std::vector<std::string_view>& chunks) {
    constexpr double mostRatio = 1032;  // deflate's best: 258 bytes in 2 bits
    const std::string deflated = deflatedData(chunks);
    const libdeflate_result result = inflate(deflated, chunks.front());
    if (result == LIBDEFLATE_BAD_DATA) file.fail("broken PNG picture: its compressed data are broken");
    const bool isLonger = result == LIBDEFLATE_INSUFFICIENT_SPACE;
    const double most = mostRatio * static_cast<double>(deflated.size());
    if (isLonger && !hasMemory(most)) file.fail(moreData);
    return isLonger;
}

// For a picture that is too large, stb gives the same reason as for a broken one or too little memory. So the
// size is checked here.
void requirePixelsFit(const FileBytes& file, const ImageSize& size, std::uint64_t most,
                      const std::string& kind) {
    constexpr int mostSide = 1 << 24;  // stb: STBI_MAX_DIMENSIONS
    const auto fail = [&](std::uint64_t limit, const std::string& of) {
        file.fail(pixelsInWords(size.width, size.height) + ": at most " + std::to_string(limit) + of);
    };
    if (std::max(size.width, size.height) > mostSide) fail(mostSide, " on a side");
    if (static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) > most)
        fail(most, kind);
}

// stb's limits: it counts the bytes of the pixels, and one more for each row, in int; and a file may have at
// most 2^30 values.
void requirePixelsFit(const FileBytes& file, const std::vector<std::string_view>& chunks) {
    constexpr std::uint64_t mostValues = 1 << 30, mostBytes = std::numeric_limits<int>::max() - (1 << 24);
    const std::string_view header = chunks.front();
    const std::uint64_t channels = decodedChannels(chunks);
    const std::uint64_t inFile = isPaletted(header) ? channels : channelsOf(header);
    const std::uint64_t most =
        std::min(mostValues / inFile, mostBytes / (channels * (hasDeepTexels(header) ? 2 : 1)));
    requirePixelsFit(file, sizeOf(header), most, " of " + std::to_string(channels) + " channels");
}

constexpr const char* noReason = "Image not of any known type, or corrupt";

// Makes noReason stb's current failure reason.
void forgetReason() {
    int ignored = 0;
    stbi_info_from_memory(nullptr, 0, &ignored, &ignored, &ignored);
}

[[noreturn]] void failForMemory(const FileBytes& file) {
    const auto size = sizeInHeader(file);
    const std::string what = size ? pixelsInWords(size->width, size->height) : "the picture";
    throw OutOfMemory({file.path()}, "not enough memory to decode " + what + ": " + memoryLeft().inWords);
}

// Throws Error with stb's reason. If stb gets no memory to inflate, it sets no reason: the older one,
// noReason, is still there.
[[noreturn]] void failToDecode(const FileBytes& file) {
    const std::string reason = stbi_failure_reason();
    const bool isPng = file.text().starts_with(pngSignature);
    if (reason == "Out of memory") failForMemory(file);
    if (isPng && reason == noReason) failForMemory(file);
    file.fail("cannot decode as PNG or JPEG: " + reason);
}

template <class Channel>
using Decoder = Channel* (*)(const stbi_uc*, int, int*, int*, int*, int);

// Decodes `text` to pixels of `wanted` channels. `text` is the file's, or the same with another palette.
template <class Channel>
LargeVector<Channel> decode(const FileBytes& file, std::string_view text, int wanted, Texture& image,
                            Decoder<Channel> decoder) {
    forgetReason();
    int channelsInFile = 0;
    const std::unique_ptr<Channel, decltype(&stbi_image_free)> pixels(
        decoder(reinterpret_cast<const stbi_uc*>(text.data()), static_cast<int>(text.size()), &image.width,
                &image.height, &channelsInFile, wanted),
        &stbi_image_free);
    if (!pixels) failToDecode(file);
    return {pixels.get(), pixels.get() + image.area() * static_cast<std::size_t>(wanted)};
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

void requireJpegFits(const FileBytes& file) {
    constexpr int mostChannels = 4;  // of which stb holds the bytes of all, counted in int
    requireSoundJpeg(file);
    if (const auto size = sizeInHeader(file))
        requirePixelsFit(file, *size, std::numeric_limits<int>::max() / mostChannels, "");
}

// Other common types of pictures, and the bytes by which they are known.
struct OtherType {
    std::size_t place;
    std::string_view bytes;
    const char* name;
};
using namespace std::string_view_literals;
constexpr OtherType otherTypes[] = {
    {0, "GIF8"sv, "GIF"},   {0, "BM"sv, "BMP"},     {8, "WEBP"sv, "WebP"}, {4, "ftyp"sv, "HEIC or AVIF"},
    {0, "II*\0"sv, "TIFF"}, {0, "MM\0*"sv, "TIFF"}, {0, "P3"sv, "PPM"},    {0, "P6"sv, "PPM"},
    {0, "PF"sv, "PFM"},     {0, "Pf"sv, "PFM"}};

// Throws Error for a file that is neither PNG nor JPEG.
[[noreturn]] void failAsOther(const FileBytes& file) {
    const std::string_view text = file.text();
    if (text.empty()) file.fail("it is empty");
    for (const auto& [place, bytes, name] : otherTypes)
        if (text.size() > place && text.substr(place).starts_with(bytes))
            file.fail(std::string("it is a ") + name + " picture: convert it to PNG");
    file.fail("it is no PNG, JPEG or PFM picture: convert it to PNG");
}

Texture decodeSound(const FileBytes& file) {
    const std::string_view text = file.text();
    if (text.size() > std::numeric_limits<int>::max() / 2) file.fail("cannot decode: the file is over 1 GiB");
    const bool isPng = text.starts_with(pngSignature);
    if (isJpeg(file)) requireJpegFits(file);
    else if (!isPng) failAsOther(file);
    std::vector<std::string_view> chunks{{}};
    if (isPng) {
        chunks = readChunks(file);
        requirePixelsFit(file, chunks);
    }
    requireMemoryToDecode(file, chunks);
    const bool isLonger = isPng && requireSoundData(file, chunks);
    Texture image;
    try {
        if (isPng && isPaletted(chunks.front())) decodePaletted(file, chunks, image);
        else if (hasDeepTexels(chunks.front()))
            image.deepTexels = decode(file, text, rgb, image, &stbi_load_16_from_memory);
        else image.texels = decode(file, text, rgb, image, &stbi_load_from_memory);
    } catch (const OutOfMemory&) {
        if (isLonger) file.fail(moreData);  // its own fault: stb inflates all of the data
        throw;
    }
    return image;
}

Texture decode(const FileBytes& file) {
    try {
        return decodeSound(file);
    } catch (const std::bad_alloc&) {
        failForMemory(file);
    }
}

}  // namespace

ImageSize sizeOfWholePng(const FileBytes& file) {
    const auto size = sizeInHeader(file);
    if (!size || !file.text().starts_with(pngSignature)) file.fail("not a PNG picture");
    readChunks(file);
    return *size;
}

Texture readTexture(const std::string& path) { return decode(FileBytes(path, FileKind::Regular)); }

ByteImage readImage(const FileBytes& file) {
    Texture texture = decode(file);
    for (const std::uint32_t texel : texture.deepTexels)
        texture.texels.push_back(static_cast<std::uint8_t>((255 * texel + 32767) / 65535));
    const ImageSize& size = texture;
    return {size, std::move(texture.texels)};
}

}  // namespace raytracer
