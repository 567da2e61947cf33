// Keeps a picture in memory as it was rendered.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "raytracer/pictures/pixels.h"

namespace raytracer {

// Colours are linear, unclamped, in double; row-major from the top left of the crop.
class ColorSink final : public PixelSink {
  public:
    explicit ColorSink(const PixelRectangle& crop);
    void write(int x, int y, std::span<const glm::dvec3> colors) override;
    const std::vector<glm::dvec3>& colors() const& { return colors_; }
    std::vector<glm::dvec3> colors() && { return std::move(colors_); }

  private:
    PixelRectangle crop_;
    std::vector<glm::dvec3> colors_;
};

// Writes the rows of a picture into the sink, as a render does.
void copyTo(PixelSink& sink, const PixelRectangle& crop, std::span<const glm::dvec3> colors);

}  // namespace raytracer
