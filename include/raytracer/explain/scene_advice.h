// Warns about scenes that are valid, but probably not what their author meant.
//
// The warnings follow from the geometry alone, in the file's own numbers. A case within the error bounds
// gives no warning.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// One line for each warning, "/json/pointer: ...". Of more than 20, the first 20 and a line with the number
// of the others. Warnings are about:
// - a camera whose look and up are not orthogonal unit vectors;
// - a shape outside of the view that no mirror or glass could show;
// - a mesh whose triangles have no area;
// - a light inside of an opaque shape (not a mesh) with the camera outside.
std::vector<std::string> sceneAdvice(const SceneDescription& scene);

// Whether the shape is a mesh, and each triangle's corners lie on one line. No ray hits it.
bool hasNoArea(const ShapeDescription& shape);

// The first opaque shape (not a plane, not a mesh) that contains all starting points of the camera's rays,
// but no light except black ones.
std::optional<std::size_t> darkShapeAroundCamera(const SceneDescription& scene);

// Whether each light, except black ones, is inside an opaque shape with the camera outside.
bool areLightsHidden(const SceneDescription& scene);

}  // namespace raytracer
