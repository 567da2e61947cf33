// raytracer SCENE.json IMAGE_OUT LONG_EDGE_PIXELS: renders a scene to a picture.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/explain/black_picture.h"
#include "raytracer/pictures/picture.h"
#include "raytracer/pictures/picture_writer.h"
#include "raytracer/util/file_watch.h"
#include "raytracer/util/output_file.h"
#include "raytracer/util/progress_bar.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"
#include "render_arguments.h"
#include "render_report.h"
#include "series.h"

namespace raytracer::commands {

namespace {

constexpr const char* renderFooter = R"(The other commands:
  raytracer assemble|compare|grade|explain|tradeoff --help

The picture is written whole or not at all: as a new file, with the mode, the
owner and the access list of the file that it replaces. A symbolic link is
followed. A hard link is broken: the other names keep the old picture.

Exit status: 0; 1 where --target-error is not reached, though the picture is
written (of the parts of a picture, only assemble ends with 1); 2 for a wrong
command line, scene or place of the picture.

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
  # the picture follows the file that is edited
  raytracer scene.json out.png 300 --watch
  # linear float32, and what it cost
  raytracer scenes/refraction.json out.pfm 600 --stats
  raytracer scenes/texture.json - 300 | display
  # eight frames of a light that moves from left to right
  raytracer scene.json film-%04d.png 600 --frames 1..8 \
    --set "/lights/0/position=[{-5..5},4,3]"
  # half of it here, the other half (2/2) on another machine
  raytracer scenes/texture.json out.png 8000 --part 1/2)";

// The options that only this command has.
struct PictureArguments {
    std::string out;
    bool stats = false, watch = false, skipExisting = false;
    std::optional<double> targetError, targetTime;
    std::string part;                    // K/N; empty: the whole picture
    std::string frames;                  // A..B; empty: one picture
    std::string again;                   // the command line without --target-time
    const FileWatch* watched = nullptr;  // with --watch

