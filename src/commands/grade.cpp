// raytracer grade DIR: renders scenes that have reference pictures, and compares.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "grade_arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/grading/grade_files.h"
#include "raytracer/grading/submissions.h"
#include "raytracer/json/json_document.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/error.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/output_file.h"
#include "raytracer/util/progress_bar.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"
#include "render_arguments.h"

namespace raytracer::commands {

namespace {

RenderArguments argumentsOf(const GradeCase& test, int longEdge) {
    RenderArguments arguments;
    arguments.longEdge = longEdge;
    arguments.pass = test.stage->pass;
    arguments.only = test.stage->only;
    return arguments;
}

// Renders with our own renderer, in this process.
Rendered renderHere(const GradeCase& test, int longEdge, const std::string& out) {
    SceneDescription scene = loadScene(test.scene).description;
    const RenderOptions options = argumentsOf(test, longEdge).prepare(scene);
    requirePictureFits(test.scene, options.crop, false);
    ByteSink sink(options.crop);
    makeRenderer(scene, Precision::Double)->render(options, sink);
    writePng(out, sink.image());
    return {};
}

// Makes the namer that explains wrong pictures of a case. Null if the scene cannot be rendered at this size.
std::unique_ptr<MistakeNamer> namerOf(const GradeCase& test, const ImageSize& size) {
    try {
        SceneDescription scene = loadScene(test.scene).description;
        const SceneDescription whole = copyOf(scene);
        const RenderArguments arguments = argumentsOf(test, std::max(size.width, size.height));
        const RenderOptions options = arguments.prepare(scene);
        if (options.size != size) return nullptr;
        return std::make_unique<MistakeNamer>(whole, options, arguments.terms());
    } catch (const OutOfMemory&) {
        throw;
    } catch (const Error&) {
        return nullptr;
    }
}

// The only stage that is graded; empty: all stages.
std::string stageOf(const GradeArguments& arguments) {
    if (!arguments.stage.empty() || arguments.program.empty()) return arguments.stage;
    return std::string(completeStage().name);
}

GradePlan planFor(const GradeArguments& arguments) {
    const std::string& references = arguments.references.empty() ? arguments.scenes : arguments.references;
    GradePlan plan = planGrading(arguments.scenes, references);
    const std::string stage = stageOf(arguments);
    if (!stage.empty())
        std::erase_if(plan.cases, [&](const GradeCase& test) { return test.stage->name != stage; });
    return plan;
}

void requireCases(const GradePlan& plan, const GradeArguments& arguments) {
    if (!plan.cases.empty()) return;
    const bool hasFolder = !arguments.references.empty();
    const std::string stage = stageOf(arguments);
    const std::string pictures = stage.empty()                   ? "X.png or X-STAGE.png"
                                 : stage == completeStage().name ? "X.png"
                                                                 : "X-" + stage + ".png";
    throw Error({hasFolder ? arguments.references : arguments.scenes},
                "no reference " + pictures + " of a scene X.json" +
                    (hasFolder ? " in " + printable(arguments.scenes) : "; --references names their folder"));
}

// Warns of pictures that are named nearly as references. What a scene names is a texture.
void warnOfStrays(const GradePlan& plan, std::span<const std::string> inputs) {
    for (const StrayPicture& stray : plan.strays) {
        const auto isStray = [&](const std::string& input) {
            std::error_code error;
            return std::filesystem::equivalent(stray.path, input, error);
        };
        if (std::ranges::none_of(inputs, isStray))
            tell(std::string("warning: ") + Error({stray.path}, stray.why).what());
    }
}

std::vector<GradeResult> gradeAll(const GradePlan& plan, const GradeArguments& arguments) {
    const CaseRenderer render = arguments.program.empty()
                                    ? CaseRenderer(renderHere)
                                    : programRenderer(arguments.program, arguments.programOptions());
    std::vector<GradeResult> results;
    arguments.show(gradeTableHead());
    for (const GradeCase& test : plan.cases) {
        results.push_back(gradeCase(test, render, namerOf));
        arguments.show(gradeTableRow(results.back()));
    }
    return results;
}

std::vector<std::string> outputsOf(const GradeArguments& arguments) {
    return {arguments.report, arguments.csv, arguments.json, arguments.junit, arguments.gradescope};
}

// The output files that the user asks for. They are opened before the work begins.
struct GradeFiles {
    explicit GradeFiles(const GradeArguments& arguments) {
        refuseSameOutput(outputsOf(arguments));
        if (!arguments.report.empty() && !arguments.submissions.empty()) shelf.emplace(arguments.report);
        const auto open = [](std::optional<OutputFile>& file, const std::string& path) {
            if (!path.empty()) file.emplace(path);
        };
        open(report, arguments.report);
        open(csv, arguments.csv);
        open(json, arguments.json);
        open(junit, arguments.junit);
        open(gradescope, arguments.gradescope);
    }

