// The image of a texture: RGB texels of 8 or 16 bits a channel, row 0 at the top (v = 1).
#pragma once

#include <cstdint>

#include "raytracer/pictures/pixels.h"
#include "raytracer/util/large_vector.h"

namespace raytracer {

struct Texture : ImageSize {
    LargeVector<std::uint8_t> texels;         // width * height * 3, row-major from the top left; or empty:
    LargeVector<std::uint16_t> deepTexels{};  // then these are, with 16 bits a channel
};

}  // namespace raytracer
