// An explanation for people, and the same for programs.
#pragma once

#include <string>

#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/explanation.h"

namespace raytracer {

// `scene` as it was rendered: its names are shown, and its colours are those of the sums.
std::string explanationText(const RayExplanation& explanation, const SceneDescription& scene);
std::string explanationJson(const RayExplanation& explanation, const SceneDescription& scene);

// What a shape's part is called: "body", "x = -1", "triangle 17" (from 0, in the file's order); empty where
// it has only one.
std::string faceName(ShapeType type, std::size_t primitive);

}  // namespace raytracer
