// The options that say what a picture is: shared by every command that renders.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer::commands {

struct RenderArguments {
    std::string scene;
    std::vector<std::string> sets;  // edits of the scene, "/pointer=value"
    int longEdge = 0;
    RenderOptions options;  // those that a line gives as they are; prepare() makes the others
    std::string only;       // comma-separated terms; empty: all
    bool opaque = false;
    std::string pass = "color";
    std::string precision = "double";
    std::string crop;  // x0,y0,x1,y1; empty: the whole picture
    std::string accelerator = "bvh";
    std::optional<int> samples;
    std::string textureFilter = "nearest";
    bool strict = false;
    bool quiet = false;

    // What every command that renders has, but for LONG_EDGE_PIXELS, which not every command has next.
    void addTo(CommandLine& line);
    void addPictureTo(CommandLine& line);  // what concerns many pixels
    void addLongEdgeTo(CommandLine& line);

    // The terms named by `only`. Throws Error.
    Terms terms() const;

    Precision chosenPrecision() const;

    // Warns where the scene's numbers need a wider precision than the one chosen.
    std::unique_ptr<Renderer> makeRenderer(const SceneDescription& scene) const;

    // The scene of the file. Its warnings, the loader's and the advice on it, go to stderr unless `quiet`.
    // Where `strict`, all are told as errors, and the last one is thrown.
    // `files` gets the names of the scene and of all files that it names, also where this
    // throws.
    SceneDescription load(std::vector<std::string>* files = nullptr, FileKind kind = FileKind::Any) const;

    // Whether anyone hears what `warn` is told.
    bool warns() const { return strict || !quiet; }

    // What is said about the scene as a whole, in the same way.
    void warn(const std::string& warning) const;

    // What is said about what the picture takes: no fault of the scene, so not for `strict`.
    void remark(const std::string& text) const;

    // Whether the picture is what the scene file describes: all of it, with all terms. Of no other can the
    // scene be blamed.
    bool isWhole() const { return pass == "color" && only.empty() && crop.empty(); }

    // Applies `only` and `opaque` to the scene. Returns all options for it. Throws Error.
    RenderOptions prepare(SceneDescription& scene) const;

    // Throws Error for terms that are not there, and for an option that was given and can change nothing.
    void check(const CommandLine& line) const;

  private:
    void warnAll(const std::vector<std::string>& warnings) const;
};

}  // namespace raytracer::commands