    bool isPfm() const { return endsIn(out, ".pfm"); }
    bool isPart() const { return !part.empty(); }
    std::string file() const { return isPart() ? partName(out, parsePart(part)) : out; }
};

// Opens the output before any work is done.
OutputFile openOutput(const PictureArguments& wanted) {
    if (wanted.out != "-") {
        if (!wanted.isPfm() && !endsIn(wanted.out, ".png"))
            throw Error({wanted.out}, "expected a name that ends in .png or .pfm");
        return {wanted.file()};
    }
    if (wanted.isPart()) throw UsageError("the picture - goes to standard output, and --part to a file");
    if (wanted.stats)
        throw UsageError("the picture - and --stats both go to standard output: name a file for the picture");
    if (printsOnTerminal()) throw UsageError("the picture - is no text for a terminal: write - > out.png");
    return OutputFile::standardOutput();
}

// The rendering of one picture, from its scene to its file.
struct RenderJob {
    const RenderArguments& arguments;
    const PictureArguments& wanted;
    const SceneDescription& scene;
    const Renderer& renderer;
    RenderOptions& options;
    Timings& timings;
    PartHead part{};
    RenderCounts counts{};
    std::optional<TargetChoice> choice{};
    bool isBlack = true;  // whether all pixels so far are black
};

void renderBand(PixelSink& sink, RenderJob& job, const PixelRectangle& band, StepProgress& progress) {
    RenderOptions options = job.options;
    options.crop = band;
    const bool hasFirst = job.choice && !job.choice->first.colors.empty();
    WatchedProgress watched(progress, job.wanted.watched);
    job.counts += job.renderer.render(options, sink, &watched, hasFirst ? &job.choice->first : nullptr);
    progress.next();
}

void warnOfBlack(const RenderJob& job) {
    if (!job.isBlack || job.wanted.isPart() || !job.arguments.isWhole() || !job.arguments.warns()) return;
    job.arguments.warn(whyBlack(job.scene, job.renderer, job.options));
}

template <class Sink, class Image>
void renderTo(RenderJob& job, OutputFile& file, std::unique_ptr<PictureWriter<Image>> writer) {
    if (job.wanted.isPart()) writer = partWriter<Image>(file, job.part);
    Stopwatch watch;
    StepProgress progress(job.arguments.quiet, writer->bands().size());
    for (const PixelRectangle& band : writer->bands()) {
        Sink sink(band);
        renderBand(sink, job, band, progress);
        job.timings.render += watch.lap();
        job.isBlack = job.isBlack && isAllBlack(sink.image());
        if (&band == &writer->bands().back()) warnOfBlack(job);
        writer->write(sink.image());
        job.timings.write += watch.lap();
    }
    writer->finish();
    job.timings.write += watch.lap();
}

void choose(RenderJob& job) {
    Stopwatch watch;
    if (const auto target = job.wanted.targetError)
        job.choice = chooseAndTell(job.arguments, job.renderer, job.options, *target);
    if (const auto seconds = job.wanted.targetTime)
        job.counts +=
            chooseForTimeAndTell(job.arguments, job.renderer, job.options,
                                 *seconds - job.timings.load.wall - job.timings.build.wall, job.wanted.again)
                .counts;
    if (job.choice) job.counts += job.choice->counts;
    job.timings.choose = watch.lap();
}

// Returns the exit status.
int tellSkipped(const RenderArguments& arguments, const PictureArguments& wanted) {
    if (!arguments.quiet) tell(wanted.file() + ": skipped, it is there");
    return 0;
}

int renderPicture(const RenderArguments& arguments, const PictureArguments& wanted,
                  std::vector<std::string>& files) {
    OutputFile out = openOutput(wanted);
    if (wanted.stats) print("");
    Timings timings;
    Stopwatch watch;
    SceneDescription description = arguments.load(&files, wanted.watch ? FileKind::Regular : FileKind::Any);
    refuseInput(wanted.file(), files);
    timings.load = watch.lap();
    RenderOptions options = arguments.prepare(description);
    if (wanted.skipExisting && !wanted.isPart() && isNewPicture(wanted.out, options.crop, files))
        return tellSkipped(arguments, wanted);
    requirePictureFits(wanted.out, options.crop, wanted.isPfm());
    const auto renderer = arguments.makeRenderer(description);
    timings.build = watch.lap();
    if (!wanted.targetError && !wanted.targetTime) remarkOnRays(arguments, description, *renderer, options);
    RenderJob job{arguments, wanted, description, *renderer, options, timings};
    if (wanted.isPart()) job.part = partHead(arguments, options, parsePart(wanted.part), files);
    choose(job);
    if (wanted.isPart()) {
        job.part.options = pictureOptions(arguments, options);
        job.part.isFloat = wanted.isPfm();
        job.part.isReached = !job.choice || job.choice->reached;
        if (wanted.skipExisting && isPart(wanted.file(), job.part)) return tellSkipped(arguments, wanted);
    }
    options.part = job.part.part;
    if (!wanted.targetTime) remarkOnTime(arguments, *renderer, options);
    if (wanted.isPfm()) renderTo<FloatSink>(job, out, pfmWriter(out, options.crop));
    else renderTo<ByteSink>(job, out, pngWriter(out, options.crop, options.threads));
    tellLimited(job.counts, options, options.crop.area() / options.part.count, arguments.quiet || job.choice);
    if (wanted.stats) printStats(job.counts, timings, options);
    tellDone(wanted.file(), options.crop, timings.wall(), arguments.quiet);
    return job.choice && !job.choice->reached && !wanted.isPart() ? 1 : 0;  // of parts, assemble reports it
}

// Renders again whenever a file has changed. After an error, waits for a change that may mend it.
[[noreturn]] void watchScene(const RenderArguments& arguments, PictureArguments wanted) {
    std::vector<std::string> files{arguments.scene};
    openOutput(wanted);  // throws errors that no change of the scene can mend
    for (bool isFirst = true;;) {
        const auto start = FileWatch::Time::clock::now();
        FileWatch watch;
        for (const std::string& file : files) watch.add(file);
        wanted.watched = &watch;
        try {
            renderPicture(arguments, wanted, files);
        } catch (const OutOfDate&) {  // wait() returns at once
        } catch (const UsageError& error) {
            tell(Error({"raytracer"}, error.what()));
        } catch (const Error& error) {
            tell(error);
        }
        for (const std::string& file : files) watch.add(file, start);
        if (std::exchange(isFirst, false)) tellWaiting(arguments.quiet);
        watch.wait();
    }
}

// Renders each frame with its own values of --set and its own name. Returns the worst exit status.
int renderFrames(const RenderArguments& arguments, const PictureArguments& wanted) {
    const Frames frames = parseFrames(wanted.frames);
    int status = 0;
    std::vector<std::string> files;
    Stopwatch watch;
    for (int frame = frames.first; frame <= frames.last; ++frame) {
        RenderArguments inFrame = arguments;
        for (std::string& set : inFrame.sets) set = atFrame(set, frames, frame);
        PictureArguments picture = wanted;
        picture.out = frameName(wanted.out, frame);
        status = std::max(status, renderPicture(inFrame, picture, files));
        if (frame == frames.first) remarkOnFrames(arguments, frames.last - frames.first, watch.lap().wall);
    }
    return status;
}

void addTargetsTo(CommandLine& line, PictureArguments& wanted) {
    line.number(
        "--target-error", wanted.targetError, atLeast(1e-9),
        "Choose options for this error: --samples, --adaptive, --max-recursion, --cutoff such that "
        "the RMSE (of 1, of linear colours) against samples and depth without end is at most this; "
        "rounding to a PNG's bytes adds 0.0011; exit status 1 where nothing is that accurate (of parts, that "
        "of assemble)");
    line.number(
        "--target-time", wanted.targetTime, above(0),
        "Choose the same options such that the whole run takes about this many seconds on this machine");
    line.exclude("--target-error", {"--samples", "--adaptive", "--max-recursion", "--cutoff"});
    line.exclude("--target-time",
                 {"--samples", "--adaptive", "--max-recursion", "--cutoff", "--target-error"});
}

void addTo(CommandLine& line, RenderArguments& arguments, PictureArguments& wanted) {
    arguments.addTo(line);
    line.text("IMAGE_OUT", wanted.out,
              "The picture: .png, .pfm (linear float32, not clamped), or - for a PNG on standard output",
              ArgumentKind::Picture);
    arguments.addLongEdgeTo(line);
    arguments.addPictureTo(line);
    addTargetsTo(line, wanted);
    addPartsAndFramesTo(line, wanted.part, wanted.frames);
    line.flag(
        "--skip-existing", wanted.skipExisting,
        "Keep what is there: a picture that is whole, of this size, and newer than the scene and all files "
        "that it names (of other options nothing is known); and a part that is whole and right");
    line.flag("--stats", wanted.stats,
              "Print the setting, counts of rays and tests, times and memory, as JSON on stdout; an object "
              "for each frame");
    line.flag("--watch", wanted.watch,
              "Render again whenever the scene or a file that it names changes; Ctrl+C ends");
    line.alone("--print-schema", "Print the JSON schema of scenes, for editors");
    line.alone("--print-manual", "Print the man page");
    line.alone("--print-completion", "Print the completion script for bash, zsh or fish",
               {std::begin(shells), std::end(shells)});
    line.answers(comparisonMeant);
    line.exclude("--watch", {"--frames", "--part", "--skip-existing"});
    line.exclude("--frames", {"--target-time"});
    line.exclude("--skip-existing", {"--stats"});
    line.footer(renderFooter);
}

void check(const CommandLine& line, const RenderArguments& arguments, const PictureArguments& wanted) {
    arguments.check(line);
    refuseNearRanges(arguments.sets, !wanted.frames.empty());
    if (wanted.isPart()) parsePart(wanted.part);
    if (wanted.skipExisting && wanted.out == "-")
        throw UsageError("--skip-existing has no effect with the picture -");
    if (wanted.frames.empty()) refuseFrames(wanted.out, arguments.sets);
    if (wanted.watch && wanted.out == "-")
        throw UsageError("--watch has no effect with the picture -: write to a file");
}

}  // namespace

int render(int argc, char** argv) {
    CommandLine line("", "Renders a scene to a picture.");
    RenderArguments arguments;
    PictureArguments wanted;
    addTo(line, arguments, wanted);
    if (line.parse(argc, argv)) return 0;
    check(line, arguments, wanted);
    wanted.again = line.again({"--target-time", "--skip-existing", "--watch", "--stats"});
    if (!wanted.frames.empty()) return renderFrames(arguments, wanted);
    if (wanted.watch) watchScene(arguments, wanted);
    std::vector<std::string> files;
    return renderPicture(arguments, wanted, files);
}

}  // namespace raytracer::commands
