#include "scene_files.h"

#include <algorithm>

#include "raytracer/pictures/image.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// A path of usual length is shown whole. What is longer may be a picture as text:
// "data:image/png;base64,...".
std::string shown(const std::string& file) {
    constexpr std::size_t longest = 400;  // five lines of a terminal
    return inQuotes(file, longest);
}

// Throws for a file that the scene names and that is not there, with what the scene should name instead. A
// scene from a pipe has no folder of its own.
[[noreturn]] void failMissing(JsonView path, const std::string& folder, bool isPipe,
                              const std::string& file) {
    const bool isRelative = std::filesystem::path(path.string()).is_relative();
    if (isPipe && isRelative)
        path.fail("no file " + shown(file) +
                  ": a scene from a pipe has no folder: write a path from the root");
    const std::string name = isPipe ? "" : nearbyName(folder, path.string());
    path.fail("no file " + shown(file) + (isRelative ? " (relative to the scene file)" : "") +
              (name.empty() ? "" : "; write " + inQuotes(name)));
}

// How many folders a relative path leads upwards: 1 for "../a", 2 for "a/../../../b".
int stepsUp(const std::filesystem::path& relative) {
    int up = 0;
    for (const std::filesystem::path& part : relative.lexically_normal()) up += part == "..";
    return up;
}

MeshData readMesh(const std::string& file, int threads) {
    MeshData mesh = loadObj(file, threads);
    mesh.chooseUnit();
    return mesh;
}

}  // namespace

SceneFiles::SceneFiles(const std::string& scenePath, int threads)
    : folder_(std::filesystem::path(scenePath).parent_path()), threads_(threads) {
    std::error_code unknown;
    isPipe_ = std::filesystem::is_fifo(scenePath, unknown);
}

// Calls read(file). An Error about the file becomes one about the value of the scene that names it.
template <class Read>
auto SceneFiles::readNamed(JsonView path, const std::string& file, Read read) const {
    std::error_code unknown;
    if (std::filesystem::status(file, unknown).type() == std::filesystem::file_type::not_found)
        failMissing(path, folder_.string(), isPipe_, file);
    try {
        return withMemoryFor(file, "what is in it", [&] { return read(file); });
    } catch (const Error& error) {
        path.fail("in " + shown(file) + ": " + error.inFile());
    }
}

std::shared_ptr<const MeshData> SceneFiles::mesh(JsonView path) {
    const std::string file = resolve(path);
    std::shared_ptr<const MeshData>& mesh = meshes_[file];
    const auto read = [this](const std::string& name) { return readMesh(name, threads_); };
    if (!mesh) mesh = std::make_shared<MeshData>(readNamed(path, file, read));
    return mesh;
}

std::shared_ptr<const Texture> SceneFiles::texture(JsonView path) {
    const std::string file = resolve(path);
    std::shared_ptr<const Texture>& texture = textures_[file];
    if (!texture) texture = std::make_shared<Texture>(readNamed(path, file, readTexture));
    return texture;
}

void SceneFiles::requireTexture(JsonView path) {
    readNamed(path, resolve(path), [](const std::string& file) { FileBytes(file, FileKind::Regular); });
}

// The operating system would read a path only up to a NUL.
std::string SceneFiles::resolve(JsonView path) {
    const std::string_view written = path.string();
    if (written.empty() || written.find('\0') != written.npos) path.failExpected("the path of a file");
    return *names_.insert((folder_ / written).string()).first;
}

SceneCopy copyScene(const std::string& scene, const std::string& folder) {
    const std::vector<std::string> named = loadScene(scene).files;
    const std::filesystem::path from = std::filesystem::path(scene).parent_path();
    int up = 0;
    for (const std::string& file : named)
        up = std::max(up, stepsUp(std::filesystem::path(file).lexically_relative(from)));
    std::filesystem::path to = folder;
    for (int i = 0; i < up; ++i) to /= "scene";
    SceneCopy copied{(to / std::filesystem::path(scene).filename()).string(), {}};
    for (const std::string& file : named) {
        const std::filesystem::path copy =
            (to / std::filesystem::path(file).lexically_relative(from)).lexically_normal();
        std::error_code error;
        std::filesystem::create_directories(copy.parent_path(), error);
        std::filesystem::copy_file(file, copy, std::filesystem::copy_options::overwrite_existing, error);
        copied.files.insert(copy.string());
        if (error) throw Error({file}, "cannot be copied: " + error.message());
    }
    return copied;
}

}  // namespace raytracer
