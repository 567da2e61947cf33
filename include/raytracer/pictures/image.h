// Pictures in files: PNG (8-bit RGB) and PFM (32-bit float RGB, linear, unclamped).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "raytracer/pictures/texture.h"

namespace raytracer {

// 8-bit RGB, row-major from the top left.
struct ByteImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> pixels;  // width * height * 3
};

// Linear light, unclamped RGB, row-major from the top left.
struct FloatImage {
    int width = 0, height = 0;
    std::vector<float> pixels;  // width * height * 3
};

// A channel in [0, 1] as a byte: clamped, then lround(255 c). A NaN becomes 0. The result is that of lround,
// whose call costs more than the whole function: the subtraction is exact (Sterbenz).
inline std::uint8_t toByte(double channel) {
    const double scaled = 255 * (channel > 0 ? (channel < 1 ? channel : 1) : 0);
    const int whole = static_cast<int>(scaled);
    return static_cast<std::uint8_t>(whole + (scaled - whole >= 0.5));
}

// PNG or JPEG as RGB: without alpha, grey as three equal channels. Throws Error where the file is missing,
// unreadable or not a picture.
Texture readTexture(const std::string& path);
ByteImage readImage(const std::string& path);  // 16 bits are rounded to 8
FloatImage readPfm(const std::string& path);

// A PNG file's bytes. Throws Error, about the file `path`, where they are too many for the encoder.
std::vector<char> encodePng(const ByteImage& image, const std::string& path = {});

// Written beside `path` and renamed onto it, so that a picture is whole or absent. Throws Error.
void writePng(const std::string& path, const ByteImage& image);
void writePfm(const std::string& path, const FloatImage& image);

}  // namespace raytracer
