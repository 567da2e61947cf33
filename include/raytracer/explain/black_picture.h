// Why a picture is all black, from what its rays hit.
#pragma once

#include <string>

#include "raytracer/pictures/image.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

bool isAllBlack(const ByteImage& image);
bool isAllBlack(const FloatImage& image);

// One line, "all black: REASON: REMEDY", for a whole picture of options.size in which Pass::Color is
// black. Renders the first hit of every pixel, and explains some hundred of the pixels that hit something,
// evenly spread. `scene` as it was rendered.
std::string whyBlack(const SceneDescription& scene, const Renderer& renderer, const RenderOptions& options);

}  // namespace raytracer
