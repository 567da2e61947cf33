#include "raytracer/pictures/picture.h"

#include <algorithm>
#include <limits>

#include "raytracer/util/memory.h"

namespace raytracer {

template <class Image>
Image unsetImage(int width, int height) {
    Image image{width, height, {}};
    const std::size_t channels = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    requireMemory({}, pixelsInWords(width, height), static_cast<double>(channels * sizeof(image.pixels[0])));
    image.pixels.resize(channels);
    return image;
}
template ByteImage unsetImage(int width, int height);
template FloatImage unsetImage(int width, int height);

namespace {

template <class Image>
Image blank(const PixelRectangle& crop) {
    auto image = unsetImage<Image>(crop.width(), crop.height());
    std::ranges::fill(image.pixels, 0);
    return image;
}

}  // namespace

ByteSink::ByteSink(const PixelRectangle& crop) : crop_(crop), image_(blank<ByteImage>(crop)) {}

void ByteSink::write(int x, int y, std::span<const glm::dvec3> colors) {
    std::uint8_t* out = image_.at(x - crop_.x0, y - crop_.y0);
    const double* const values = &colors.data()->x;  // as one flat array, so that the loop is vectorised
    for (std::size_t i = 0; i < 3 * colors.size(); ++i) out[i] = toByte(values[i]);
}

FloatSink::FloatSink(const PixelRectangle& crop) : crop_(crop), image_(blank<FloatImage>(crop)) {}

// Colours that are too bright for a float are clamped to the largest one.
void FloatSink::write(int x, int y, std::span<const glm::dvec3> colors) {
    constexpr double brightest = std::numeric_limits<float>::max();
    float* out = image_.at(x - crop_.x0, y - crop_.y0);
    for (const glm::dvec3& color : colors)
        for (int channel = 0; channel < 3; ++channel)
            *out++ = static_cast<float>(std::clamp(color[channel], -brightest, brightest));
}

}  // namespace raytracer
