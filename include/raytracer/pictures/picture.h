// Pictures in memory, and sinks that keep them.
#pragma once

#include "raytracer/pictures/image.h"
#include "raytracer/pictures/pixels.h"

namespace raytracer {

// A picture whose pixels are not set yet. Throws OutOfMemory (memory.h) if there is too little for it.
template <class Image>
Image unsetImage(int width, int height);

// Clamps and quantises, for PNG.
class ByteSink final : public PixelSink {
  public:
    explicit ByteSink(const PixelRectangle& crop);
    void write(int x, int y, std::span<const glm::dvec3> colors) override;
    const ByteImage& image() const { return image_; }

  private:
    PixelRectangle crop_;
    ByteImage image_;
};

// Linear light, unclamped, for PFM.
class FloatSink final : public PixelSink {
  public:
    explicit FloatSink(const PixelRectangle& crop);
    void write(int x, int y, std::span<const glm::dvec3> colors) override;
    const FloatImage& image() const { return image_; }

  private:
    PixelRectangle crop_;
    FloatImage image_;
};

}  // namespace raytracer
