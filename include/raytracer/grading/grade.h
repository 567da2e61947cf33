// Grading: renders scenes, here or with another program, and compares the pictures with references.
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
#include "raytracer/util/file_watch.h"

namespace raytracer {

// A stage of the light model, as reference pictures show it, and the options of `render` for it.
struct Stage {
    std::string_view name;  // X-NAME.png
    std::string_view pass;  // --pass
    std::string_view only;  // --only; empty: all terms
};
std::span<const Stage> stages();

// The last stage, with all terms: X.png and X-raytracing.png.
const Stage& completeStage();

// One reference picture and its scene.
struct GradeCase {
    std::string name;   // the reference's, without .png: "cone_cube-ambient"
    std::string group;  // the scene's name: "cone_cube"
    const Stage* stage = nullptr;
    std::string scene, reference;  // paths
};

// A picture whose name begins as a reference's, and why it is none: `no stage "normal"; did you mean ...?`.
struct StrayPicture {
    std::string path, why;
};

struct GradePlan {
    std::vector<GradeCase> cases;                     // sorted by name
    std::vector<std::string> scenesWithoutReference;  // file names
    std::vector<StrayPicture> strays;                 // sorted by path; a scene's texture may be among them
};

// Plans a case for each X.json in the folder `scenes` and each X.png and X-STAGE.png in the folder
// `references`, which may be the same folder. Throws Error if a folder cannot be read.
GradePlan planGrading(const std::string& scenes, const std::string& references);

// Returns the files that are read: the references, the scenes and what these name. Throws Error if a scene,
// or a file that it names, cannot be read, or if a reference has not the shape of its scene's film: no
// program can be blamed for that.
std::vector<std::string> requireGradable(const GradePlan& plan);

// The outcome of rendering a case. It does not tell whether there is a picture.
struct Rendered {
    bool failed = false;                       // then a picture does not count, even if it was written
    std::string message;                       // one line; empty if all is well
    std::string output;                        // the end of what the program printed
    double seconds = 0, processorSeconds = 0;  // 0: unknown; processorSeconds is of programs only
    std::string instead{};  // of a missing picture: "a.jpg is there", "a.png is a symbolic link"

    std::string butInstead() const;  // ", but a.jpg is there"; empty if `instead` is
};

// Renders the case's picture, `longEdge` pixels on its longer side, to the PNG file `out`. Throws Error if
// that fails for a reason that is not the renderer's fault.
using CaseRenderer = std::function<Rendered(const GradeCase& test, int longEdge, const std::string& out)>;

// How programs are run.
struct ProgramOptions {
    ProcessLimits limits;
    std::string user;    // the user that runs them; empty: this program's
    FileWatch inputs{};  // files that no program may change
};

// Makes a renderer that runs `command scene.json out.png longEdge` in a fresh folder. The folder has a copy
// of the scene and of the files that it names, and nothing else. Only a regular file counts as a picture.
// Relative paths in the command still lead to files of the current folder: that of a program or its script,
// and any path with a slash.
CaseRenderer programRenderer(const std::string& command, const ProgramOptions& options);

// The files that a command starts first: the program, and its script if the program is an interpreter. Empty
// if only a shell can tell. "{}" stands for a submission's folder.
std::vector<std::string> filesStarted(const std::string& command);

// Why a command cannot be started: its syntax is no shell's, it ends in a comment, there is no such program
// or script, it is a folder, or it is not executable. Empty if it can be started, if only a shell can tell,
// and for a file in a submission.
std::string programFault(const std::string& command);

// Makes the namer for a case's scene; null if the scene's picture has another size, or cannot be made.
using NamerMaker = std::function<std::unique_ptr<MistakeNamer>(const GradeCase& test, const ImageSize& size)>;

// The result for one picture. `message` may also say why there is no comparison.
struct GradeResult : Rendered {
    GradeCase test;
    std::optional<Comparison> comparison;  // of the graded picture with the reference; empty if impossible
    std::string path;                      // of a picture that was handed in
    std::string note;                      // what is odd about the name of a picture that counts
    bool isMissing = false;                // whether no picture was handed in
    bool isUnreadable = false;             // whether there is a file that cannot be compared
    std::string referencePng, ourPng, differencePng;  // the files' bytes; empty if there is no file
    struct {
        std::string reference, ours, difference;
    } keys;  // the pictures' keys, if they are on a PictureShelf instead

    // For a wrong picture: what explains it, or why nothing does (Diagnosis), and the colours of its worst
    // pixel. Nothing need explain one that differs by rounding only: the program is right.
    std::vector<std::string> mistakes;
    std::string sentence, unnamed;
    std::array<std::uint8_t, 3> ourWorst{}, referenceWorst{};

    int score() const { return comparison ? comparison->score : 0; }
};

// A reference picture, read from a file. Throws Error.
struct ReferencePicture {
    explicit ReferencePicture(const std::string& path);

    std::string png;
    ByteImage image;
};

// Names the mistakes of a case's pictures. Makes the MistakeNamer when the first wrong picture needs it.
class NamedCase {
  public:
    NamedCase(const GradeCase& test, const ReferencePicture& reference, NamerMaker makeNamer);
    void name(GradeResult& result, const ByteImage& picture);

  private:
    void tryNamer();

    const GradeCase& test_;
    const ReferencePicture& reference_;
    NamerMaker makeNamer_;
    bool isTried_ = false;
    std::unique_ptr<MistakeNamer> namer_;  // null if our own picture differs from the reference
};

// Compares the picture in a file with the reference. A fault of the picture goes into the result. Throws
// OutOfMemory: that is no fault of it.
void gradePicture(GradeResult& result, const ReferencePicture& reference, const std::string& picture,
                  NamedCase* named);

// Renders a case and grades the picture, which must have the reference's size. Throws Error for what is not
// the renderer's fault: a reference that cannot be read, no temporary folder, a full disk, too little memory.
GradeResult gradeCase(const GradeCase& test, const CaseRenderer& render, const NamerMaker& makeNamer = {});

bool within(const GradeResult& result, const Thresholds& thresholds);

// Whether a comes before b: the lower score first, then the larger error, then the name.
bool isWorse(const GradeResult& a, const GradeResult& b);

}  // namespace raytracer
