// Reads a scene file: from JSON text to a SceneDescription.
#pragma once

#include <set>
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

// Reads the scene, and the meshes and textures that its shapes use. Their paths are relative to the scene
// file. The `edits` ("/pointer=value", JsonEdit) are made first, one after the other. An unknown key is a
// warning; in one of the edits it is an Error. Throws Error: "FILE:LINE:COLUMN: /json/pointer: what was
// expected, what was found" (syntax errors: without the pointer). `named` gets LoadedScene::files; where this
// throws, those that are known by then. `threads`: as threadCount's.
LoadedScene loadScene(const std::string& path, std::span<const std::string> edits = {},
                      std::vector<std::string>* named = nullptr, FileKind kind = FileKind::Any,
                      int threads = 0);

// Copies the scene, and the files that it names, into a folder, so that its relative paths lead to the
// copies. A file that it names by an absolute path is found where it is. Throws Error.
struct SceneCopy {
    std::string path;
    std::set<std::string> files;  // all copies
};
SceneCopy copyScene(const std::string& scene, const std::string& folder);

// Turns remarks about values of a scene, "/json/pointer: ...", into Errors about the file. An Error has a
// line and a column where the file can be read again and the value is not one of the edits'. A remark without
// a pointer is about the file.
std::vector<Error> remarksOn(const std::string& path, const std::vector<std::string>& remarks,
                             std::span<const std::string> edits);

}  // namespace raytracer
