// Warnings about a valid scene that its author may not have meant.
//
// From the geometry alone, in the file's own numbers. A case within the error bounds gives no warning.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// One line each, "/json/pointer: ..."; of more than 20, the first ones and a line with the number of the
// others:
// - a camera whose look and up are not orthogonal unit vectors;
// - a shape outside of the view that no mirror or glass could show;
// - a light inside of an opaque shape (not a mesh) with the camera outside.
std::vector<std::string> sceneAdvice(const SceneDescription& scene);

// The first opaque shape (no plane, no mesh) around all that the camera's rays begin at, and around no light
// but black ones.
std::optional<std::size_t> darkShapeAroundCamera(const SceneDescription& scene);

// Whether each light, but black ones, is inside of an opaque shape with the camera outside.
bool areLightsHidden(const SceneDescription& scene);

}  // namespace raytracer
