// raytracer tradeoff SCENE...: what speed costs in accuracy, measured.
#include <array>
#include <cstdio>
#include <filesystem>

#include "arguments.h"
#include "raytracer/accuracy/tradeoff_report.h"
#include "raytracer/commands/commands.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/file_bytes.h"

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

Examples:
  raytracer tradeoff scenes/refraction.json
  raytracer tradeoff scenes/*.json --out results --size 200 --repeats 5)";

struct TradeoffArguments {
    std::vector<std::string> scenes;
    std::string out = ".";
    TradeoffOptions options;
    bool quiet = false;

    void addTo(CommandLine& line) {
        line.texts("SCENE", scenes, "Scenes: JSON files");
        line.text("--out", out, "The folder to write to; made where there is none");
        line.number("--size", options.size, {16, 4096}, "Pixels along the longer side of the film");
        line.number("--samples", options.samples, {2, 256},
                    "The most samples of a pixel; the reference has four times as many");
        line.number("--repeats", options.repeats, {1, 1000},
                    "Timings of each setting near the front; the median counts");
        addThreads(line, options.threads);
        line.flag("--quiet", quiet, "No progress on stderr");
        line.footer(tradeoffFooter);
    }
};

void write(const std::filesystem::path& path, const std::string& text) {
    const std::span<const char> whole = text;
    writeFile(path.string(), {&whole, 1});
}

int measure(TradeoffArguments& arguments) {
    if (!arguments.quiet)
        arguments.options.report = [](const std::string& what) {
            std::fprintf(stderr, "%s ...\n", what.c_str());
        };
    std::vector<LoadedScene> loaded;  // all first: a mistake in the last is told before an hour of work
    for (const std::string& scene : arguments.scenes) loaded.push_back(loadScene(scene, false));
    std::filesystem::create_directories(arguments.out);
    std::vector<SceneTradeoff> scenes;
    for (std::size_t i = 0; i < loaded.size(); ++i) {
        const std::string name = std::filesystem::path(arguments.scenes[i]).stem().string();
        scenes.push_back(measureTradeoff(name, loaded[i].description, arguments.options));
        std::printf("%s\n", tradeoffTable(scenes.back()).c_str());
        std::fflush(stdout);
    }
    const std::filesystem::path out = arguments.out;
    write(out / "tradeoff.csv", tradeoffCsv(scenes));
    write(out / "tradeoff.svg", tradeoffSvg(scenes));
    write(out / "tradeoff.html", tradeoffPage(scenes));
    std::printf("wrote %s, .svg and .csv\n", (out / "tradeoff.html").c_str());
    return 0;
}

}  // namespace

int tradeoff(int argc, char** argv) {
    CommandLine line("raytracer tradeoff", "Measures what speed costs in accuracy.");
    TradeoffArguments arguments;
    arguments.addTo(line);
    if (const auto status = line.parse(argc, argv)) return *status;
    return measure(arguments);
}

}  // namespace raytracer::commands
