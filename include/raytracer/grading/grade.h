// Scenes with reference pictures: who paints them, and how well.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracer/grading/compare.h"

namespace raytracer {

// The stages of the light model that reference pictures show, and the options of `render` that show
// them.
struct Stage {
    std::string_view name;  // X-NAME.png
    std::string_view pass;  // --pass
    std::string_view only;  // --only; empty: all terms
};
std::span<const Stage> stages();

// The last stage, the complete picture: X.png and X-raytracing.png.
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

// Every X.json in the folder `scenes` with its X.png and X-STAGE.png in the folder `references` (which may be
// the same). Throws std::runtime_error, one line, where a folder can't be read.
GradePlan planGrading(const std::string& scenes, const std::string& references);

// What a painter has to say of its work. What is in it does not say that there is a picture.
struct Painted {
    bool failed = false;  // what it may have written does not count
    std::string message;  // one line, empty if all is well
    std::string output;   // the end of what the program printed
};

// Paints the case's picture, `longEdge` pixels on its longer side, to the PNG file `out`.
using Painter = std::function<Painted(const GradeCase& test, int longEdge, const std::string& out)>;

// A painter that runs `command scene.json out.png longEdge`.
Painter programPainter(std::string command, double timeoutSeconds);

struct GradeResult {
    GradeCase test;
    std::optional<Comparison>
        comparison;               // of our picture with the reference; nothing where there is none to compare
    std::string message, output;  // as the painter's, or why there is nothing to compare
    double seconds = 0;           // that painting took, wall time
    std::string referencePng, ourPng, differencePng;  // the files' bytes; empty where there is none

    int score() const { return comparison ? comparison->score : 0; }
};

// Never throws for what is wrong with the picture or the reference: that is a result. `longEdge` 0: the
// reference's.
GradeResult gradeCase(const GradeCase& test, const Painter& painter, int longEdge);

bool within(const GradeResult& result, const Thresholds& thresholds);

// The lower score first, then the larger error, then the name.
bool isWorse(const GradeResult& a, const GradeResult& b);

}  // namespace raytracer
