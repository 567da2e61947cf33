// A tile of a picture: its pixels' colours, means of the colours seen at points of them.
#pragma once

#include <functional>

#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// What renders one tile after another, on one thread. Each pixel's colour is its own, wherever the tile lies.
// `first` may be null.
std::function<void(const PixelRectangle&)> tileRenderer(const Scene& scene, const RenderContext& context,
                                                        const FirstSamples* first, PixelSink& sink);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
