// What is small in a picture: shapes and triangles that may lie between the pixels' centres.
#pragma once

#include <vector>

#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Points, in this place of the picture, where shapes and triangles lie that are thinner than two pixels: at
// most one in each pixel, of that nearest to the eye; row by row. Throws OutOfMemory (memory.h).
std::vector<glm::dvec2> smallParts(const Scene& scene, const ImageSize& size, const PixelRectangle& place);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
