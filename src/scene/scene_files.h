// The files that a scene names, each read at most once.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>

#include "raytracer/json/json_view.h"
#include "raytracer/pictures/texture.h"
#include "raytracer/scene/mesh_file.h"

namespace raytracer {

// Paths are strings of the scene, relative to the scene's file. An Error is about the string that names the
// file.
class SceneFiles {
  public:
    SceneFiles(const std::string& scenePath, int threads);

    std::shared_ptr<const MeshData> mesh(JsonView path);
    std::shared_ptr<const Texture> texture(JsonView path);

    // Throws unless the texture's file can be opened; does not read it.
    void requireTexture(JsonView path);

    const std::set<std::string>& names() const { return names_; }  // of all files that the scene has named

  private:
    std::string resolve(JsonView path);
    template <class Read>
    auto readNamed(JsonView path, const std::string& file, Read read) const;

    std::filesystem::path folder_;
    bool isPipe_;
    int threads_;
    std::set<std::string> names_;
    std::unordered_map<std::string, std::shared_ptr<const MeshData>> meshes_;  // by resolved path
    std::unordered_map<std::string, std::shared_ptr<const Texture>> textures_;
};

}  // namespace raytracer