    // Writes all files except the report.
    void write(std::span<const GradedSubmission> graded, const GradeArguments& arguments) {
        const Thresholds& thresholds = arguments.thresholds;
        if (csv) csv->write(gradesAsCsv(graded, thresholds));
        if (json) json->write(gradesAsJson(graded, thresholds));
        if (junit) junit->write(gradesAsJunit(graded, thresholds));
        if (gradescope) gradescope->write(gradesForGradescope(graded[0], thresholds, arguments.points));
    }

    std::optional<OutputFile> report, csv, json, junit, gradescope;
    std::optional<PictureShelf> shelf;  // of a class's report
};

void refuseInputs(const GradeArguments& arguments, const GradeFiles& output,
                  std::span<const std::string> inputs, const std::vector<Submission>& submissions) {
    std::vector<std::string> outputs = outputsOf(arguments), folders;
    if (output.shelf) outputs.push_back(output.shelf->folder());
    for (const Submission& submission : submissions) folders.push_back(submission.folder);
    for (const std::string& out : outputs) {
        refuseInput(out, inputs);
        refuseInput(out, folders);
        refuseInside(out, folders);
    }
}

int gradeFolder(const GradeArguments& arguments, const GradePlan& plan, GradeFiles& output) {
    const GradedSubmission one{arguments.program.empty() ? "raytracer" : arguments.program,
                               gradeAll(plan, arguments)};
    if (output.report)
        output.report->write(gradeReport(one, arguments.thresholds, one.name + " on " + arguments.scenes));
    output.write({&one, 1}, arguments);
    arguments.show(gradeSummary(one, plan, arguments.thresholds));
    return one.rightCount(arguments.thresholds) == one.results.size() ? 0 : 1;
}

// Throws Error if it cannot be looked at.
bool hasFile(const Submission& submission, const std::string& name) {
    const std::string path = replaced(name, "{}", submission.given);
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    const bool isLoop = error == std::errc::too_many_symbolic_link_levels;  // the student's fault
    if (!status_known(status) && !isLoop) throw Error({path}, "cannot read: " + error.message());
    return !isLoop && exists(status);
}

std::string missingInAll(const std::string& name) {
    const std::size_t at = name.find("{}");
    const bool hasMore = at > 0 && at + 2 < name.size();
    if (hasMore) return "write " + printable(name.substr(at)) + ": {} is the whole path of a submission";
    return "no submission has a file " + printable(name);
}

// Throws UsageError if no submission has the program: that is a slip of the command line, not of all
// students. Throws Error if that of any submission cannot be looked at.
void requireProgramIn(const std::vector<Submission>& submissions, const std::string& program) {
    for (const std::string& name : filesStarted(program)) {
        if (name.find("{}") == name.npos) continue;
        std::size_t count = 0;
        for (const Submission& submission : submissions) count += hasFile(submission, name);
        if (count == 0) throw UsageError("--program: " + missingInAll(name));
    }
}

int gradeSubmissions(const GradeArguments& arguments, const GradePlan& plan,
                     const std::vector<Submission>& submissions, GradeFiles& output) {
    if (!arguments.gradescope.empty() && submissions.size() != 1)
        throw UsageError("--gradescope: expected one submission, found " +
                         std::to_string(submissions.size()));
    if (arguments.gradescope.empty()) requireProgramIn(submissions, arguments.program);
    PictureShelf* const shelf = output.shelf ? &*output.shelf : nullptr;
    std::vector<GradedSubmission> graded;
    {
        StepProgress progress(arguments.quiet, 1);
        const ClassOptions options{arguments.program, arguments.programOptions(), arguments.jobs};
        graded = gradeClass(plan, submissions, options, namerOf, shelf, progress);
    }
    const std::string title = arguments.submissions + " on " + arguments.scenes;
    if (output.report) output.report->write(classReport(graded, arguments.thresholds, title, *shelf));
    output.write(graded, arguments);
    arguments.show(classTable(graded, arguments.thresholds));
    const bool isBelow =
        arguments.thresholds.minScore && std::ranges::any_of(graded, [&](const GradedSubmission& submission) {
            return submission.worst().score() < *arguments.thresholds.minScore;
        });
    return isBelow ? 1 : 0;
}

}  // namespace

int grade(int argc, char** argv) {
    CommandLine line("grade", "Renders every scene of a folder that has a reference picture, and compares.");
    GradeArguments arguments;
    arguments.addTo(line);
    if (line.parse(argc, argv)) return 0;
    arguments.check();
    if (!arguments.quiet) print("");
    const GradePlan plan = planFor(arguments);
    GradeFiles output(arguments);
    const std::vector<std::string> inputs = requireGradable(plan);
    if (!arguments.quiet) warnOfStrays(plan, inputs);
    requireCases(plan, arguments);
    for (const std::string& input : inputs) arguments.options.inputs.add(input);
    std::vector<Submission> submissions;
    if (!arguments.submissions.empty()) submissions = submissionsIn(arguments.submissions);
    refuseInputs(arguments, output, inputs, submissions);
    return arguments.submissions.empty() ? gradeFolder(arguments, plan, output)
                                         : gradeSubmissions(arguments, plan, submissions, output);
}

}  // namespace raytracer::commands
