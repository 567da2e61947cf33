// How many rays a deep recursion casts, where they double with each bounce.
#pragma once

#include <optional>

#include "raytracer/tracer/renderer.h"

namespace raytracer {

// About how many reflected and refracted rays a sample of this picture takes, if they are more than
// mostRaysOfSample: by the growth of a few pixels' rays at the depths before that.
std::optional<double> excessiveRays(const SceneDescription& scene, const Renderer& renderer,
                                    const RenderOptions& options);

}  // namespace raytracer
