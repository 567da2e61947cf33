// Reads a scene file: from JSON text to a SceneDescription.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer {

struct LoadedScene {
    SceneDescription description;
    std::vector<std::string> warnings;  // one line each, in the form of Error's what()
    std::vector<std::string> files{};   // the scene's, and those that it names
};

// Reads the scene and the meshes and textures that its shapes use (paths are relative to the scene file). An
// unknown key is a warning, or an Error in one of the `edits` ("/pointer=value", JsonEdit), which are made
// before, one after the other. Throws Error: "FILE:LINE:COLUMN: /json/pointer: what was expected, what was
// found" (syntax errors: without the pointer). `named` gets LoadedScene::files, as far as they are known also
// where this throws.
LoadedScene loadScene(const std::string& path, std::span<const std::string> edits = {},
                      std::vector<std::string>* named = nullptr, FileKind kind = FileKind::Any);

// What is said about values of a scene, "/json/pointer: ...", as Errors about the file, with lines and
// columns as far as it can be read again and the value is not one of the edits'. Without a pointer, it is
// about the file.
std::vector<Error> remarksOn(const std::string& path, const std::vector<std::string>& remarks,
                             std::span<const std::string> edits);

}  // namespace raytracer
