// What is small in a picture: shapes and triangles that may lie between the pixels' centres.
#pragma once

#include <vector>

#include "raytracer/tracer/contrast.h"
#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Points of the picture, row by row of its pixels, where shapes and triangles lie that are thinner than two
// pixels. At most one in each pixel: of that nearest to the eye. No colours yet.
std::vector<ExtraSample> smallParts(const Scene& scene, const ImageSize& size);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
