// Why a picture came out all black: from what its rays met, not from guesses about the scene.
#pragma once

#include <string>

#include "raytracer/pictures/image.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

bool isAllBlack(const ByteImage& image);
bool isAllBlack(const FloatImage& image);

// In one line, "the picture is all black: ...", for the whole picture of options.size in which Pass::Color is
// black. Looks at every pixel's first hit, and at the whole tree of rays behind some of those that hit
// something: some hundred, spread evenly, whatever the picture's size. `scene` as it was rendered.
std::string whyBlack(const SceneDescription& scene, const Renderer& renderer, const RenderOptions& options);

}  // namespace raytracer
