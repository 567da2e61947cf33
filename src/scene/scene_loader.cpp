#include "raytracer/scene/scene_loader.h"

#include <array>

#include "foreign_keys.h"
#include "known_keys.h"
#include "name_table.h"
#include "raytracer/json/json_document.h"
#include "raytracer/json/json_edit.h"
#include "raytracer/json/json_pointer.h"
#include "raytracer/json/json_view.h"
#include "raytracer/util/memory.h"
#include "scene_files.h"
#include "scene_parts.h"

namespace raytracer {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view defaultMaterialName = "default";  // as in MaterialDescription

constexpr std::array sceneKeys = {"$schema"sv, "camera"sv,     "materials"sv, "lights"sv,
                                  "shapes"sv,  "transforms"sv, "textures"sv};

// Reads the whole scene and resolves its names. Strings and views belong to the document.
class SceneReader {
  public:
    SceneReader(const std::string& path, int threads) : path_(path), files_(path, threads) {}

    void read(JsonView scene);

    SceneDescription& description() { return description_; }
    std::vector<std::string> warnings() const { return keys_.warnings(path_); }
    std::vector<std::string> files() const {
        std::vector<std::string> all{path_};
        all.insert(all.end(), files_.names().begin(), files_.names().end());
        return all;
    }

  private:
    // Makes room for what is read from a list, and for its names.
    template <class List>
    void reserve(List& list, JsonView view, const char* what, NameTable* names = nullptr) const;
    void readTextures(JsonView textures);
    void readMaterials(JsonView materials);
    void readTransforms(JsonView transforms);
    void readShapes(JsonView shapes);
    ShapeDescription readShape(JsonView shape);
    std::size_t find(NameTable& table, JsonView name, const char* key);
    void loadTextureOf(const MaterialDescription& material);

