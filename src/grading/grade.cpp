#include "raytracer/grading/grade.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "raytracer/scene/scene_loader.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/util/error.h"
#include "raytracer/util/file_bytes.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/stopwatch.h"
#include "raytracer/util/temporary_folder.h"
#include "raytracer/util/text.h"

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

std::vector<fs::path> filesThatEndIn(const char* ending, const std::string& folder) {
    std::error_code error;
    std::vector<fs::path> files = filesIn(folder, error);
    if (error) throw folderError(folder, error);
    std::erase_if(files, [&](const fs::path& file) { return !endsIn(file.string(), ending); });
    return files;
}

void requireRegular(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) FileBytes(file.string(), FileKind::Regular);  // throws
}

// Pictures by their names without ending; X.png before X.PNG.
using PicturesByName = std::map<std::string, fs::path>;

PicturesByName picturesIn(const std::string& folder) {
    PicturesByName pictures;
    for (const fs::path& file : filesThatEndIn(".png", folder))
        if (file.extension() == ".png") pictures.insert_or_assign(file.stem().string(), file);
        else pictures.emplace(file.stem().string(), file);
    return pictures;
}

// Adds a case if the reference is there. If it is, even as a
// broken link, both files must be regular: throws Error otherwise.
void addCase(GradePlan& plan, const fs::path& scene, const PicturesByName& references,
             const std::string& name, const Stage& stage) {
    const auto found = references.find(name);
    if (found == references.end()) return;
    requireRegular(scene);
    requireRegular(found->second);
    plan.cases.push_back({name, scene.stem().string(), &stage, scene.string(), found->second.string()});
}

void planScene(GradePlan& plan, const fs::path& scene, const PicturesByName& references) {
    const std::size_t before = plan.cases.size();
    const std::string name = scene.stem().string();
    addCase(plan, scene, references, name, completeStage());
    for (const Stage& stage : stageTable)
        addCase(plan, scene, references, name + "-" + std::string(stage.name), stage);
    const bool isSchema = name.ends_with(".schema");
    if (plan.cases.size() == before && !isSchema)
        plan.scenesWithoutReference.push_back(scene.filename().string());
}

// "1.5 : 1": the film's width and height.
std::string filmInWords(const CameraDescription& camera) {
    constexpr int fine = 100'000;  // more digits than are shown
    const ImageSize size = imageSize(camera, fine);
    const double ratio = static_cast<double>(size.width) / size.height;
    return ratio < 1 ? formatted("1 : %.4g", 1 / ratio) : formatted("%.4g : 1", ratio);
}

// Throws Error if no picture of the scene can have the reference's size. One pixel more or less is another
// rounding.
void requireShape(const GradeCase& test, const CameraDescription& camera) {
    const auto size = sizeInHeader(FileBytes(test.reference, FileKind::Regular));
    if (!size) return;  // whoever reads it says what is wrong with it
    const ImageSize right = imageSize(camera, std::max(size->width, size->height));
    if (std::abs(right.width - size->width) <= 1 && std::abs(right.height - size->height) <= 1) return;
    throw Error({test.reference}, inWords(*size) + " pixels is not the shape of " +
                                      printable(fs::path(test.scene).filename().string()) + "'s film (" +
                                      filmInWords(camera) + ")");
}

// The longest name of a scene with which the name begins, up to its end or a "-"; empty if there is none.
std::string sceneOf(const std::string& name, const std::vector<fs::path>& scenes) {
    std::string longest;
    for (const fs::path& scene : scenes) {
        const std::string known = scene.stem().string();
        const bool isMeant = name == known || name.starts_with(known + "-");
        if (isMeant && known.size() > longest.size()) longest = known;
    }
    return longest;
}

// Why a picture is no reference, although its name begins with the scene's.
std::string whyStray(const std::string& name, const std::string& scene) {
    const std::string stage = name.substr(std::min(name.size(), scene.size() + 1));
    NearestName nearest(stage);
    for (const Stage& known : stageTable) nearest.consider(known.name);
    if (stage.empty() || nearest.name() == stage) return "it is no reference: expected " + name + ".png";
    return "no stage " + inQuotes(stage) +
           (nearest.found() ? didYouMean(scene + "-" + nearest.name() + ".png") : "; --help lists them");
}

std::vector<StrayPicture> strayPictures(const GradePlan& plan, const std::vector<fs::path>& scenes,
                                        const std::string& references) {
    std::vector<StrayPicture> strays;
    for (const fs::path& file : filesThatEndIn("", references)) {
        const std::string name = file.stem().string(), scene = sceneOf(name, scenes);
        const bool isGraded = std::ranges::find(plan.cases, name, &GradeCase::name) != plan.cases.end();
        if (isPicture(file.string()) && !scene.empty() && !isGraded)
            strays.push_back({file.string(), whyStray(name, scene)});
    }
    return strays;
}

std::array<std::uint8_t, 3> pixelOf(const ByteImage& image, const Comparison& c) {
    const std::uint8_t* pixel = image.at(c.worstX, c.worstY);
    return {pixel[0], pixel[1], pixel[2]};
}

// Throws Error if the file is larger than any picture of this size need be: that a file is too large for the
// memory is then no fault of it.
void requireFileFits(const std::string& picture, const ByteImage& reference) {
    constexpr std::uint64_t pixelBytes = 8;                        // with four channels of 16 bits
    constexpr std::uint64_t otherBytes = std::uint64_t{16} << 20;  // for profiles, texts and the like
    const std::uint64_t most = reference.pixels.size() / 3 * pixelBytes + otherBytes;
    std::error_code error;
    const std::uint64_t size = fs::file_size(picture, error);
    if (!error && size > most)
        throw Error({picture}, "the file is too large: " + std::to_string(size) + " bytes, at most " +
                                   std::to_string(most));
}

