// raytracer grade DIR: scenes with reference pictures, rendered and compared.
#include <algorithm>
#include <optional>
#include <string>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/grading/grade_report.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/error.h"
#include "raytracer/util/output_file.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"
#include "render_arguments.h"

namespace raytracer::commands {

namespace {

constexpr const char* gradeFooter =
    R"(Renders and compares every X.json in DIR that has a picture X.png or
X-STAGE.png. The stages:
  raycasting, normals, ambient, diffuse, specular, ambient_diffuse_specular,
  ambient_diffuse_specular_shadows, diffuse_reflections_recursions_3,
  raytracing (as X.png: everything)
Another program is graded for the last of them, unless --stage says otherwise.
If it crashes, hangs or writes no picture, it gets 0 for that scene, and the
last line that it printed is shown.

Exit status: 0 all the same; 1 not the same; 2 there is nothing to grade, or the
grader itself cannot work: a reference is broken, a disk is full.
"The same" as for `raytracer compare`: no pixel differs, or what --max-pixels,
--tolerance and --min-score say, for each picture.

Examples:
  raytracer grade scenes --references test/expected
  # a page that shows every pixel that differs
  raytracer grade reference --report report.html
  raytracer grade exam --program ~/ada/raytracer --report ada.html
  raytracer grade exam --program "python3 bob.py" --timeout 120 --size 300
  raytracer grade homework2 --program ./raycasting --stage raycasting)";

struct GradeArguments {
    std::string scenes, references, report, program, stage;
    std::optional<int> size;
    double timeout = 60;
    Thresholds thresholds;

    void addTo(CommandLine& line) {
        line.text("DIR", scenes, "The folder of the scenes", Looks::Folder);
        line.text("--references", references, "The folder of the reference pictures, where it is not DIR",
                  Looks::Folder);
        line.number("--size", size, longEdgeRange,
                    "Pixels along the longer side; without it: the reference's");
        line.choice("--stage", stage, stageNames(), "Grade only the pictures of this stage");
        line.text("--report", report, "Write a page with all pictures: .html, complete in itself");
        line.text("--program", program, "Grade another program: runs PROGRAM scene.json out.png SIZE");
        line.number("--timeout", timeout, above(0), "Seconds after which the program is stopped");
        line.needs("--timeout", "--program");
        addThresholds(line, thresholds);
        line.footer(gradeFooter);
    }

    static std::vector<std::string> stageNames() {
        std::vector<std::string> names;
        for (const Stage& known : stages()) names.emplace_back(known.name);
        return names;
    }
};

// Our own renderer, in this process.
Rendered renderHere(const GradeCase& test, int longEdge, const std::string& out) {
    RenderArguments arguments;
    arguments.longEdge = longEdge;
    arguments.pass = test.stage->pass;
    arguments.only = test.stage->only;
    SceneDescription scene;
    try {
        scene = loadScene(test.scene, false).description;
    } catch (const Error& error) {
        return {true, error.what(), ""};
    }
    const RenderOptions options = arguments.prepare(scene);
    requirePictureFits(test.scene, options.crop, false);
    ByteSink sink(options.crop);
    makeRenderer(scene, Precision::Double)->render(options, sink);
    writePng(out, sink.image());
    return {};
}

GradePlan planFor(const GradeArguments& arguments) {
    const std::string& references = arguments.references.empty() ? arguments.scenes : arguments.references;
    GradePlan plan = planGrading(arguments.scenes, references);
    std::string stage = arguments.stage;
    if (stage.empty() && !arguments.program.empty()) stage = completeStage().name;
    if (!stage.empty())
        std::erase_if(plan.cases, [&](const GradeCase& test) { return test.stage->name != stage; });
    return plan;
}

void printHead() {
    print(formatted("%5s %9s %9s %9s %9s %9s  %s\n", "score", "off", "by > 1", "by > 8", "speckle", "seconds",
                    "picture"));
}

void printRow(const GradeResult& result) {
    const auto count = [](std::uint64_t value) { return static_cast<unsigned long long>(value); };
    std::string row = formatted("%5d %49.2f  ", 0, result.seconds);
    if (const auto& c = result.comparison)
        row = formatted("%5d %9llu %9llu %9llu %9llu %9.2f  ", c->score, count(c->pixelsOver(0)),
                        count(c->pixelsOver(1)), count(c->pixelsOver(8)), count(c->speckle), result.seconds);
    const std::string message = result.message.empty() ? "" : ": " + result.message;
    print(row + printable(result.test.name + message) + "\n");
}

// The program's last line, which mostly says what went wrong.
void printLastWords(const GradeResult& result) {
    const std::string& text = result.output;
    const std::size_t end = text.find_last_not_of(" \r\n\t");
    if (result.message.empty() || end == std::string::npos) return;
    const std::size_t newline = text.find_last_of("\r\n", end);
    const std::size_t start = newline == std::string::npos ? 0 : newline + 1;
    print(std::string(59, ' ') + text.substr(start, end + 1 - start) + "\n");
}

std::vector<GradeResult> gradeAll(const GradePlan& plan, const GradeArguments& arguments) {
    const CaseRenderer render = arguments.program.empty()
                                    ? CaseRenderer(renderHere)
                                    : programRenderer(arguments.program, arguments.timeout);
    std::vector<GradeResult> results;
    printHead();
    for (const GradeCase& test : plan.cases) {
        results.push_back(gradeCase(test, render, arguments.size.value_or(0)));
        printRow(results.back());
        printLastWords(results.back());
    }
    return results;
}

// True if all are as their references.
bool printSummary(const std::vector<GradeResult>& results, const GradePlan& plan,
                  const Thresholds& thresholds) {
    const auto good = std::count_if(results.begin(), results.end(),
                                    [&](const GradeResult& result) { return within(result, thresholds); });
    double sum = 0;
    for (const GradeResult& result : results) sum += result.score();
    print(formatted("%lld of %zu pictures as the reference, mean score %.1f\n", static_cast<long long>(good),
                    results.size(), sum / static_cast<double>(results.size())));
    for (const std::string& scene : plan.scenesWithoutReference)
        print("no reference: " + printable(scene) + "\n");
    return static_cast<std::size_t>(good) == results.size();
}

std::string reportOf(const GradeArguments& arguments, const std::vector<GradeResult>& results) {
    const std::string title =
        (arguments.program.empty() ? "raytracer" : arguments.program) + " on " + arguments.scenes;
    return gradeReport(results, arguments.thresholds, title);
}

int gradeFolder(const GradeArguments& arguments) {
    std::optional<OutputFile> report;
    if (!arguments.report.empty()) report.emplace(arguments.report);
    const GradePlan plan = planFor(arguments);
    if (plan.cases.empty())
        throw Error({arguments.scenes}, "no scene X.json that has a reference X.png or X-STAGE.png");
    const std::vector<GradeResult> results = gradeAll(plan, arguments);
    if (report) report->write(reportOf(arguments, results));
    return printSummary(results, plan, arguments.thresholds) ? 0 : 1;
}

}  // namespace

int grade(int argc, char** argv) {
    CommandLine line("raytracer grade",
                     "Renders every scene of a folder that has a reference picture, and compares.");
    GradeArguments arguments;
    arguments.addTo(line);
    if (const auto status = line.parse(argc, argv)) return *status;
    return gradeFolder(arguments);
}

}  // namespace raytracer::commands
