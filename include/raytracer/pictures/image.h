// Pictures in files: PNG (8-bit RGB) and PFM (32-bit float RGB, linear, unclamped).
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "raytracer/pictures/pixels.h"
#include "raytracer/pictures/texture.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/large_vector.h"
#include "raytracer/util/output_file.h"

namespace raytracer {

// RGB, row-major from the top left.
template <class Channel>
struct ImageOf {
    int width = 0, height = 0;
    LargeVector<Channel> pixels;  // width * height * 3

    // Where a pixel is: its red, green and blue.
    const Channel* at(int x, int y) const {
        return &pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x))];
    }
    Channel* at(int x, int y) { return const_cast<Channel*>(std::as_const(*this).at(x, y)); }
};
using ByteImage = ImageOf<std::uint8_t>;
using FloatImage = ImageOf<float>;  // linear light, unclamped

// A channel in [0, 1] as a byte: clamped, then lround(255 c). A NaN becomes 0. The result is that of lround,
// whose call costs more than the whole function: the one number whose sum with 1/2 is rounded to the next
// integer, the greatest below 1/2, is not 255 c for any c.
inline std::uint8_t toByte(double channel) {
    const double raised = 255 * (channel > 0 ? (channel < 1 ? channel : 1) : 0) + 0.5;
    return static_cast<std::uint8_t>(static_cast<int>(raised));
}

// By how much the channel differs most: the arguments point at red, green and blue.
inline int largestDifference(const std::uint8_t* a, const std::uint8_t* b) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
    return largest;
}

// PNG or JPEG as RGB: without alpha, grey as three equal channels. Throws Error where the file is missing,
// unreadable or not a picture.
Texture readTexture(const std::string& path);  // of a regular file
ByteImage readImage(const FileBytes& file);    // 16 bits are rounded to 8
FloatImage readPfm(const FileBytes& file);
inline bool isPfm(const FileBytes& file) {  // grey ones, too, which readPfm refuses
    return file.text().starts_with("PF") || file.text().starts_with("Pf");
}

// What a PNG's or JPEG's header says; nothing where it has none.
std::optional<ImageSize> sizeInHeader(const FileBytes& file);

// Throws Error where the memory is too little to decode the picture to channels of so many bytes.
void requireMemoryToDecode(const FileBytes& file, std::size_t channelBytes = 1);

// Whether this is the file of a whole picture of that size, PNG or PFM, written after all of the others were.
bool isNewPicture(const std::string& path, const PixelRectangle& crop, std::span<const std::string> others);

std::string pixelsInWords(int width, int height);  // "18000 × 18000 pixels"

// A PNG file's bytes, by stb. Throws Error, about the file `path`, where the picture does not fit. Its bytes
// do not depend on the number of threads (0: one for each processor).
std::vector<char> encodePng(const ByteImage& image, const std::string& path = {}, int threads = 1);

// Throws Error. A path is made a file here; a file that is open already is given as std::move(file).
void writePng(OutputFile&& file, const ByteImage& image, int threads = 1);

}  // namespace raytracer
