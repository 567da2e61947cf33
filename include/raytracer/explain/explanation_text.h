// Writes an explanation as text for people and as JSON for programs.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "raytracer/json/json_writer.h"
#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/explanation.h"

namespace raytracer {

// The scene that these take is the one that was rendered: its names and colours are in the texts.

// One sentence, without its full stop: what is hit, which lights reach it, and what its colour is made of.
std::string explanationSentence(const RayExplanation& explanation, const SceneDescription& scene);

// The ray tree, without the rays after more than `depth` reflections and refractions.
std::string explanationText(const RayExplanation& explanation, const SceneDescription& scene,
                            int depth = std::numeric_limits<int>::max());

// The sentence and the whole tree. `before` adds keys of its own to the object.
std::string explanationJson(const RayExplanation& explanation, const SceneDescription& scene,
                            const std::function<void(JsonWriter&)>& before = {});

// Terms of the first hit, such as "the diffuse term of light
// 1". Leaving out any one of them gives the pixel these bytes.
std::vector<std::string> missingTerms(const RayExplanation& explanation, const std::uint8_t* bytes);

// The name of a shape's part: "body", "x = -1", "triangle 17" (from 0, in the file's order); empty if the
// shape has only one.
std::string faceName(ShapeType type, std::size_t primitive);

}  // namespace raytracer
