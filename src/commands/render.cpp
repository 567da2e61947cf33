// raytracer SCENE.json IMAGE_OUT LONG_EDGE_PIXELS: the picture of a scene.
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "arguments.h"
#include "raytracer/accuracy/ray_growth.h"
#include "raytracer/commands/commands.h"
#include "raytracer/explain/black_picture.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/util/output_file.h"
#include "raytracer/util/progress_bar.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/stopwatch.h"
#include "raytracer/util/text.h"
#include "render_arguments.h"
#include "target_error.h"

namespace raytracer::commands {

namespace {

constexpr const char* renderFooter = R"(The other commands:
  raytracer compare|grade|explain|tradeoff --help

The picture is written whole or not at all: as a new file, with the mode and the
owner of the file that it replaces. A symbolic link is followed. A hard link is
broken: the other names keep the old picture.

Exit status: 0; 1 where --target-error is not reached, though the picture is
written; 2 for a wrong command line, scene or place of the picture.

Examples:
  raytracer scenes/spheres_cylinder.json out.png 600
  # two terms of the light model
  raytracer scenes/stress_test.json out.png 600 --only ambient,diffuse
  # a stage picture
  raytracer scenes/cone_cube.json normals.png 600 --pass normals
  # a detail, as in the whole picture
  raytracer scenes/texture.json out.png 2000 --crop 500,500,700,700
  # the most accurate picture that takes about ten seconds
  raytracer scenes/texture.json out.png 2000 --target-time 10
  # linear float32, and what it cost
  raytracer scenes/refraction.json out.pfm 600 --stats
  raytracer scenes/texture.json - 300 | display)";

struct Timings {
    Seconds load, build, choose, render, write;
};

void printTimes(JsonWriter& json, const Timings& timings, const char* name, double Seconds::*kind) {
    json.key(name).beginObject();
    json.key("load").value(timings.load.*kind);
    json.key("build").value(timings.build.*kind);
    json.key("choose").value(timings.choose.*kind);
    json.key("render").value(timings.render.*kind);
    json.key("write").value(timings.write.*kind);
    json.endObject();
}

void printStats(const RenderCounts& counts, const Timings& timings, const RenderOptions& options) {
    JsonWriter json;
    json.beginObject();
    json.key("width").value(options.crop.width());
    json.key("height").value(options.crop.height());
    json.key("rays").beginObject();
    json.key("primary").value(counts.primary);
    json.key("shadow").value(counts.shadow);
    json.key("reflection").value(counts.reflection);
    json.key("refraction").value(counts.refraction);
    json.endObject();
    json.key("intersection_tests").value(counts.tests);
    json.key("limited_pixels").value(counts.limited);
    json.key("cutoff_bound").value(counts.cutoffBound);
    printTimes(json, timings, "seconds", &Seconds::wall);
    printTimes(json, timings, "cpu_seconds", &Seconds::cpu);
    json.key("peak_memory_bytes").value(peakMemoryBytes());
    json.endObject();
    print(json.text() + "\n");
}

// Where the limit on samples decided more than a few pixels.
void tellLimited(const RenderCounts& counts, const RenderOptions& options) {
    const auto limited = static_cast<double>(counts.limited);
    if (limited <= 0.001 * options.crop.area()) return;
    tell(formatted("--adaptive %s: --samples %d stopped %.3g %% of the pixels before",
                   shortNumber(options.adaptive).c_str(), options.samples,
                   100 * limited / options.crop.area()));
}

// What only this command asks for.
struct PictureArguments {
    std::string out;
    bool stats = false;
    std::optional<double> targetError, targetTime;
    std::string command;  // without --target-time

