// Estimates how many rays a deep recursion casts in a scene where rays double with each bounce.
#pragma once

#include <optional>

#include "raytracer/tracer/renderer.h"

namespace raytracer {

// About how many reflected and refracted rays a sample of this picture casts, if more than mostRaysOfSample.
// It is extrapolated: a few pilot samples tell how the number of rays grows at smaller depths.
std::optional<double> excessiveRays(const SceneDescription& scene, const Renderer& renderer,
                                    const RenderOptions& options);

}  // namespace raytracer
