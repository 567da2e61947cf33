#include "render_arguments.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "arguments.h"
#include "raytracer/explain/scene_advice.h"
#include "raytracer/json/json_document.h"
#include "raytracer/json/json_edit.h"
#include "raytracer/scene/scene_loader.h"
#include "raytracer/tracer/term_names.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/number.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"
#include "split_values.h"

namespace raytracer::commands {

namespace {

// The parts of a comma-separated list, without the blanks around them.
std::vector<std::string> listParts(const std::string& list) {
    std::vector<std::string> parts = split(list, ",");
    for (std::string& part : parts) {
        part.erase(part.find_last_not_of(' ') + 1);
        part.erase(0, part.find_first_not_of(' '));
    }
    return parts;
}

// The pass whose name begins with `name`, of at least six letters; empty if there is none.
std::string passMeant(const std::string& name) {
    constexpr std::size_t least = 6;  // letters: "normal"
    if (name.size() < least) return {};
    if (std::string_view("normals").starts_with(name)) return "normals";
    return std::string_view("raycasting").starts_with(name) ? "raycast" : "";
}

// The term, with "diffuse" before it if it is dark by itself.
std::string visibly(const std::string& term) { return isDark(termsNamed(term)) ? "diffuse," + term : term; }

// "ambient,diffuse" for "ambient_diffuse", a stage's name; empty for any other name.
std::string termsOfStage(const std::string& name) {
    std::string terms = name;
    std::ranges::replace(terms, '_', ',');
    return terms != name && std::ranges::all_of(listParts(terms), isTerm) ? terms : "";
}

bool Terms::*termNamed(const std::string& name) {
    NearestName nearest(name);
    for (const TermName& known : termNames) {
        if (name == known.name) return known.term;
        nearest.consider(known.name);
    }
    if (const std::string pass = passMeant(name); !pass.empty())
        throw UsageError("--only: no term " + inQuotes(name) + "; write --pass " + pass);
    if (const std::string terms = termsOfStage(name); !terms.empty())
        throw UsageError("--only has commas, no underscores: write --only " + terms);
    if (name == "all") throw UsageError("--only: no term \"all\"; without --only there are all");
    if (name.find_first_of(" ;+|/") != name.npos)
        throw UsageError("--only: expected commas between the terms, found " + inQuotes(name));
    throw UsageError("--only: no term " + inQuotes(name) +
                     (nearest.found() ? nearest.question() : "; --help lists them"));
}

// A coordinate. One that does not fit into int becomes the
// largest or smallest int, which is outside of any picture too.
std::optional<int> edgeIn(const std::string& text) {
    using Limits = std::numeric_limits<int>;
    const std::optional<int> edge = numberOf<int>(text);
    if (edge || !isWholeNumber(text)) return edge;
    return text[0] == '-' ? Limits::min() : Limits::max();
}

PixelRectangle parseCrop(const std::string& text) {
    std::vector<std::optional<int>> numbers;
    for (const std::string& part : listParts(text)) numbers.push_back(edgeIn(part));
    if (numbers.size() != 4 || std::ranges::count(numbers, std::optional<int>()) > 0)
        throw UsageError("--crop: expected four whole numbers x0,y0,x1,y1, found " + inQuotes(text));
    const PixelRectangle crop{*numbers[0], *numbers[1], *numbers[2], *numbers[3]};
    if (crop.x0 >= crop.x1 || crop.y0 >= crop.y1)
        throw UsageError("--crop: expected x0,y0,x1,y1 with x0 < x1 and y0 < y1, found " + inQuotes(text));
    return crop;
}

PixelRectangle cropOf(const std::string& text, const ImageSize& size) {
    const PixelRectangle crop = parseCrop(text);
    if (crop.x0 < 0 || crop.y0 < 0 || crop.x1 > size.width || crop.y1 > size.height)
        throw UsageError("--crop: expected a rectangle inside of the " + inWords(size) + " picture, found " +
                         inQuotes(text));
    return crop;
}

}  // namespace

void RenderArguments::addTo(CommandLine& line) {
    line.text("SCENE", scene, "The scene: a JSON file", ArgumentKind::Scene);
    line.texts(
        "--set", sets,
        "Change or add a value in the scene before it is read: /camera/eye=[0,1,5], a JSON pointer and JSON; "
        "'/lights/-={...}', in quotes, adds a light; may be repeated");
    line.shown("--set", "/pointer=value");
    line.rejoins("--set", joinedEdit);
    line.number("--max-recursion", options.max_recursion, {0, mostRecursion},
                "How many times a ray is reflected or refracted");
    std::vector<std::string> terms;
    for (const TermName& known : termNames) terms.emplace_back(known.name);
    line.names("--only", only, terms,
               "Render only these terms, comma-separated: ambient, diffuse, specular, shadows, reflections, "
               "refraction, textures");
    line.shown("--only", "LIST", "terms, as ambient,diffuse");
    line.rejoins("--only", rejoinedList({"has commas, no blanks", ", ", ",", 2, terms.size(), isTerm}));
    line.flag("--opaque", opaque, "Read every material as not refractive");
    line.choice("--precision", precision, {std::begin(precisionNames), std::end(precisionNames)},
                "Arithmetic: float, double or extended (long double)");
    line.number("--cutoff", options.cutoff, atLeast(0),
                "Do not cast a ray that changes its pixel by less than this, of 1");
    line.choice("--texture-filter", textureFilter, {"nearest", "bilinear"},
                "Texture look-up: nearest or bilinear");
    addThreads(line, options.threads);
    line.choice("--accelerator", accelerator, {"bvh", "none"},
                "How rays find shapes: bvh, or none to test them all (the picture is the same)");
    line.flag("--strict", strict, "Warnings about the scene are errors");
    line.flag("--quiet", quiet, "Print no warnings, notes and progress: only errors, and what is asked for");
    line.lacks({"--gamma"}, "a byte is 255 times the linear colour; a .pfm has that itself");
}

void RenderArguments::addPictureTo(CommandLine& line) {
    line.choice(
        "--pass", pass, {"color", "raycast", "normals"},
        "What a pixel shows: color (the light), raycast (color_diffuse) or normals",
        [](const std::string& text) { return isTerm(text) ? "; write --only " + visibly(text) : ""; });
    line.text("--crop", crop,
              "Render only the pixels x0 <= x < x1, y0 <= y < y1, from the top left: x0,y0,x1,y1");
    line.shown("--crop", "x0,y0,x1,y1");
    line.rejoins("--crop", rejoinedList({"has commas, no blanks", ", ", ",", 4, 4, isWholeNumber}));
    line.number(
        "--samples", samples, {1, mostSamples},
        "Rays in each pixel, averaged; the first one goes through its centre (1; with --adaptive 256)");
    line.number(
        "--adaptive", options.adaptive, {0, 1},
        "Take more samples in a pixel until its error is estimated to be at most this, of 1 (twice this "
        "where it takes 256), or there are --samples; 0.02 makes a nice picture");
}

void RenderArguments::check(const CommandLine& line) const {
    const Terms chosen = terms();
    if (isDark(chosen))
        throw UsageError("--only " + only + ": there is no light without ambient, diffuse or specular");
    for (const std::string& set : sets) JsonEdit{set};
    if (!crop.empty()) parseCrop(crop);
    const auto refuse = [&](const std::string& cause, std::initializer_list<const char*> useless) {
        for (const char* option : useless)
            if (line.given(option)) throw UsageError(option + (" has no effect with " + cause));
    };
    if (pass != "color")
        refuse("--pass " + pass, {"--only", "--opaque", "--max-recursion", "--cutoff", "--texture-filter"});
    if (!recurses()) refuse("--only " + only, {"--cutoff", "--max-recursion"});
    if (!chosen.refraction && !chosen.shadows) refuse("--only " + only, {"--opaque"});
    if (!chosen.textures) refuse("--only " + only, {"--texture-filter"});
    if (options.max_recursion == 0 && options.cutoff > 0) refuse("--max-recursion 0", {"--cutoff"});
    if (samples == 1 && options.adaptive > 0) refuse("--samples 1", {"--adaptive"});
}

bool RenderArguments::recurses() const {
    const Terms chosen = terms();
    return pass == "color" && (chosen.reflections || chosen.refraction);
}

Setting RenderArguments::accepted(Setting setting) const {
    if (!recurses()) {
        setting.max_recursion = Setting{}.max_recursion;
        setting.cutoff = 0;
    }
    return setting;
}

void RenderArguments::addLongEdgeTo(CommandLine& line) {
    line.number("LONG_EDGE_PIXELS", longEdge, longEdgeRange, "Pixels along the longer side of the film");
}

Terms RenderArguments::terms() const {
    if (only.empty()) return {};
    Terms terms = noTerms;
    for (const std::string& name : listParts(only)) {
        if (name.empty()) throw UsageError("--only: a comma too many in " + inQuotes(only));
        terms.*termNamed(name) = true;
    }
    return terms;
}

Precision RenderArguments::chosenPrecision() const {
    return static_cast<Precision>(std::ranges::find(precisionNames, precision) - precisionNames);
}

std::unique_ptr<Renderer> RenderArguments::makeRenderer(const SceneDescription& description) const {
    const Precision chosen = chosenPrecision();
    const BuildOptions build{accelerator == "none" ? Accelerator::None : Accelerator::Bvh, options.threads};
    auto renderer = withMemoryFor(scene, "its shapes and trees",
                                  [&] { return raytracer::makeRenderer(description, chosen, build); });
    if (warns() && renderer->precision() != chosen)
        warn("the scene's numbers lie too far apart for --precision " + precision + ": computed in " +
             precisionName(renderer->precision()));
    if (warns() && !renderer->fits())
        warn("the scene's numbers lie too far apart for any precision: the picture may be wrong");
    return renderer;
}

void RenderArguments::warn(const std::string& warning) const { warnAll({Error({scene}, warning).what()}); }

void RenderArguments::remark(const std::string& text) const {
    if (!quiet) tell(std::string("warning: ") + Error({scene}, text).what());
}

void RenderArguments::warnAll(const std::vector<std::string>& warnings) const {
    if (warnings.empty()) return;
    const char* const head = strict ? "" : "warning: ";
    for (std::size_t i = 0; warns() && i + strict < warnings.size(); ++i) tell(head + warnings[i]);
    if (strict) throw Error(warnings.back());
}

SceneDescription RenderArguments::load(std::vector<std::string>* files, FileKind kind) const {
    LoadedScene loaded = loadScene(scene, sets, files, kind, options.threads);
    if (!warns()) return std::move(loaded.description);
    std::vector<std::string> remarks = sceneSlips(loaded.description);
    std::ranges::move(sceneAdvice(loaded.description), std::back_inserter(remarks));
    for (const Error& remark : remarksOn(scene, remarks, sets)) loaded.warnings.emplace_back(remark.what());
    warnAll(loaded.warnings);
    return std::move(loaded.description);
}

RenderOptions RenderArguments::prepare(SceneDescription& description) const {
    const Terms chosen = terms();
    if (pass == "color") keepTerms(description, chosen);
    if (opaque) makeOpaque(description);
    RenderOptions prepared = options;
    prepared.size = imageSize(description.camera, longEdge);
    prepared.crop = crop.empty() ? PixelRectangle{0, 0, prepared.size.width, prepared.size.height}
                                 : cropOf(crop, prepared.size);
    prepared.pass = passNamed(pass);
    prepared.shadows = chosen.shadows;
    prepared.refraction = chosen.refraction;
    prepared.samples = samples.value_or(usualSamples(options.adaptive));
    prepared.bilinear = textureFilter == "bilinear";
    return prepared;
}

}  // namespace raytracer::commands
