// Places in a picture, and the interface that takes its colours.
#pragma once

#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

namespace raytracer {

struct ImageSize {
    int width = 0, height = 0;
    std::size_t area() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    bool operator==(const ImageSize&) const = default;
};

// A rectangle of pixels: x0 <= x < x1, y0 <= y < y1, (0, 0) at the top left.
struct PixelRectangle {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    ImageSize size() const { return {width(), height()}; }
    double area() const { return static_cast<double>(width()) * height(); }  // pixels
    std::size_t indexOf(int x, int y) const {                                // of a pixel, row by row
        return static_cast<std::size_t>(y - y0) * static_cast<std::size_t>(width()) +
               static_cast<std::size_t>(x - x0);
    }
};

// A pixel of the whole picture.
struct PixelPlace {
    int x = 0, y = 0;
};

// Receives a picture. write() is called from several threads at once, for disjoint runs of pixels.
class PixelSink {
  public:
    virtual ~PixelSink() = default;

    // The colours (linear RGB, unclamped) of the pixels (x, y), (x + 1, y), ... of the whole picture.
    virtual void write(int x, int y, std::span<const glm::dvec3> colors) = 0;
};

}  // namespace raytracer
