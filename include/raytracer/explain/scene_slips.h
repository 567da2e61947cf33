// Slips in a scene's numbers that make a picture which its author hardly means.
#pragma once

#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// One line each, "/json/pointer: ...", that says what to change; of more than 20, the first ones and a line
// with the number of the others:
// - a color that is written from 0 to 255, or to 65535, or is negative;
// - a texture that no material uses, a material that names one without use_diffuse_texture, and a textured
//   mesh without texture coordinates;
// - a film that mirrors the picture, and a focal length that is one of millimetres;
// - a closed mesh whose triangles are wound inwards.
std::vector<std::string> sceneSlips(const SceneDescription& scene);

// In the same form, what the course's own scenes do, and is said only to who asks for an explanation: a
// material's color_reflect without reflective, color_refract without refractive, and an index of refraction
// of 1; a light at the origin.
std::vector<std::string> sceneNotes(const SceneDescription& scene);

}  // namespace raytracer
