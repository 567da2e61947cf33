// Reads a scene file: from JSON text to a SceneDescription.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

struct LoadedScene {
    SceneDescription description;
    std::vector<std::string> warnings;  // one line each, in the form of Error's what()
    std::vector<std::string> files{};   // the scene's, and those that it names
};

// Reads the scene and the meshes and textures that its shapes use (paths are relative to the scene file). An
// unknown key is a warning, or an Error if `strict`. `edits` ("/pointer=value", JsonEdit) are made before,
// one after the other. Throws Error: "FILE: /json/pointer: what was expected, what was found" (syntax errors:
// "FILE:LINE:COLUMN: ...").
LoadedScene loadScene(const std::string& path, bool strict, std::span<const std::string> edits = {});

}  // namespace raytracer
