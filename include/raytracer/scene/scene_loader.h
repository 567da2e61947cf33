// Scene files: JSON text to SceneDescription, checked strictly.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"

namespace raytracer {

// What is wrong with a scene file, in one line ready for the terminal:
// "FILE: /json/pointer: what was expected, what was found" (syntax errors: "FILE:LINE:COLUMN: ...").
struct SceneError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct LoadedScene {
    SceneDescription description;
    std::vector<std::string> warnings;  // one line each, in the form of SceneError's
};

// Reads the scene and the meshes and textures that its shapes use (paths are relative to the scene file). A
// key that is not known is a warning, or an error when `strict`. Throws SceneError.
LoadedScene loadScene(const std::string& path, bool strict);

}  // namespace raytracer
