// The scenes of scenes/, for tests that hold for every one of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "raytracer/pictures/image.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer::test {

inline std::vector<std::string> sceneFiles() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(SOURCE_DIR "/scenes"))
        if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
            files.push_back(entry.path().string());
    return files;
}

// A square film.
inline void setFilm(SceneDescription& scene, double low, double high) {
    scene.camera.film_left = scene.camera.film_bottom = low;
    scene.camera.film_right = scene.camera.film_top = high;
}

inline RenderOptions wholePicture(const SceneDescription& scene, int longEdge) {
    RenderOptions options;
    options.size = imageSize(scene.camera, longEdge);
    options.crop = {0, 0, options.size.width, options.size.height};
    return options;
}

inline ByteImage renderBytes(const Renderer& renderer, const RenderOptions& options) {
    ByteSink sink(options.crop);
    renderer.render(options, sink);
    return sink.image();
}

inline FloatImage renderFloats(const Renderer& renderer, const RenderOptions& options) {
    FloatSink sink(options.crop);
    renderer.render(options, sink);
    return sink.image();
}

}  // namespace raytracer::test
