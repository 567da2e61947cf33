#include "scene_files.h"

#include "raytracer/json/json_writer.h"
#include "raytracer/pictures/image.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer {
namespace {

// Calls read() and adds to the error of its own kind which file it is about, and who asked for it.
template <class Error, class Read>
auto readOrBlame(JsonView path, const std::string& file, const char* expected, Read read) {
    try {
        return read();
    } catch (const Error& error) {
        path.fail(std::string("expected ") + expected + " in " + jsonString(file) + ": " + error.what());
    }
}

Texture readTexture(const std::string& file) {
    ByteImage image = readImage(file);
    return {image.width, image.height, std::move(image.pixels)};
}

}  // namespace

SceneFiles::SceneFiles(const std::string& scenePath)
    : folder_(std::filesystem::path(scenePath).parent_path()) {}

std::shared_ptr<const MeshData> SceneFiles::mesh(JsonView path) {
    const std::string file = resolve(path);
    std::shared_ptr<const MeshData>& mesh = meshes_[file];
    const auto read = [&] { return loadObj(file); };
    if (!mesh) mesh = std::make_shared<MeshData>(readOrBlame<MeshError>(path, file, "an OBJ mesh", read));
    return mesh;
}

std::shared_ptr<const Texture> SceneFiles::texture(JsonView path) {
    const std::string file = resolve(path);
    std::shared_ptr<const Texture>& texture = textures_[file];
    const auto read = [&] { return readTexture(file); };
    if (!texture) texture = std::make_shared<Texture>(readOrBlame<ImageError>(path, file, "a picture", read));
    return texture;
}

void SceneFiles::requireTexture(JsonView path) const {
    const std::string file = resolve(path);
    readOrBlame<FileError>(path, file, "a picture", [&] { FileBytes{file}; });
}

// A NUL would silently end the path where the operating system reads it.
std::string SceneFiles::resolve(JsonView path) const {
    const std::string_view written = path.string();
    if (written.empty() || written.find('\0') != written.npos) path.failExpected("the path of a file");
    return (folder_ / written).string();
}

}  // namespace raytracer
