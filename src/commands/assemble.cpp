// raytracer assemble PART... IMAGE_OUT: makes a picture from all its parts.
#include <string>
#include <vector>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/pictures/assemble.h"
#include "raytracer/pictures/picture_writer.h"
#include "raytracer/util/progress_bar.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/stopwatch.h"
#include "raytracer/util/text.h"
#include "render_report.h"

namespace raytracer::commands {

namespace {

constexpr const char* assembleFooter =
    R"(The picture has the bytes of one that was rendered at once. Nothing is written
unless all parts are there, whole, and of one picture: the same scene with its
meshes and textures, size, options and version of raytracer. All that is wrong
is named, a line for each fault.

Exit status: 0; 1 where --target-error was not reached, though the picture is
written; 2 where the parts are not all parts of one picture.

Examples:
  raytracer scene.json out.png 8000 --part 1/2
  raytracer scene.json out.png 8000 --part 2/2
  raytracer assemble out.png.part-* out.png)";

template <class Image>
void writeAll(const PartFiles& parts, PictureWriter<Image>& writer, bool quiet) {
    StepProgress progress(quiet, writer.bands().size());
    for (const PixelRectangle& band : writer.bands()) {
        writer.write(parts.read<Image>(band));
        progress.next();
    }
    writer.finish();
}

int assembleParts(const std::vector<std::string>& paths, const std::string& out, int threads, bool quiet) {
    const bool isPfm = endsIn(out, ".pfm");
    if (out.find(".part-") != out.npos && !isPfm && !endsIn(out, ".png"))  // a name made by partName
        throw UsageError("IMAGE_OUT is missing: " + printable(out) + " is the last part");
    if (!isPfm && !endsIn(out, ".png")) throw Error({out}, "expected a name that ends in .png or .pfm");
    refuseInput(out, paths);
    Stopwatch watch;
    OutputFile file(out);
    const PartFiles parts(paths, threads);
    for (const std::string& fault : parts.faults()) tell(fault);
    if (!parts.faults().empty()) return 2;
    const PartHead& head = parts.head();
    if (head.isFloat != isPfm)
        throw Error({out}, std::string("expected a name that ends in ") + (isPfm ? ".png" : ".pfm") +
                               ": the parts were rendered for that");
    requirePictureFits(out, head.crop, isPfm);
    if (isPfm) writeAll(parts, *pfmWriter(file, head.crop), quiet);
    else writeAll(parts, *pngWriter(file, head.crop, threads), quiet);
    tellDone(out, head.crop, watch.lap().wall, quiet);
    if (!head.isReached && !quiet) tell(out + ": --target-error is not reached");
    return head.isReached ? 0 : 1;
}

}  // namespace

int assemble(int argc, char** argv) {
    CommandLine line("assemble", "Makes a picture of all its parts, rendered with --part.");
    std::vector<std::string> paths;
    std::string out;
    int threads = 0;
    bool quiet = false;
    line.texts("PART", paths, "The files of all parts, in any order");
    line.text("IMAGE_OUT", out, "The picture, as it was named when its parts were rendered: .png or .pfm",
              ArgumentKind::Picture);
    addThreads(line, threads);
    line.flag("--quiet", quiet, "Print nothing but errors");
    line.footer(assembleFooter);
    if (line.parse(argc, argv)) return 0;
    return assembleParts(paths, out, threads, quiet);
}

}  // namespace raytracer::commands
