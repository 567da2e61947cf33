// Finds slips in a scene's numbers that make a picture which its author hardly wants.
#pragma once

#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// One line for each slip, "/json/pointer: ...", that says what to change. Of more than 20, the first 20 and a
// line with the number of the others. Slips are:
// - a color that is written from 0 to 255, or to 65535, or is negative;
// - a texture that no material uses, a material that names one without use_diffuse_texture, and a textured
//   mesh without texture coordinates;
// - a film that mirrors the picture, and a focal length that is one of millimetres;
// - a closed mesh whose triangles are wound inwards.
std::vector<std::string> sceneSlips(const SceneDescription& scene);

// Notes in the same form. The course's own scenes have these cases too, so only `explain` mentions them: a
// material's color_reflect without reflective, color_refract without refractive, an index of refraction of 1,
// and a light at the origin.
std::vector<std::string> sceneNotes(const SceneDescription& scene);

}  // namespace raytracer
