// Warns about scenes that are valid, but probably not what their author meant.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// One line for each warning, "/json/pointer: ...". Of more than 20, the first 20 and a line with the number
// of the others. They follow from the geometry alone, in the file's own numbers. A case within the error
// bounds gives no warning. Warnings are about:
// - a camera whose look and up are not orthogonal unit vectors;
// - a shape outside of the view that no mirror or glass could show;
// - a mesh whose triangles have no area;
// - a light inside of an opaque shape (not a mesh) with the camera outside.
std::vector<std::string> sceneAdvice(const SceneDescription& scene);

// Finds slips in a scene's numbers that make a picture which its author hardly wants.
// The lines, in the same form, say what to change. Slips are:
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

// Whether a ray of the camera may hit a shape, through any point of the film. False only if it is proved that
// none does.
bool mayShowShapes(const SceneDescription& scene);

// Whether the shape is a mesh, and each triangle's corners lie on one line. No ray hits it.
bool hasNoArea(const ShapeDescription& shape);

// The first opaque shape (not a plane, not a mesh) that contains all starting points of the camera's rays,
// but no light except black ones.
std::optional<std::size_t> darkShapeAroundCamera(const SceneDescription& scene);

// Whether each light, except black ones, is inside an opaque shape with the camera outside.
bool areLightsHidden(const SceneDescription& scene);

}  // namespace raytracer
