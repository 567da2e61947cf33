// An explanation as text for people and as JSON for programs.
#pragma once

#include <string>

#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/explanation.h"

namespace raytracer {

// `scene` as it was rendered: the texts have its names and its colours.
std::string explanationText(const RayExplanation& explanation, const SceneDescription& scene);
std::string explanationJson(const RayExplanation& explanation, const SceneDescription& scene);

// The name of a shape's part: "body", "x = -1", "triangle 17" (from 0, in the file's order); empty if the
// shape has only one.
std::string faceName(ShapeType type, std::size_t primitive);

}  // namespace raytracer
