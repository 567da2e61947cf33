// raytracer explain SCENE X Y LONG_EDGE_PIXELS: shows the rays behind one pixel; with --picture, tells what
// is wrong with that picture.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/explain/explanation_text.h"
#include "raytracer/explain/scene_advice.h"
#include "raytracer/grading/compare.h"
#include "raytracer/grading/diagnosis.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"
#include "render_arguments.h"

namespace raytracer::commands {

namespace {

constexpr const char* explainFooter =
    R"(Prints what a pixel's colour is made of in one sentence, then its ray tree in
the symbols of the assignment:
  K_R I_R + K_T I_T
    + sum over lights (K_A I_AL + [K_D I_L (N.L) + K_S I_L (V.R)^n] S_L)
Options that change the picture change the explanation too.

With --picture, the picture is held against those that known mistakes make of
the scene. A mistake is named where it explains at least 99 % of the wrong
pixels; of specks, 90 %. Fewer than 24 wrong pixels tell none.

Exit status: 0; 1 where the picture is not right; 2 for a wrong command line,
scene or picture.

Examples:
  raytracer explain scenes/refraction.json --picture mine.png
  raytracer explain scenes/spheres_cylinder.json 300 200 600
  raytracer explain scenes/refraction.json 300 200 600 --max-recursion 1
  raytracer explain scenes/texture.json 10 590 600 --json)";

struct ExplainArguments {
    RenderArguments render;
    std::optional<int> x, y, longEdge;
    std::string picture;
    int depth = 1000;
    bool json = false;

    void addTo(CommandLine& line) {
        render.addTo(line);
        line.number("X", x, {}, "The pixel's column; 0 is the left one");
        line.number("Y", y, {}, "The pixel's row; 0 is the top one");
        line.number("LONG_EDGE_PIXELS", longEdge, longEdgeRange, "Pixels along the longer side of the film");
        line.text(
            "--picture", picture,
            "Say what is wrong with this picture of SCENE, and explain its worst pixel: then no X, Y and "
            "LONG_EDGE_PIXELS, or those of another pixel");
        line.shown("--picture", "PICTURE", "a picture");
        line.number("--depth", depth, {0, 1000}, "Print rays up to so many reflections and refractions");
        line.flag("--json", json, "Print the rays as JSON");
        line.footer(explainFooter);
    }
};

void requirePixel(const ImageSize& size, const PixelPlace& pixel) {
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height)
        throw UsageError(formatted("expected X from 0 to %d and Y from 0 to %d, found %d and %d",
                                   size.width - 1, size.height - 1, pixel.x, pixel.y));
}

// A picture of the scene that is to be checked, the right one, and how they differ.
struct Suspect {
    ByteImage image, right;
    Diagnosis diagnosis;
    Comparison comparison;
};

Suspect examine(const Picture& picture, const std::string& name, const SceneDescription& whole,
                const RenderOptions& options, const RenderArguments& render) {
    const ImageSize size = sizeOf(picture);
    if (size != options.size)
        throw Error({name},
                    "expected a picture of the scene, " + inWords(options.size) + ", found " + inWords(size));
    const MistakeNamer namer(whole, options, render.terms(), render.chosenPrecision());
    ByteImage image = toBytes(picture, namer.right());
    Diagnosis diagnosis = namer.diagnose(image);
    const Comparison comparison = compareImages(image, namer.right());
    return {std::move(image), namer.right(), std::move(diagnosis), comparison};
}

bool isRight(const Diagnosis& diagnosis) { return diagnosis.wrong == 0 || diagnosis.isRounding; }

std::string verdict(const Suspect& suspect) {
    const Diagnosis& found = suspect.diagnosis;
    if (found.wrong == 0) return "equals the right picture";
    if (found.isRounding)
        return "equals the right picture but for rounding (" + std::to_string(found.wrong) + " of " +
               std::to_string(found.pixels) + " pixels by 1)";
    if (!found.mistakes.empty()) return found.sentence();
    return "differs from the right picture in " + std::to_string(found.wrong) + " of " +
           std::to_string(found.pixels) + " pixels: " + found.unnamed;
}

// Wraps a text to the width of a message.
std::string inLines(const std::string& begin, const std::string& text) {
    constexpr std::size_t indent = 2;
    return begin + wrapped(text, messageColumns, indent, columnCount(begin)) + "\n";
}

