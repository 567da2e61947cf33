#include "raytracer/pictures/color_sink.h"

#include <algorithm>

#include "raytracer/pictures/image.h"
#include "raytracer/util/memory.h"

namespace raytracer {

ColorSink::ColorSink(const PixelRectangle& crop) : crop_(crop) {
    requireMemory({}, "the colours of " + pixelsInWords(crop.width(), crop.height()),
                  sizeof(glm::dvec3) * crop.area());
    colors_.resize(crop.size().area());
}

void ColorSink::write(int x, int y, std::span<const glm::dvec3> colors) {
    std::ranges::copy(colors, &colors_[crop_.indexOf(x, y)]);
}

void copyTo(PixelSink& sink, const PixelRectangle& crop, std::span<const glm::dvec3> colors) {
    const auto width = static_cast<std::size_t>(crop.width());
    for (int y = crop.y0; y < crop.y1; ++y) {
        sink.write(crop.x0, y, colors.first(width));
        colors = colors.subspan(width);
    }
}

}  // namespace raytracer
