#include "raytracer/grading/grade.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <tuple>

#include "raytracer/util/child_process.h"
#include "raytracer/util/file_bytes.h"
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
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == ending) files.push_back(entry->path());
    if (error) throw std::runtime_error(folder + ": cannot read the folder: " + error.message());
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

// The end of what a program printed: its last words tell more than its first ones.
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

// The shell tells on stderr, too, of a signal that killed the program; the message has that already.
void dropShellsRemark(std::string& output, const ProcessEnd& end) {
    const std::size_t last = output.find_last_of('\n', output.empty() ? 0 : output.size() - 2);
    const std::size_t start = last == std::string::npos ? 0 : last + 1;
    if (end.signal && output.find(strsignal(end.signal), start) != std::string::npos) output.erase(start);
}

std::string bytesOf(const std::string& path) {
    const FileBytes file(path);
    return {file.begin(), file.end()};
}

std::string pngBytes(const ByteImage& image, const std::string& temporary) {
    writePng(temporary, image);
    return bytesOf(temporary);
}

ByteImage readReference(GradeResult& result) {
    try {
        ByteImage reference = readImage(result.test.reference);
        result.referencePng = bytesOf(result.test.reference);
        return reference;
    } catch (const std::runtime_error& error) {
        throw ImageError("the reference: " + std::string(error.what()));
    }
}

void paint(GradeResult& result, const Painter& painter, int longEdge, const std::string& out) {
    const auto start = std::chrono::steady_clock::now();
    Painted painted = painter(result.test, longEdge, out);
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    result.message = std::move(painted.message);
    result.output = std::move(painted.output);
    if (painted.failed) throw ImageError(result.message);
    if (!fs::exists(out))
        throw ImageError(result.message + (result.message.empty() ? "" : ", ") + "wrote no picture");
}

void gradePicture(GradeResult& result, const Painter& painter, int longEdge) {
    const TemporaryFolder folder;
    const std::string out = folder.file("out.png");
    const ByteImage reference = readReference(result);
    paint(result, painter, longEdge ? longEdge : std::max(reference.width, reference.height), out);
    const ByteImage ours = readImage(out);
    result.ourPng = bytesOf(out);
    result.comparison = compareImages(ours, reference);
    result.differencePng = pngBytes(amplifiedDifference(ours, reference), folder.file("difference.png"));
}

}  // namespace

std::span<const Stage> stages() { return stageTable; }

const Stage& completeStage() { return *std::prev(std::end(stageTable)); }

GradePlan planGrading(const std::string& scenes, const std::string& references) {
    GradePlan plan;
    filesIn(references, ".png");  // that it can be read
    for (const fs::path& scene : filesIn(scenes, ".json")) planScene(plan, scene, references);
    std::sort(plan.cases.begin(), plan.cases.end(),
              [](const GradeCase& a, const GradeCase& b) { return a.name < b.name; });
    std::sort(plan.scenesWithoutReference.begin(), plan.scenesWithoutReference.end());
    return plan;
}

Painter programPainter(std::string command, double timeoutSeconds) {
    return [=](const GradeCase& test, int longEdge, const std::string& out) {
        const std::string log = out + ".log";
        const ProcessEnd end =
            runProcess(command, {test.scene, out, std::to_string(longEdge)}, log, timeoutSeconds);
        std::string output = endOf(log);
        dropShellsRemark(output, end);
        // A program that says it failed but wrote a picture is graded by the picture, as the course does.
        return Painted{end.timedOut || end.signal != 0, end.description(), std::move(output)};
    };
}

GradeResult gradeCase(const GradeCase& test, const Painter& painter, int longEdge) {
    GradeResult result;
    result.test = test;
    try {
        gradePicture(result, painter, longEdge);
    } catch (const std::exception& error) {
        result.message = error.what();
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
