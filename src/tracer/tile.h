// A tile of a picture: its pixels' colours, means of the colours seen at points of them.
#pragma once

#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Each pixel's colour is its own, wherever the tile lies. `first` may be null.
void renderTile(const Scene& scene, const PixelRectangle& tile, const RenderContext& context,
                const FirstSamples* first, PixelSink& sink);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