void printSuspect(const Suspect& suspect, const std::string& name, const PixelPlace& pixel,
                  const std::vector<std::string>& missing) {
    print(inLines(name + " ", verdict(suspect)));
    for (const std::string& hint : suspect.diagnosis.hints()) print(inLines("  ", hint));
    print(formatted("pixel (%d, %d): ", pixel.x, pixel.y) + rgbInWords(suspect.image.at(pixel.x, pixel.y)) +
          " in " + name + ", " + rgbInWords(suspect.right.at(pixel.x, pixel.y)) + " is right\n");
    const std::string asIn = " it would be as in " + name + "\n";
    for (const std::string& term : missing) print(("without " + term).append(asIn));
}

void writeSuspect(JsonWriter& json, const Suspect& suspect, const PixelPlace& pixel,
                  const std::vector<std::string>& missing) {
    json.key("verdict").value(verdict(suspect));
    json.key("mistakes").array(suspect.diagnosis.mistakes, [&](const NamedMistake& mistake) {
        json.beginObject();
        json.key("what").value(mistake.what).key("explained").value(mistake.explained);
        json.endObject();
    });
    json.key("pixel").values(std::array{pixel.x, pixel.y});
    json.key("theirs").values(std::span(suspect.image.at(pixel.x, pixel.y), 3));
    json.key("without").values(missing);
}

void printRays(const RayExplanation& tree, const SceneDescription& scene, const ExplainArguments& arguments,
               const std::function<void(JsonWriter&)>& before = {}) {
    if (arguments.json) print(explanationJson(tree, scene, before));
    else print(inLines("", explanationSentence(tree, scene)) + explanationText(tree, scene, arguments.depth));
}

int explainSuspect(ExplainArguments& arguments) {
    RenderArguments& render = arguments.render;
    const std::string& name = arguments.picture;
    const Picture picture = readPicture(name);
    const ImageSize size = sizeOf(picture);
    SceneDescription scene = render.load();
    render.longEdge = arguments.longEdge.value_or(std::max(size.width, size.height));
    SceneDescription whole = copyOf(scene);
    if (render.opaque) makeOpaque(whole);
    const RenderOptions options = render.prepare(scene);
    const Suspect suspect = examine(picture, name, whole, options, render);
    const PixelPlace pixel = arguments.x ? PixelPlace{*arguments.x, *arguments.y}
                                         : PixelPlace{suspect.comparison.worstX, suspect.comparison.worstY};
    requirePixel(options.size, pixel);
    const RayExplanation tree = render.makeRenderer(scene)->explain(options, pixel.x, pixel.y);
    const auto missing = missingTerms(tree, suspect.image.at(pixel.x, pixel.y));
    const auto addSuspect = [&](JsonWriter& json) { writeSuspect(json, suspect, pixel, missing); };
    if (!arguments.json) printSuspect(suspect, printable(name), pixel, missing);
    printRays(tree, scene, arguments, addSuspect);
    return isRight(suspect.diagnosis) ? 0 : 1;
}

int explainPixel(ExplainArguments& arguments) {
    RenderArguments& render = arguments.render;
    render.longEdge = *arguments.longEdge;
    const PixelPlace pixel{*arguments.x, *arguments.y};
    SceneDescription scene = render.load();
    if (!render.quiet)
        for (const Error& remark : remarksOn(render.scene, sceneNotes(scene), render.sets))
            tell(std::string("note: ") + remark.what());
    const RenderOptions options = render.prepare(scene);
    requirePixel(options.size, pixel);
    const RayExplanation tree = render.makeRenderer(scene)->explain(options, pixel.x, pixel.y);
    printRays(tree, scene, arguments);
    return 0;
}

}  // namespace

int explain(int argc, char** argv) {
    CommandLine line("explain", "Shows the rays behind one pixel.");
    ExplainArguments arguments;
    arguments.addTo(line);
    line.spares("--picture", {"X", "Y", "LONG_EDGE_PIXELS"});
    line.lacks({"--pass", "--samples", "--adaptive", "--crop"},
               "explain follows the one ray through the pixel's centre");
    if (line.parse(argc, argv)) return 0;
    RenderArguments& render = arguments.render;
    render.check(line);
    int status = 0;
    onTracingThreads(1, 1, render.options.max_recursion, [&](JobQueue& queue) {
        for (std::uint32_t job; queue.next(job);)
            status = arguments.picture.empty() ? explainPixel(arguments) : explainSuspect(arguments);
    });
    return status;
}

}  // namespace raytracer::commands
