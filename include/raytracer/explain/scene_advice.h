// What the author of a scene that can be rendered may not have meant.
//
// Geometry alone, in the file's own numbers; a doubtful case gives no warning. What only a picture tells is
// for black_picture.h.
#pragma once

#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// One line each, "/json/pointer: ..."; of very many the first ones, and a line that counts the rest:
// - a camera whose look and up are not orthogonal unit vectors;
// - a shape that no ray of the view meets, where no mirror or glass could show it all the same;
// - a light inside of an opaque shape (not a mesh) that the camera is outside of.
std::vector<std::string> sceneAdvice(const SceneDescription& scene);

}  // namespace raytracer
