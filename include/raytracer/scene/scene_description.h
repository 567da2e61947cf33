// The scene as its author wrote it: the numbers of the JSON file, checked but not changed (a mesh's
// positions are in a unit of their own, MeshData::exponent).
//
// Everything here is in the user's own units and spaces (positions and lengths in world units, angles in
// degrees) and in double, the precision of JSON numbers. `scene_loader` makes it. The core, which is compiled
// once for each precision, builds its `Scene` from it, so every precision starts from the same numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "raytracer/util/large_vector.h"
#include "raytracer/util/rare.h"

namespace raytracer {

struct MeshData;  // mesh_file.h
struct Texture;   // texture.h

struct CameraDescription {
    enum class Type { Perspective, Orthographic };
    Type type = Type::Perspective;
    double focal_length = 1;  // perspective only, > 0
    glm::dvec3 eye{0, 0, 0}, look{0, 0, -1}, up{0, 1, 0};
    double film_left = -1, film_right = 1, film_bottom = -1, film_top = 1;
};

// Defaults are those of the assignment's defaults.json.
struct MaterialDescription {
    std::string name = "default";
    glm::dvec3 color_ambient{0}, color_diffuse{1}, color_specular{1};
    double shininess = 10;
    bool reflective = false;
    glm::dvec3 color_reflect{1};
    bool refractive = false;
    glm::dvec3 color_refract{1};
    double index_of_refraction = 1;
    bool use_diffuse_texture = false;
    std::string diffuse_texture;  // as in the file; without use_diffuse_texture it may name no texture
    std::size_t texture = 0;  // index into SceneDescription::textures; meaningful with use_diffuse_texture
};

struct LightDescription {
    glm::dvec3 position{0};
    glm::dvec3 color{1}, color_ambient{1};
};

// World from object is translate * rotate * scale * matrix. A part left out is the identity.
struct TransformDescription {
    struct Rotation {
        double degrees = 0;
        glm::dvec3 axis{0, 0, 1};
    };
    std::string name;
    std::optional<glm::dvec3> translate;
    Rare<Rotation> rotate;
    std::optional<glm::dvec3> scale;
    Rare<glm::dmat4> matrix;  // columns, as in the file; bottom row 0 0 0 1
};

enum class ShapeType : std::uint8_t { Sphere, Plane, Cylinder, Cone, Cube, Mesh };

struct ShapeDescription {
    ShapeType type = ShapeType::Sphere;
    std::size_t transform = 0, material = 0;  // indices into SceneDescription
    std::shared_ptr<const MeshData> mesh;     // for ShapeType::Mesh; shared by shapes that name the same file
};

// The names in the scene file.
inline constexpr std::string_view shapeTypeNames[] = {"sphere", "plane", "cylinder", "cone", "cube", "mesh"};
inline const char* typeName(ShapeType type) { return shapeTypeNames[static_cast<std::size_t>(type)].data(); }

struct TextureDescription {
    std::string name;
    std::shared_ptr<const Texture> texture;  // null where no shape's material uses it: it is not read
};

struct SceneDescription {
    CameraDescription camera;
    std::vector<MaterialDescription> materials;
    std::vector<LightDescription> lights;
    LargeVector<TransformDescription> transforms;
    LargeVector<ShapeDescription> shapes;
    std::vector<TextureDescription> textures;
};

// A copy. Throws OutOfMemory (memory.h) if there is too little for it.
SceneDescription copyOf(const SceneDescription& scene);

inline const MaterialDescription& materialOf(const SceneDescription& scene, std::size_t shape) {
    return scene.materials[scene.shapes[shape].material];
}

}  // namespace raytracer