    const std::string& path_;
    SceneFiles files_;
    KnownKeys keys_;
    NameTable textures_{"texture"}, materials_{"material"}, transforms_{"transform"};
    std::vector<JsonView> texturePaths_;
    SceneDescription description_;
};

void SceneReader::read(JsonView view) {
    const JsonObject scene = keys_.check(view, sceneKeys);
    if (const auto schema = scene.find("$schema")) schema->string();
    description_.camera = readCamera(scene["camera"], keys_);
    if (const auto textures = scene.find("textures")) readTextures(*textures);
    readMaterials(scene["materials"]);
    reserve(description_.lights, scene["lights"], "lights");
    for (const JsonView light : scene["lights"].elements())
        description_.lights.push_back(readLight(light, keys_));
    readTransforms(scene["transforms"]);
    readShapes(scene["shapes"]);
}

// What copies of the strings in these objects take beside the std::string itself.
std::size_t bytesOfStrings(JsonView list) {
    constexpr std::size_t within = 15, around = 17;  // of libstdc++; the end, and what glibc adds
    std::size_t bytes = 0;
    for (const JsonView element : list.elements()) {
        if (element.kind() != JsonDocument::Kind::Object) continue;
        for (const JsonView member : element.members()) {
            if (member.kind() != JsonDocument::Kind::String) continue;
            const std::size_t size = member.string().size();
            bytes += size > within ? size + around : 0;
        }
    }
    return bytes;
}

template <class List>
void SceneReader::reserve(List& list, JsonView view, const char* what, NameTable* names) const {
    const std::size_t count = view.size(), each = sizeof(list[0]) + (names ? NameTable::bytesOfName : 0),
                      strings = names ? bytesOfStrings(view) : 0;
    const std::string most = strings > each * count ? "the names of" : std::to_string(count);
    requireMemory(path_, most + " " + what, static_cast<double>(each * count + strings));
    list.reserve(count);
    if (names) names->reserve(count);
}

void SceneReader::readTextures(JsonView textures) {
    for (const JsonView path : textures.members()) {
        files_.requireTexture(path);
        textures_.add(path.key(), path);
        texturePaths_.push_back(path);
        description_.textures.push_back({std::string(path.key()), nullptr});
    }
}

void SceneReader::readMaterials(JsonView materials) {
    reserve(description_.materials, materials, "materials", &materials_);
    for (const JsonView json : materials.elements()) {
        MaterialDescription& material = description_.materials.emplace_back(readMaterial(json, keys_));
        const auto name = json.find("name");
        materials_.add(name ? name->string() : defaultMaterialName, name.value_or(json));
        // readMaterial has required the key.
        if (material.use_diffuse_texture)
            material.texture = find(textures_, *json.find("diffuse_texture"), "textures");
    }
}

void SceneReader::readTransforms(JsonView transforms) {
    reserve(description_.transforms, transforms, "transforms", &transforms_);
    for (const JsonView json : transforms.elements()) {
        description_.transforms.push_back(readTransform(json, keys_));
        const JsonView name = *json.find("name");
        transforms_.add(name.string(), name);
    }
}

void SceneReader::readShapes(JsonView shapes) {
    reserve(description_.shapes, shapes, "shapes");
    for (const JsonView json : shapes.elements()) {
        const ShapeDescription& shape = description_.shapes.emplace_back(readShape(json));
        loadTextureOf(description_.materials[shape.material]);
    }
}

ShapeDescription SceneReader::readShape(JsonView view) {
    static constexpr std::array known = {"type"sv, "transform"sv, "material"sv, "path"sv};
    const auto type = view.find("type");
    const bool isMesh = type && type->string() == "mesh";  // no other shape has a path
    const JsonObject json = keys_.check(view, std::span(known).first(isMesh ? 4 : 3));
    ShapeDescription shape;
    shape.type = static_cast<ShapeType>(json["type"].choice(shapeTypeNames));
    shape.transform = transforms_.find(json["transform"]);
    shape.material = find(materials_, json["material"], "name");
    if (isMesh) shape.mesh = files_.mesh(json["path"]);
    return shape;
}

// Finds a name. `key`: the key that gives such names. If it was misspelt, the Error is about that.
std::size_t SceneReader::find(NameTable& table, JsonView name, const char* key) {
    try {
        return table.find(name);
    } catch (const Error&) {
        keys_.requireNamed(key);
        throw;
    }
}

// A texture is read when the first shape uses it (src/README.md, 7: the model has what a scene needs).
void SceneReader::loadTextureOf(const MaterialDescription& material) {
    if (!material.use_diffuse_texture) return;
    std::shared_ptr<const Texture>& texture = description_.textures[material.texture].texture;
    if (!texture) texture = files_.texture(texturePaths_[material.texture]);
}

// A remark's pointer and, behind ": ", its message.
struct Remark {
    explicit Remark(const std::string& text) : message(text) {
        const std::size_t end = text.starts_with('/') ? text.find(": ") : text.npos;
        if (end == text.npos) return;
        pointer = text.substr(0, end);
        message = text.substr(end + 2);
    }
    std::string pointer, message;
};

Error placed(const JsonDocument& document, const std::string& path, const std::string& text) {
    const Remark remark(text);
    const PointerEnd end = follow(document, remark.pointer);
    const bool isFound = !remark.pointer.empty() && end.left.empty();
    return isFound ? document.error(end.node, remark.message) : Error({path}, text);
}

// Throws for an edit such as "samples=4": it is no pointer, but means an option of the command line.
void refuseOptions(const std::string& path, std::span<const std::string> edits) {
    for (const std::string& edit : edits) {
        const std::string name = edit.substr(0, edit.find('='));
        const ForeignKey* const other = foreignKey(name, sceneKeys);
        if (other && !other->why.empty())
            throw Error({path}, "--set " + name + ": " + std::string(other->why));
    }
}

}  // namespace

// Reads a regular file only: a pipe cannot be read twice.
std::vector<Error> remarksOn(const std::string& path, const std::vector<std::string>& remarks,
                             std::span<const std::string> edits) {
    std::vector<Error> errors;
    if (remarks.empty()) return errors;
    try {
        const FileBytes file(path, FileKind::Regular);
        const EditedJson json = edited(path, file.text(), edits);
        const JsonDocument document(path, json.text, json.edits);
        for (const std::string& text : remarks) errors.push_back(placed(document, path, text));
    } catch (const Error&) {
        errors.clear();
        for (const std::string& text : remarks) errors.emplace_back(Place{path}, text);
    }
    return errors;
}

LoadedScene loadScene(const std::string& path, std::span<const std::string> edits,
                      std::vector<std::string>* named, FileKind kind, int threads) {
    SceneReader reader(path, threads);
    try {
        const FileBytes file(path, kind);
        EditedJson json;
        refuseOptions(path, edits);
        if (!edits.empty()) json = edited(path, file.text(), edits);
        const JsonDocument document(path, edits.empty() ? file.text() : json.text, json.edits);
        reader.read(JsonView(document));
    } catch (const Error&) {
        if (named) *named = reader.files();
        throw;
    } catch (const std::bad_alloc&) {
        failForMemory(path, "this scene");
    }
    if (named) *named = reader.files();
    return {std::move(reader.description()), reader.warnings(), reader.files()};
}

}  // namespace raytracer