void requireSizeOf(const ReferencePicture& reference, const ImageSize& found) {
    const ImageSize& expected = reference.image;
    if (found != expected)
        throw Error("expected " + inWords(expected) + " pixels, as the reference has, found " +
                    inWords(found));
}

// Any Error here is the fault of the program's picture, but for OutOfMemory.
ByteImage readPicture(GradeResult& result, const ReferencePicture& reference, const std::string& picture) {
    requireFileFits(picture, reference.image);
    const FileBytes file(picture, FileKind::Regular);
    if (const auto size = sizeInHeader(file)) requireSizeOf(reference, *size);
    ByteImage ours = readImage(file);
    requireSizeOf(reference, ours);
    result.ourPng = file.text();
    return ours;
}

void comparePicture(GradeResult& result, const ReferencePicture& reference, const ByteImage& ours) {
    result.comparison = compareImages(ours, reference.image);
    result.ourWorst = pixelOf(ours, *result.comparison);
    result.referenceWorst = pixelOf(reference.image, *result.comparison);
    const std::vector<char> difference = encodePng(amplifiedDifference(ours, reference.image));
    result.differencePng.assign(difference.begin(), difference.end());
}

}  // namespace

std::span<const Stage> stages() { return stageTable; }

const Stage& completeStage() { return *std::prev(std::end(stageTable)); }

GradePlan planGrading(const std::string& scenes, const std::string& references) {
    GradePlan plan;
    const PicturesByName pictures = picturesIn(references);
    const std::vector<fs::path> sceneFiles = filesThatEndIn(".json", scenes);
    for (const fs::path& scene : sceneFiles) planScene(plan, scene, pictures);
    plan.strays = strayPictures(plan, sceneFiles, references);
    std::sort(plan.cases.begin(), plan.cases.end(),
              [](const GradeCase& a, const GradeCase& b) { return a.name < b.name; });
    std::sort(plan.scenesWithoutReference.begin(), plan.scenesWithoutReference.end());
    return plan;
}

std::vector<std::string> requireGradable(const GradePlan& plan) {
    std::vector<std::string> files;
    std::map<std::string, CameraDescription> cameras;  // by the scenes' paths
    for (const GradeCase& test : plan.cases) {
        files.push_back(test.reference);
        if (!cameras.contains(test.scene)) {
            LoadedScene loaded = loadScene(test.scene);
            std::ranges::move(loaded.files, std::back_inserter(files));
            cameras[test.scene] = loaded.description.camera;
        }
        requireShape(test, cameras[test.scene]);
    }
    return files;
}

ReferencePicture::ReferencePicture(const std::string& path) {
    const FileBytes file(path, FileKind::Regular);
    image = readImage(file);
    png = file.text();
}

NamedCase::NamedCase(const GradeCase& test, const ReferencePicture& reference, NamerMaker makeNamer)
    : test_(test), reference_(reference), makeNamer_(std::move(makeNamer)) {}

// Only if our own picture is the reference: mistakes are named by comparison with our picture, which says
// nothing about a reference of another light model.
void NamedCase::tryNamer() {
    constexpr double another = 0.002;  // share of the pixels: more than rounding changes
    if (std::exchange(isTried_, true) || !makeNamer_) return;
    namer_ = makeNamer_(test_, reference_.image);
    if (!namer_) return;
    const Comparison comparison = compareImages(namer_->right(), reference_.image);
    const auto pixels = static_cast<double>(comparison.width) * comparison.height;
    if (static_cast<double>(comparison.pixelsOver(1)) > another * pixels) namer_.reset();
}

void NamedCase::name(GradeResult& result, const ByteImage& picture) {
    tryNamer();
    if (!namer_) {
        result.unnamed = "no mistake looked for: the reference is not our picture";
        return;
    }
    const Diagnosis diagnosis = namer_->diagnose(picture);
    for (const NamedMistake& mistake : diagnosis.mistakes) result.mistakes.push_back(mistake.what);
    result.sentence = diagnosis.sentence();
    result.unnamed = diagnosis.unnamed;
}

void gradePicture(GradeResult& result, const ReferencePicture& reference, const std::string& picture,
                  NamedCase* named) {
    ByteImage ours;
    try {
        ours = readPicture(result, reference, picture);
    } catch (const OutOfMemory&) {
        throw;
    } catch (const Error& error) {
        result.message = error.inFile();
        result.isUnreadable = true;
        return;
    }
    comparePicture(result, reference, ours);
    if (named && result.comparison->pixelsOver(0) > 0) named->name(result, ours);
}

GradeResult gradeCase(const GradeCase& test, const CaseRenderer& render, const NamerMaker& makeNamer) {
    GradeResult result;
    result.test = test;
    const ReferencePicture reference(test.reference);
    result.referencePng = reference.png;
    const TemporaryFolder folder;
    const std::string out = folder.file("out.png");
    const int edge = std::max(reference.image.width, reference.image.height);
    Stopwatch watch;
    static_cast<Rendered&>(result) = render(test, edge, out);
    if (result.seconds == 0) result.seconds = watch.lap().wall;
    if (result.failed) return result;
    std::error_code isLocked;
    if (!fs::is_regular_file(out, isLocked)) {
        result.message += std::string(result.message.empty() ? "" : ", ") + "wrote no picture";
        return result;
    }
    NamedCase named(test, reference, makeNamer);
    gradePicture(result, reference, out, &named);
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
