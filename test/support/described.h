// Scenes made in code, and scenes multiplied and moved.
#pragma once

#include <functional>

#include "scene_files.h"

namespace raytracer::test {

// The same scene in another unit of length: positions, and the scale of every transform (a plane's texture
// repeats by it).
inline SceneDescription scaled(SceneDescription scene, double factor) {
    scene.camera.eye *= factor;
    if (scene.camera.type == CameraDescription::Type::Orthographic)
        for (double* edge : {&scene.camera.film_left, &scene.camera.film_right, &scene.camera.film_bottom,
                             &scene.camera.film_top})
            *edge *= factor;
    for (LightDescription& light : scene.lights) light.position *= factor;
    for (TransformDescription& transform : scene.transforms) {
        if (transform.translate) *transform.translate *= factor;
        transform.scale =
            transform.scale.value_or(glm::dvec3(1)) * factor;  // right of rotate: a plain factor passes it
    }
    return scene;
}

// The same scene somewhere else.
inline SceneDescription translated(SceneDescription scene, const glm::dvec3& by) {
    scene.camera.eye += by;
    for (LightDescription& light : scene.lights) light.position += by;
    for (TransformDescription& transform : scene.transforms)
        transform.translate = transform.translate.value_or(glm::dvec3(0)) + by;
    return scene;
}

// A scene that is put together step by step. The camera is orthographic, above the z = 0 plane's unit square,
// looking down.
struct SceneMaker {
    SceneMaker() {
        scene.camera.type = CameraDescription::Type::Orthographic;
        scene.camera.eye = {0, 0, 10};
    }

    // Each of its own colour: `ambient`, which a light of (1, 1, 1) shows as it is.
    MaterialDescription& material(const glm::dvec3& ambient) {
        MaterialDescription m;
        m.color_ambient = ambient;
        m.color_diffuse = m.color_specular = glm::dvec3(0);
        scene.materials.push_back(m);
        return scene.materials.back();
    }
    MaterialDescription& glass(const glm::dvec3& color, double index) {
        MaterialDescription& m = material(glm::dvec3(0));
        m.refractive = true;
        m.color_refract = color;
        m.index_of_refraction = index;
        return m;
    }
    // A shape of the material made last.
    void shape(ShapeType type, const TransformDescription& transform) {
        scene.transforms.push_back(transform);
        scene.shapes.push_back({type, scene.transforms.size() - 1, scene.materials.size() - 1, nullptr});
    }
    void light(const glm::dvec3& position, const glm::dvec3& color = glm::dvec3(1)) {
        scene.lights.push_back({position, color, glm::dvec3(1)});
    }

    SceneDescription scene;
};

inline ByteImage bytesOf(const SceneDescription& scene, int longEdge, Precision precision = Precision::Double,
                         const std::function<void(RenderOptions&)>& change = {}) {
    RenderOptions options = wholePicture(scene, longEdge);
    options.threads = 1;
    if (change) change(options);
    return renderBytes(*makeRenderer(scene, precision), options);
}

// Pixels in which some channel differs by more than `by`.
inline int differingPixels(const ByteImage& a, const ByteImage& b, int by) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
        bool differs = false;
        for (std::size_t channel = i; channel < i + 3; ++channel)
            differs = differs || std::abs(int(a.pixels[channel]) - int(b.pixels[channel])) > by;
        count += differs;
    }
    return count;
}

}  // namespace raytracer::test
