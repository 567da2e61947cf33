// Watches rayColor for one pixel and writes down what it sees.
#pragma once

#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// In the scene file's units, whatever frame the scene computes in.
RayExplanation explainPixel(const Scene& scene, const RenderOptions& options, int x, int y);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
