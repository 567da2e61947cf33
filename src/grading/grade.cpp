#include "raytracer/grading/grade.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <tuple>

#include "raytracer/util/child_process.h"
#include "raytracer/util/error.h"
#include "raytracer/util/temporary_folder.h"

namespace raytracer {

namespace fs = std::filesystem;

namespace {

constexpr Stage stageTable[] = {
    {"raycasting", "raycast", ""},
    {"normals", "normals", ""},
    {"ambient", "color", "ambient"},
    {"diffuse", "color", "diffuse"},
    {"specular", "color", "specular"},
    {"ambient_diffuse_specular", "color", "ambient,diffuse,specular"},
    {"ambient_diffuse_specular_shadows", "color", "ambient,diffuse,specular,shadows"},
    {"diffuse_reflections_recursions_3", "color", "diffuse,reflections"},
    {"raytracing", "color", ""},
};

std::string firstWord(const std::string& name) {
    const auto end =
        std::find_if_not(name.begin(), name.end(), [](unsigned char c) { return std::isalpha(c); });
    return end == name.begin() ? name : std::string(name.begin(), end);
}

std::vector<fs::path> filesIn(const std::string& folder, const char* ending) {
    std::vector<fs::path> files;
    std::error_code error, isGone;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == ending && entry->is_regular_file(isGone))
            files.push_back(entry->path());
    if (error) throw Error({folder}, "cannot read the folder: " + error.message());
    return files;
}

void addCase(GradePlan& plan, const fs::path& scene, const fs::path& reference, const Stage& stage) {
    if (!fs::exists(reference)) return;
    const std::string name = reference.stem().string();
    plan.cases.push_back({name, firstWord(name), &stage, scene.string(), reference.string()});
}

void planScene(GradePlan& plan, const fs::path& scene, const fs::path& references) {
    const std::size_t before = plan.cases.size();
    const std::string name = scene.stem().string();
    addCase(plan, scene, references / (name + ".png"), completeStage());
    for (const Stage& stage : stageTable)
        addCase(plan, scene, references / (name + "-" + std::string(stage.name) + ".png"), stage);
    if (plan.cases.size() == before) plan.scenesWithoutReference.push_back(scene.filename().string());
}

// The end of what a program printed, where errors are.
std::string endOf(const std::string& path) {
    constexpr std::streamoff most = 2000;  // characters: some 20 lines
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : 0;
    const std::streamoff start = std::max<std::streamoff>(0, size - most);
    std::string text(static_cast<std::size_t>(size - start), '\0');
    file.seekg(start);
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    return start > 0 ? "... " + text : text;
}

// The shell, too, reports a signal that killed the program. The message has that already.
void removeShellsReport(std::string& output, const ProcessEnd& end) {
    const std::size_t last = output.find_last_of('\n', output.empty() ? 0 : output.size() - 2);
    const std::size_t start = last == std::string::npos ? 0 : last + 1;
    if (end.signal && output.find(strsignal(end.signal), start) != std::string::npos) output.erase(start);
}

// False where the program has failed; the result says how.
bool renderCase(GradeResult& result, const CaseRenderer& render, int longEdge, const std::string& out) {
    const auto start = std::chrono::steady_clock::now();
    Rendered rendered = render(result.test, longEdge, out);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.message = std::move(rendered.message);
    result.output = std::move(rendered.output);
    std::error_code isLocked;
    const bool isThere = rendered.failed || fs::is_regular_file(out, isLocked);
    if (!isThere) result.message += std::string(result.message.empty() ? "" : ", ") + "wrote no picture";
    return !rendered.failed && isThere;
}

// An Error here is the program's.
void comparePicture(GradeResult& result, const ByteImage& reference, const std::string& out) {
    const FileBytes file(out, FileKind::Regular);
    if (const auto size = sizeInHeader(file)) requireSameSize(*size, {reference.width, reference.height});
    const ByteImage ours = readImage(out, FileKind::Regular);
    result.ourPng = file.text();
    result.comparison = compareImages(ours, reference);
    const std::vector<char> difference = encodePng(amplifiedDifference(ours, reference));
    result.differencePng.assign(difference.begin(), difference.end());
}

// What the grader itself needs, before the program is blamed.
void requireRoom(const TemporaryFolder& folder, const ByteImage& reference) {
    constexpr std::size_t printed = std::size_t{1} << 20;  // bytes: for what the program prints
    folder.requireRoom(reference.pixels.size() * 2 + printed);
}

}  // namespace

std::span<const Stage> stages() { return stageTable; }

const Stage& completeStage() { return *std::prev(std::end(stageTable)); }

GradePlan planGrading(const std::string& scenes, const std::string& references) {
    GradePlan plan;
    filesIn(references, ".png");  // throws if the folder cannot be read
    for (const fs::path& scene : filesIn(scenes, ".json")) planScene(plan, scene, references);
    std::sort(plan.cases.begin(), plan.cases.end(),
              [](const GradeCase& a, const GradeCase& b) { return a.name < b.name; });
    std::sort(plan.scenesWithoutReference.begin(), plan.scenesWithoutReference.end());
    return plan;
}

CaseRenderer programRenderer(const std::string& command, double timeoutSeconds) {
    return [=](const GradeCase& test, int longEdge, const std::string& out) {
        const std::string log = out + ".log";
        const ProcessEnd end =
            runProcess(command, {test.scene, out, std::to_string(longEdge)}, log, timeoutSeconds);
        std::string output = endOf(log);
        removeShellsReport(output, end);
        // With a picture, an exit status other than 0 is no failure: the course grades the picture.
        return Rendered{end.timedOut || end.signal != 0, end.description(), std::move(output)};
    };
}

GradeResult gradeCase(const GradeCase& test, const CaseRenderer& render, int longEdge) {
    GradeResult result;
    result.test = test;
    const FileBytes file(test.reference, FileKind::Regular);
    const ByteImage reference = readImage(test.reference, FileKind::Regular);
    requireMemoryToDecode(file);  // for the program's picture, so that this cannot be what fails then
    result.referencePng = file.text();
    const TemporaryFolder folder;
    requireRoom(folder, reference);
    const std::string out = folder.file("out.png");
    if (!renderCase(result, render, longEdge ? longEdge : std::max(reference.width, reference.height), out))
        return result;
    try {
        comparePicture(result, reference, out);
    } catch (const Error& error) {
        result.message = error.inFile();
    }
    return result;
}

bool within(const GradeResult& result, const Thresholds& thresholds) {
    return result.comparison && within(*result.comparison, thresholds);
}

bool isWorse(const GradeResult& a, const GradeResult& b) {
    const auto rank = [](const GradeResult& result) {
        return std::tuple(result.score(), result.comparison ? -result.comparison->rmse : -256.0,
                          result.test.name);
    };
    return rank(a) < rank(b);
}

}  // namespace raytracer
