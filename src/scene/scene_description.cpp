#include "raytracer/scene/scene_description.h"

#include "raytracer/util/memory.h"

namespace raytracer {
namespace {

// What a copy of a list takes beside what its elements point to.
template <class List>
double bytesOf(const List& list) {
    return static_cast<double>(sizeof(list[0]) * list.size());
}

constexpr double bytesOfBlock = 16;  // that malloc adds, at most

double bytesPointedTo(const std::string& text) {
    static const std::size_t within = std::string().capacity();
    return text.size() <= within ? 0 : static_cast<double>(text.size() + 1) + bytesOfBlock;
}

template <class T>
double bytesPointedTo(const Rare<T>& value) {
    return value ? sizeof(T) + bytesOfBlock : 0;
}

double bytesOf(const SceneDescription& scene) {
    double bytes = bytesOf(scene.materials) + bytesOf(scene.lights) + bytesOf(scene.transforms) +
                   bytesOf(scene.shapes) + bytesOf(scene.textures);
    for (const MaterialDescription& material : scene.materials)
        bytes += bytesPointedTo(material.name) + bytesPointedTo(material.diffuse_texture);
    for (const TransformDescription& transform : scene.transforms)
        bytes += bytesPointedTo(transform.name) + bytesPointedTo(transform.rotate) +
                 bytesPointedTo(transform.matrix);
    return bytes;
}

}  // namespace

SceneDescription copyOf(const SceneDescription& scene) {
    requireMemory({}, "a copy of the scene", bytesOf(scene));
    return scene;
}

}  // namespace raytracer
