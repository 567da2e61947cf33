#include "raytracer/pictures/picture.h"

#include <algorithm>
#include <limits>

#include "raytracer/util/memory.h"

namespace raytracer {

template <class Image>
Image unsetImage(const ImageSize& size) {
    Image image{size, {}};
    const std::size_t channels = 3 * size.area();
    requireMemory({}, pixelsInWords(size.width, size.height),
                  static_cast<double>(channels * sizeof(image.pixels[0])));
    image.pixels.resize(channels);
    return image;
}
template ByteImage unsetImage(const ImageSize& size);
template FloatImage unsetImage(const ImageSize& size);

namespace {

void convert(double value, std::uint8_t& channel) { channel = toByte(value); }

// A colour that is too bright for a float is clamped to the largest one.
void convert(double value, float& channel) {
    constexpr double brightest = std::numeric_limits<float>::max();
    channel = static_cast<float>(std::clamp(value, -brightest, brightest));
}

}  // namespace

template <class Channel>
ImageSink<Channel>::ImageSink(const PixelRectangle& crop)
    : crop_(crop), image_(unsetImage<ImageOf<Channel>>(crop.size())) {
    std::ranges::fill(image_.pixels, 0);
}

template <class Channel>
void ImageSink<Channel>::write(int x, int y, std::span<const glm::dvec3> colors) {
    Channel* out = image_.at(x - crop_.x0, y - crop_.y0);
    const double* const values = &colors.data()->x;  // as one flat array, so that the loop is vectorised
    for (std::size_t i = 0; i < 3 * colors.size(); ++i) convert(values[i], out[i]);
}

template class ImageSink<std::uint8_t>;
template class ImageSink<float>;

}  // namespace raytracer
