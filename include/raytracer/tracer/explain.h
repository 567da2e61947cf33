// Records the rays behind one pixel while rayColor traces them.
#pragma once

#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// The explanation is in the scene file's units.
RayExplanation explainPixel(const Scene& scene, const RenderOptions& options, int x, int y);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
