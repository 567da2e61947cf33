// Grading: scenes are rendered, by us or by another program, and compared with reference pictures.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracer/grading/compare.h"

namespace raytracer {

// A stage of the light model that reference pictures show, and the options of `render` for it.
struct Stage {
    std::string_view name;  // X-NAME.png
    std::string_view pass;  // --pass
    std::string_view only;  // --only; empty: all terms
};
std::span<const Stage> stages();

// The last stage, with everything: X.png and X-raytracing.png.
const Stage& completeStage();

// One reference picture and its scene.
struct GradeCase {
    std::string name;   // the reference's, without .png: "cone_cube-ambient"
    std::string group;  // the name's first word: "cone"
    const Stage* stage = nullptr;
    std::string scene, reference;  // paths
};

struct GradePlan {
    std::vector<GradeCase> cases;                     // sorted by name
    std::vector<std::string> scenesWithoutReference;  // file names
};

// Each X.json in the folder `scenes` with its X.png and X-STAGE.png in the folder `references`, which may be
// the same. Throws Error if a folder cannot be read.
GradePlan planGrading(const std::string& scenes, const std::string& references);

// The outcome of rendering a case. It does not say whether there is a picture.
struct Rendered {
    bool failed = false;  // a picture that was written all the same does not count
    std::string message;  // one line, empty without a failure
    std::string output;   // the end of what the program printed
};

// Renders the case's picture, `longEdge` pixels on its longer side, to the PNG file `out`. Throws where that
// fails for a reason that is not the renderer's.
using CaseRenderer = std::function<Rendered(const GradeCase& test, int longEdge, const std::string& out)>;

// Runs `command scene.json out.png longEdge`. What it writes is a picture only where it is a regular file.
CaseRenderer programRenderer(const std::string& command, double timeoutSeconds);

struct GradeResult {
    GradeCase test;
    std::optional<Comparison> comparison;  // of our picture with the reference; empty if one is missing
    std::string message, output;           // as in Rendered, or why there is no comparison
    double seconds = 0;                    // wall time of rendering
    std::string referencePng, ourPng, differencePng;  // the files' bytes; empty if there is no file

    int score() const { return comparison ? comparison->score : 0; }
};

// A fault of the picture is part of the result. Throws Error for what is not the renderer's: a reference that
// cannot be read, no temporary folder, a full disk. With `longEdge` 0 the picture has the reference's size.
GradeResult gradeCase(const GradeCase& test, const CaseRenderer& render, int longEdge);

bool within(const GradeResult& result, const Thresholds& thresholds);

// The lower score first, then the larger error, then the name.
bool isWorse(const GradeResult& a, const GradeResult& b);

}  // namespace raytracer