    bool isPfm() const { return endsIn(out, ".pfm"); }
};

// Before any work is done.
OutputFile openOutput(const PictureArguments& wanted) {
    if (wanted.out != "-") {
        if (!wanted.isPfm() && !endsIn(wanted.out, ".png"))
            throw Error({wanted.out}, "expected a name that ends in .png or .pfm");
        return {wanted.out};
    }
    if (wanted.stats) throw usageError("the picture - and --stats both go to standard output");
    if (printsOnTerminal()) throw usageError("the picture - is no text for a terminal: write - > out.png");
    return OutputFile::standardOutput();
}

// "out.png: 600 × 600, 0.06 s", for who waits at a terminal.
void tellDone(const std::string& out, const PixelRectangle& crop, const Timings& timings) {
    double seconds = 0;
    for (const Seconds* part :
         {&timings.load, &timings.build, &timings.choose, &timings.render, &timings.write})
        seconds += part->wall;
    tell(formatted("%s: %d × %d, %s s", out.c_str(), crop.width(), crop.height(),
                   shortNumber(seconds).c_str()));
}

struct Picture {
    const RenderArguments& arguments;
    const PictureArguments& wanted;
    const SceneDescription& scene;
    const Renderer& renderer;
    RenderOptions& options;
    Timings& timings;
    RenderCounts counts{};
    std::optional<TargetChoice> choice{};
};

RenderCounts renderInto(PixelSink& sink, const Picture& picture) {
    std::optional<ProgressBar> bar;
    if (!picture.arguments.quiet) bar.emplace();
    const bool hasFirst = picture.choice && !picture.choice->first.colors.empty();
    RenderCounts counts = picture.renderer.render(picture.options, sink, bar ? &*bar : nullptr,
                                                  hasFirst ? &picture.choice->first : nullptr);
    if (picture.choice) counts += picture.choice->counts;
    return counts;
}

template <class Sink, class Write>
void renderTo(Picture& picture, OutputFile& out, Write write) {
    Stopwatch watch;
    Sink sink(picture.options.crop);
    if (const auto target = picture.wanted.targetError)
        picture.choice = chooseAndTell(picture.renderer, picture.options, *target, picture.arguments.quiet);
    if (const auto seconds = picture.wanted.targetTime)
        picture.counts +=
            chooseForTimeAndTell(picture.renderer, picture.options,
                                 *seconds - picture.timings.load.wall - picture.timings.build.wall,
                                 picture.arguments.quiet ? "" : picture.wanted.command)
                .counts;
    picture.timings.choose = watch.lap();
    picture.counts += renderInto(sink, picture);
    picture.timings.render = watch.lap();
    if (picture.arguments.isWhole() && picture.arguments.warns() && isAllBlack(sink.image()))
        picture.arguments.warn(whyBlack(picture.scene, picture.renderer, picture.options));
    write(std::move(out), sink.image());
    picture.timings.write = watch.lap();
}

// A command line without an option and its value.
std::string without(const std::string& option, std::span<char*> words) {
    std::string line;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string word = words[i];
        if (word == option) ++i;
        else if (!word.starts_with(option + "=")) line += (line.empty() ? "" : " ") + word;
    }
    return line;
}

void warnOfExcess(const RenderArguments& arguments, const SceneDescription& scene, const Renderer& renderer,
                  const RenderOptions& options) {
    const auto rays = excessiveRays(scene, renderer, options);
    if (!rays) return;
    arguments.warn(
        formatted("--max-recursion %d takes about %.1g reflected and refracted rays a sample: they "
                  "double with each bounce where a material is both; a lower one takes fewer, or a --cutoff "
                  "where color_reflect and color_refract are less than 1",
                  options.max_recursion, *rays));
}

int renderPicture(const RenderArguments& arguments, const PictureArguments& wanted) {
    OutputFile out = openOutput(wanted);
    Timings timings;
    Stopwatch watch;
    SceneDescription description = arguments.load();
    timings.load = watch.lap();
    RenderOptions options = arguments.prepare(description);
    requirePictureFits(wanted.out, options.crop, wanted.isPfm());
    const auto renderer = arguments.makeRenderer(description);
    timings.build = watch.lap();
    if (!wanted.targetError && !wanted.targetTime && arguments.warns())
        warnOfExcess(arguments, description, *renderer, options);
    Picture picture{arguments, wanted, description, *renderer, options, timings};
    if (wanted.isPfm()) renderTo<FloatSink>(picture, out, writePfm);
    else
        renderTo<ByteSink>(picture, out, [&](OutputFile&& file, const ByteImage& image) {
            writePng(std::move(file), image, arguments.threads);
        });
    if (!arguments.quiet) tellLimited(picture.counts, options);
    if (wanted.stats) printStats(picture.counts, timings, options);
    if (!arguments.quiet && terminalColumns() > 0) tellDone(wanted.out, options.crop, timings);
    return picture.choice && !picture.choice->reached ? 1 : 0;
}

}  // namespace

int render(int argc, char** argv) {
    CommandLine line("raytracer", "Renders a scene to a picture.");
    RenderArguments arguments;
    PictureArguments wanted;
    arguments.addTo(line);
    line.text("IMAGE_OUT", wanted.out,
              "The picture: .png, .pfm (linear float32, not clamped), or - for a PNG on standard output",
              Looks::Picture);
    arguments.addLongEdgeTo(line);
    arguments.addPictureTo(line);
    line.number("--target-error", wanted.targetError, above(0),
                "Choose --samples, --adaptive, --max-recursion and --cutoff such that the error (RMSE, of 1, "
                "of linear "
                "colours) against samples and depth without end is at most this; rounding to a PNG's bytes "
                "adds 0.0011; "
                "exit status 1 where nothing is that accurate");
    line.number("--target-time", wanted.targetTime, above(0),
                "Choose the same options such that all takes about so many seconds on this machine");
    line.exclude("--target-error", {"--samples", "--adaptive", "--max-recursion", "--cutoff"});
    line.exclude("--target-time",
                 {"--samples", "--adaptive", "--max-recursion", "--cutoff", "--target-error"});
    line.flag("--stats", wanted.stats, "Print counts of rays and tests, times and memory, as JSON on stdout");
    line.footer(renderFooter);
    if (const auto status = line.parse(argc, argv)) return *status;
    arguments.check(line);
    wanted.command = without("--target-time", {argv, static_cast<std::size_t>(argc)});
    return renderPicture(arguments, wanted);
}

}  // namespace raytracer::commands
