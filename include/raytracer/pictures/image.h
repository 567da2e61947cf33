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
struct ImageOf : ImageSize {
    LargeVector<Channel> pixels;  // width * height * 3
    bool operator==(const ImageOf&) const = default;

    // A pixel's red, green and blue.
    const Channel* at(int x, int y) const {
        return &pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                            static_cast<std::size_t>(x))];
    }
    Channel* at(int x, int y) { return const_cast<Channel*>(std::as_const(*this).at(x, y)); }
};
using ByteImage = ImageOf<std::uint8_t>;
using FloatImage = ImageOf<float>;  // linear light, unclamped

// A channel as a byte: clamped to [0, 1], then lround(255 c). A NaN becomes 0. A call of lround would cost
// more than this whole function. Adding 1/2 and truncating differs from lround only for the greatest double
// below 1/2, whose sum rounds up to 1; that double is not 255 c for any c.
inline std::uint8_t toByte(double channel) {
    const double raised = 255 * (channel > 0 ? (channel < 1 ? channel : 1) : 0) + 0.5;
    return static_cast<std::uint8_t>(static_cast<int>(raised));
}

// The largest difference of any channel. The arguments point at red, green and blue.
inline int largestDifference(const std::uint8_t* a, const std::uint8_t* b) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
    return largest;
}

// Whether the file's name ends as a picture's, of a format that need not be read here.
bool isPicture(const std::string& file);

// These read PNG and JPEG as RGB, readPfm a PFM: alpha is dropped, grey becomes three equal channels. They
// throw Error if the file is missing, unreadable or not such a picture.
Texture readTexture(const std::string& path);  // throws unless it is a regular file
ByteImage readImage(const FileBytes& file);    // rounds 16 bits to 8
FloatImage readPfm(const FileBytes& file);
inline bool isPfm(const FileBytes& file) {  // also true for grey ones, which readPfm refuses
    return file.text().starts_with("PF") || file.text().starts_with("Pf");
}

// The size in a PNG's or JPEG's header; empty if there is no such header.
std::optional<ImageSize> sizeInHeader(const FileBytes& file);

// Whether `path` is a complete picture, PNG or PFM, of the crop's size, and newer than all of the others.
bool isNewPicture(const std::string& path, const PixelRectangle& crop, std::span<const std::string> others);

std::string inWords(const ImageSize& size);        // "600 x 400"
std::string rgbInWords(const std::uint8_t* rgb);   // "(255, 0, 0)"
std::string pixelsInWords(int width, int height);  // "18000 × 18000 pixels"

// The bytes of a PNG file, made by stb. They do not depend on the number of threads (0: one for each
// processor). Throws Error, about the file `path`, if the picture is too large or memory runs out.
std::vector<char> encodePng(const ByteImage& image, const std::string& path = {}, int threads = 1);

// Throws Error. `file` may be a path, which is opened here, or an open file: std::move(file).
void writePng(OutputFile&& file, const ByteImage& image, int threads = 1);

}  // namespace raytracer
