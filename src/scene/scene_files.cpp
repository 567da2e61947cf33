#include "scene_files.h"

#include "raytracer/pictures/image.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/nearby_file.h"

namespace raytracer {
namespace {

bool isRelative(JsonView path) { return std::filesystem::path(path.string()).is_relative(); }

// Calls read(file). An Error about the file becomes one about the value of the scene that names it.
template <class Read>
auto readNamed(JsonView path, const std::string& file, const char* expected, Read read) {
    std::error_code unknown;
    const auto kind = std::filesystem::status(file, unknown).type();
    if (kind == std::filesystem::file_type::not_found)
        path.fail("no file " + jsonString(file) + (isRelative(path) ? " (relative to the scene file)" : "") +
                  hintAt(file));
    try {
        return read(file);
    } catch (const Error& error) {
        path.fail(std::string("expected ") + expected + " in " + jsonString(file) + ": " + error.inFile());
    }
}

MeshData readMesh(const std::string& file) {
    MeshData mesh = loadObj(file);
    mesh.chooseUnit();
    return mesh;
}

constexpr const char* aMesh = "an OBJ mesh";
constexpr const char* aPicture = "a picture";

}  // namespace

SceneFiles::SceneFiles(const std::string& scenePath)
    : folder_(std::filesystem::path(scenePath).parent_path()) {}

std::shared_ptr<const MeshData> SceneFiles::mesh(JsonView path) {
    const std::string file = resolve(path);
    std::shared_ptr<const MeshData>& mesh = meshes_[file];
    if (!mesh) mesh = std::make_shared<MeshData>(readNamed(path, file, aMesh, readMesh));
    return mesh;
}

std::shared_ptr<const Texture> SceneFiles::texture(JsonView path) {
    const std::string file = resolve(path);
    std::shared_ptr<const Texture>& texture = textures_[file];
    if (!texture) texture = std::make_shared<Texture>(readNamed(path, file, aPicture, readTexture));
    return texture;
}

void SceneFiles::requireTexture(JsonView path) {
    readNamed(path, resolve(path), aPicture,
              [](const std::string& file) { FileBytes(file, FileKind::Regular); });
}

// The operating system would read a path only up to a NUL.
std::string SceneFiles::resolve(JsonView path) {
    const std::string_view written = path.string();
    if (written.empty() || written.find('\0') != written.npos) path.failExpected("the path of a file");
    return *names_.insert((folder_ / written).string()).first;
}

}  // namespace raytracer
