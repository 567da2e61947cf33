// The options that determine a picture, shared by all commands that render.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/util/file_bytes.h"

namespace raytracer::commands {

struct RenderArguments {
    std::string scene;
    std::vector<std::string> sets;  // edits of the scene, "/pointer=value"
    int longEdge = 0;
    RenderOptions options;  // those that the line gives directly; prepare() sets the others
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

    // Adds what every command that renders has, except LONG_EDGE_PIXELS, whose place differs.
    void addTo(CommandLine& line);
    void addPictureTo(CommandLine& line);  // options that concern more than one pixel
    void addLongEdgeTo(CommandLine& line);

    // The terms named by `only`. Throws Error.
    Terms terms() const;

    Precision chosenPrecision() const;

    // Warns if the scene's numbers need a wider precision than the chosen one.
    std::unique_ptr<Renderer> makeRenderer(const SceneDescription& scene) const;

    // Loads the scene. Warnings, those of the loader and the advice on the scene, go to stderr unless
    // `quiet`. If `strict`, they are errors: all are printed, except the last one, which is thrown. `files`
    // gets the names of the scene file and of all files that it names, even if this throws.
    SceneDescription load(std::vector<std::string>* files = nullptr, FileKind kind = FileKind::Any) const;

    // Whether `warn` has any effect.
    bool warns() const { return strict || !quiet; }

    // Warns about the scene as a whole; with `strict` this is an error, too.
    void warn(const std::string& warning) const;

    // Warns about the cost of the picture. That is no fault of the scene, so never an error.
    void remark(const std::string& text) const;

    // Whether the picture shows all that the scene describes, with all terms. Only then may a message blame
    // the scene for the picture.
    bool isWhole() const { return pass == "color" && only.empty() && crop.empty(); }

    // Applies `only` and `opaque` to the scene, and returns the complete options. Throws Error.
    RenderOptions prepare(SceneDescription& scene) const;

    // The setting without those of its options that `check` refuses since they have no effect.
    Setting accepted(Setting setting) const;

    // Throws Error for unknown terms, and for an option that is given but has no effect.
    void check(const CommandLine& line) const;

  private:
    bool recurses() const;  // whether any ray may be reflected or refracted
    void warnAll(const std::vector<std::string>& warnings) const;
};

}  // namespace raytracer::commands
