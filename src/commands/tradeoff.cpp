// raytracer tradeoff SCENE...: measures what speed costs in accuracy.
#include <algorithm>
#include <filesystem>

#include "arguments.h"
#include "raytracer/accuracy/tradeoff_report.h"
#include "raytracer/commands/commands.h"
#include "raytracer/json/json_document.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/number.h"
#include "raytracer/util/output_file.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

constexpr const char* tradeoffFooter =
    R"(Renders each scene with many settings of --samples, --adaptive,
--max-recursion, --cutoff and --texture-filter, and in each precision. Compares
every picture with a converged one. Says which settings are worth their time:
the front, of which no other setting is both faster and more accurate.

Writes tradeoff.html (charts, tables, pictures; one file), tradeoff.svg (the
charts) and tradeoff.csv (every number) into the folder --out. Times are CPU
seconds of all threads together.

Exit status: 0, or 2 for a wrong command line or scene.

Examples:
  raytracer tradeoff scenes/refraction.json
  raytracer tradeoff scenes/*.json --out results --size 200 --repeats 5)";

struct TradeoffArguments {
    std::vector<std::string> scenes;
    std::string out = ".";
    TradeoffOptions options;
    bool quiet = false;

    void addTo(CommandLine& line) {
        line.texts("SCENE", scenes, "Scenes: JSON files", ArgumentKind::Scene);
        line.output("--out", out, "The folder to write to; made where there is none", ArgumentKind::Folder);
        line.number("--size", options.size, {16, 4096}, "Pixels along the longer side of the film");
        line.number("--samples", options.samples, {2, 256},
                    "The most samples of a pixel; the reference has four times as many");
        line.number("--repeats", options.repeats, {1, 1000},
                    "Timings of each setting near the front; the median counts");
        addThreads(line, options.threads);
        line.flag("--quiet", quiet, "Print nothing but the tables and errors");
        line.footer(tradeoffFooter);
    }
};

std::filesystem::path normal(const std::string& name) {
    return std::filesystem::path(name).lexically_normal();
}

// Throws UsageError for a picture or a size behind the scene, which other commands take there, and for a
// scene that is there twice.
void requireScenes(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (std::ranges::count(names, normal(name), normal) > 1)
            throw UsageError("expected each scene once, found " + inQuotes(name) + " twice");
        std::string remedy;
        std::error_code error;
        if (numberOf<int>(name) && !std::filesystem::exists(name, error)) remedy = "write --size " + name;
        if (isPictureName(name)) remedy = "--out names a folder";
        if (remedy.empty()) continue;
        throw UsageError(inQuotes(name) + " is no scene: tradeoff takes scenes alone; " + remedy);
    }
}

bool areDistinct(std::vector<std::string> names) {
    std::ranges::sort(names);
    return std::ranges::adjacent_find(names) == names.end();
}

// The names of the scenes' files, without their endings; or as much of the paths as tells the scenes apart.
std::vector<std::string> namesOf(const std::vector<std::string>& scenes) {
    std::vector<std::string> names;
    std::vector<std::filesystem::path> folders, ends;  // each path, in two parts
    for (const std::string& scene : scenes) {
        const std::filesystem::path path = normal(scene);
        names.push_back(path.stem().string());
        folders.push_back(path.parent_path());
        ends.push_back(path.filename());
    }
    while (!areDistinct(names))
        for (std::size_t i = 0; i < names.size(); ++i) {
            names[i] = ends[i].generic_string();
            ends[i] = (folders[i].has_filename() ? folders[i].filename() : folders[i]) / ends[i];
            folders[i] = folders[i].parent_path();
        }
    return names;
}

void makeFolder(const std::string& out) {
    std::error_code error;
    for (const char* const file : {".html", ".svg", ".csv"})
        if (endsIn(out, file) && !std::filesystem::is_directory(out, error))
            throw Error({out}, "--out names a folder, for three files");
    std::filesystem::create_directories(out, error);
    if (error) throw Error({out}, "cannot make the folder: " + error.message());
}

void requirePicturesFit(const std::string& scene, const ImageSize& size) {
    // Three pictures of doubles, and some of bytes that the page shows, as such and as base64.
    constexpr double bytesOfPixel = 110;
    requireMemory(scene, "pictures of " + pixelsInWords(size.width, size.height),
                  bytesOfPixel * size.width * size.height);
}

int measure(TradeoffArguments& arguments) {
    const std::vector<std::string> names = namesOf(arguments.scenes);
    if (!arguments.quiet) arguments.options.report = [](const std::string& what) { tell(what + " ..."); };
    std::vector<LoadedScene> loaded;  // all are loaded first, since the work may take an hour
    for (const std::string& scene : arguments.scenes) {
        loaded.push_back(loadScene(scene, {}, nullptr, FileKind::Any, arguments.options.threads));
        requirePicturesFit(scene, imageSize(loaded.back().description.camera, arguments.options.size));
    }
    print("");
    makeFolder(arguments.out);
    const auto inFolder = [out = std::filesystem::path(arguments.out)](const char* name) {
        return (out / name).string();
    };
    OutputFile csv(inFolder("tradeoff.csv")), svg(inFolder("tradeoff.svg")), page(inFolder("tradeoff.html"));
    std::vector<SceneTradeoff> scenes;
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        scenes.push_back(measureTradeoff(names[i], loaded[i].description, arguments.options));
        print(tradeoffTable(scenes.back()) + "\n");
    }
    csv.append(tradeoffCsv(scenes));
    svg.append(tradeoffSvg(scenes));
    page.append(tradeoffPage(scenes));
    // Last, so that no file is left if the disk is full: then append() has thrown.
    for (OutputFile* const file : {&csv, &svg, &page}) file->finish();
    print("wrote " + printable(page.name()) + ", .svg and .csv\n");
    return 0;
}

}  // namespace

int tradeoff(int argc, char** argv) {
    CommandLine line("tradeoff", "Measures what speed costs in accuracy.");
    TradeoffArguments arguments;
    arguments.addTo(line);
    if (line.parse(argc, argv)) return 0;
    requireScenes(arguments.scenes);
    return measure(arguments);
}

}  // namespace raytracer::commands
