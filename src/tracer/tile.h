// A tile of a picture: the colours of its pixels, each a mean of the colours at points of the pixel.
#pragma once

#include <functional>

#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Makes a function that renders one tile after another, on one thread. A pixel's colour does not depend on
// the tile that it is in. `first` may be null; then the extra samples are those at the points `small`.
std::function<void(const PixelRectangle&)> tileRenderer(const Scene& scene, const RenderContext& context,
                                                        const FirstSamples* first,
                                                        std::span<const glm::dvec2> small, PixelSink& sink);

// Takes the first samples of a tile.
void renderFirst(const Scene& scene, const PixelRectangle& tile, const RenderContext& context,
                 FirstSamples& first);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
