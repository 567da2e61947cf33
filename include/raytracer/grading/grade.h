// Grading: scenes are rendered, by us or by another program, and compared with reference pictures.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracer/grading/compare.h"
#include "raytracer/grading/diagnosis.h"
#include "raytracer/util/child_process.h"

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
    std::string group;  // the scene's name: "cone_cube"
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

// Throws Error where a scene, or a file that it names, cannot be read: no program can be blamed for that.
void requireGradable(const GradePlan& plan);

// The outcome of rendering a case. It does not say whether there is a picture.
struct Rendered {
    bool failed = false;                       // a picture that was written all the same does not count
    std::string message;                       // one line, empty without a failure
    std::string output;                        // the end of what the program printed
    double seconds = 0, processorSeconds = 0;  // 0: not known; the latter of programs only
};

// Renders the case's picture, `longEdge` pixels on its longer side, to the PNG file `out`. Throws where that
// fails for a reason that is not the renderer's.
using CaseRenderer = std::function<Rendered(const GradeCase& test, int longEdge, const std::string& out)>;

// How programs are run.
struct ProgramOptions {
    ProcessLimits limits;
    std::string user;  // empty: ours
};

// Runs `command scene.json out.png longEdge` in a fresh folder, which has a copy of the scene and of what
// that names, and nothing else. What is written is a picture only where it is a regular file. A path of the
// command from the current folder still is that path: of a program or its script, or one with a slash.
CaseRenderer programRenderer(const std::string& command, const ProgramOptions& options);

// What a command starts first: the program, and the script where that is an interpreter. Empty where only a
// shell knows. "{}" stands for a submission's folder.
std::vector<std::string> filesStarted(const std::string& command);

// Why a command can't be started: there is no such program or script, it is a folder, or it is not
// executable. Empty where it can be, where only a shell knows, and of a file in a submission.
std::string programFault(const std::string& command);

// The namer of a case's scene; nothing where it has another size, or cannot be made.
using NamerMaker = std::function<std::unique_ptr<MistakeNamer>(const GradeCase& test, const ImageSize& size)>;

// `message` may also say why there is no comparison.
struct GradeResult : Rendered {
    GradeCase test;
    std::optional<Comparison> comparison;  // of our picture with the reference; empty if one is missing
    std::string path;                      // of a picture that was handed in
    std::string note;                      // of a picture that counts: what is odd about its name
    bool isMissing = false;                // no picture was handed in
    std::string instead;                   // of a missing one: a file with its name, no PNG
    bool isUnreadable = false;             // there is a file, which cannot be compared
    std::string referencePng, ourPng, differencePng;  // the files' bytes; empty if there is no file
    struct {
        std::string reference, ours, difference;
    } keys;  // of a PictureShelf that has them instead

    // Of a wrong picture: what explains it (Diagnosis), where something does; and the colours of its worst
    // pixel.
    std::vector<std::string> mistakes;
    std::string sentence;
    bool isRounding = false;  // that of a right program, which rounds otherwise
    std::array<std::uint8_t, 3> ourWorst{}, referenceWorst{};

    int score() const { return comparison ? comparison->score : 0; }
    std::string butInstead() const;  // ", but a.jpg is there"; empty where nothing is instead
};

// A reference, read. Throws Error, also where the memory does not suffice for another picture of its size.
struct ReferencePicture {
    explicit ReferencePicture(const std::string& path);

    std::string png;
    ByteImage image;
};

// Names the mistakes of a case's pictures. What it needs is made for the first wrong one.
class NamedCase {
  public:
    NamedCase(const GradeCase& test, const ReferencePicture& reference, NamerMaker makeNamer);
    void name(GradeResult& result, const ByteImage& picture);

  private:
    const GradeCase& test_;
    const ReferencePicture& reference_;
    NamerMaker makeNamer_;
    bool isTried_ = false;
    std::unique_ptr<MistakeNamer> namer_;  // none where our picture is not the reference
};

// Compares the picture in a file with the reference. A fault of the picture is part of the result.
void gradePicture(GradeResult& result, const ReferencePicture& reference, const std::string& picture,
                  NamedCase* named);

// Throws Error for what is not the renderer's: a reference that cannot be read, no temporary folder, a full
// disk. The picture is to have the reference's size.
GradeResult gradeCase(const GradeCase& test, const CaseRenderer& render, const NamerMaker& makeNamer = {});

bool within(const GradeResult& result, const Thresholds& thresholds);

// The lower score first, then the larger error, then the name.
bool isWorse(const GradeResult& a, const GradeResult& b);

}  // namespace raytracer
