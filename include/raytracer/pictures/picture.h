// Pictures in memory, and sinks that keep them.
#pragma once

#include "raytracer/pictures/image.h"
#include "raytracer/pictures/pixels.h"

namespace raytracer {

// A picture whose pixels are not set yet. Throws OutOfMemory (memory.h) if there is too little for it.
template <class Image>
Image unsetImage(const ImageSize& size);

// Bytes are clamped and quantised, for PNG. Floats are linear light, unclamped, for PFM.
template <class Channel>
class ImageSink final : public PixelSink {
  public:
    explicit ImageSink(const PixelRectangle& crop);
    void write(int x, int y, std::span<const glm::dvec3> colors) override;
    const ImageOf<Channel>& image() const { return image_; }

  private:
    PixelRectangle crop_;
    ImageOf<Channel> image_;
};
using ByteSink = ImageSink<std::uint8_t>;
using FloatSink = ImageSink<float>;

}  // namespace raytracer
