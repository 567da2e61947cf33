// Finds out why a picture is all black, from what its rays hit.
#pragma once

#include <algorithm>
#include <string>

#include "raytracer/pictures/image.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

template <class Image>
bool isAllBlack(const Image& image) {
    return std::ranges::all_of(image.pixels, [](auto channel) { return channel <= 0; });
}

// One line, "all black: REASON: REMEDY", for a whole picture of options.size that is black with Pass::Color.
// It divides the picture into 24 x 24 cells, and explains one pixel of each cell in which something is hit.
// `scene` is the scene as it was rendered.
std::string whyBlack(const SceneDescription& scene, const Renderer& renderer, const RenderOptions& options);

}  // namespace raytracer
