#include "raytracer/pictures/color_sink.h"

#include <algorithm>

namespace raytracer {

ColorSink::ColorSink(const PixelRectangle& crop)
    : crop_(crop),
      colors_(static_cast<std::size_t>(crop.width()) * static_cast<std::size_t>(crop.height())) {}

void ColorSink::write(int x, int y, std::span<const glm::dvec3> colors) {
    const auto place = static_cast<std::ptrdiff_t>(y - crop_.y0) * crop_.width() + (x - crop_.x0);
    std::copy(colors.begin(), colors.end(), colors_.begin() + place);
}

void copyTo(PixelSink& sink, const PixelRectangle& crop, std::span<const glm::dvec3> colors) {
    const auto width = static_cast<std::size_t>(crop.width());
    for (int y = crop.y0; y < crop.y1; ++y) {
        sink.write(crop.x0, y, colors.first(width));
        colors = colors.subspan(width);
    }
}

}  // namespace raytracer
