#include "render_arguments.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "raytracer/explain/scene_advice.h"
#include "raytracer/scene/scene_loader.h"

namespace raytracer::commands {

namespace {

struct TermName {
    const char* name;
    bool Terms::*term;
};
constexpr TermName termNames[] = {
    {"ambient", &Terms::ambient},   {"diffuse", &Terms::diffuse},         {"specular", &Terms::specular},
    {"shadows", &Terms::shadows},   {"reflections", &Terms::reflections}, {"refraction", &Terms::refraction},
    {"textures", &Terms::textures},
};

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    std::istringstream stream(list);
    for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
    return parts;
}

int pixelNumber(const std::string& text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw std::invalid_argument("--crop: expected four whole numbers x0,y0,x1,y1, found \"" + text +
                                    "\"");
    return value;
}

PixelRectangle parseCrop(const std::string& text, const ImageSize& size) {
    const std::vector<std::string> parts = split(text);
    if (parts.size() != 4)
        throw std::invalid_argument("--crop: expected four whole numbers x0,y0,x1,y1, found \"" + text +
                                    "\"");
    const PixelRectangle crop{pixelNumber(parts[0]), pixelNumber(parts[1]), pixelNumber(parts[2]),
                              pixelNumber(parts[3])};
    if (crop.x0 < 0 || crop.y0 < 0 || crop.x1 > size.width || crop.y1 > size.height || crop.width() < 1 ||
        crop.height() < 1)
        throw std::invalid_argument("--crop: expected a rectangle inside of the " +
                                    std::to_string(size.width) + " x " + std::to_string(size.height) +
                                    " picture, found \"" + text + "\"");
    return crop;
}

}  // namespace

void RenderArguments::addTo(CLI::App& app) {
    app.add_option("SCENE", scene, "The scene, a JSON file")->required();
    app.add_option("--max-recursion", max_recursion, "How many times a ray is reflected or refracted")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    app.add_option(
        "--only", only,
        "Render only these terms, comma-separated: ambient, diffuse, specular, shadows, reflections, "
        "refraction, textures");
    app.add_flag("--opaque", opaque, "Read every material as not refractive");
    app.add_option("--pass", pass, "What a pixel shows: color (the light), raycast (color_diffuse), normals")
        ->check(CLI::IsMember({"color", "raycast", "normals"}))
        ->capture_default_str();
    app.add_option("--precision", precision, "Arithmetic: float, double or extended (long double)")
        ->check(CLI::IsMember({"float", "double", "extended"}))
        ->capture_default_str();
    app.add_option("--samples", samples,
                   "N x N rays a pixel on a regular grid, averaged; 1: through its centre")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    app.add_option("--adaptive", adaptive,
                   "Take all N x N samples only where the corners of the pixel's grid differ by more than "
                   "this (0 to 1)")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--cutoff", cutoff,
                   "Do not cast a ray that can change its pixel by less than this (0 to 1)")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--texture-filter", textureFilter, "Texture look-up: nearest or bilinear")
        ->check(CLI::IsMember({"nearest", "bilinear"}))
        ->capture_default_str();
    app.add_option("--crop", crop,
                   "Render only the pixels x0 <= x < x1, y0 <= y < y1, from the top left: x0,y0,x1,y1");
    app.add_option("--threads", threads, "Number of threads; 0: one for each processor")
        ->check(CLI::Range(0, 4096))
        ->capture_default_str();
    app.add_option("--accelerator", accelerator,
                   "How rays find shapes: bvh, or none to try them all (the same picture)")
        ->check(CLI::IsMember({"bvh", "none"}))
        ->capture_default_str();
    app.add_flag("--strict", strict, "Warnings about the scene are errors");
    app.add_flag("--quiet", quiet, "No warnings and no progress bar");
}

Terms RenderArguments::terms() const {
    if (only.empty()) return {};
    Terms terms{false, false, false, false, false, false, false};
    for (const std::string& name : split(only)) {
        const auto* known = std::find_if(std::begin(termNames), std::end(termNames),
                                         [&](const TermName& term) { return name == term.name; });
        if (known == std::end(termNames))
            throw std::invalid_argument(
                "--only: expected some of ambient, diffuse, specular, shadows, reflections, refraction, "
                "textures, found \"" +
                name + "\"");
        terms.*known->term = true;
    }
    return terms;
}

Precision RenderArguments::precisionChosen() const {
    return precision == "float"      ? Precision::Float
           : precision == "extended" ? Precision::Extended
                                     : Precision::Double;
}

BuildOptions RenderArguments::buildOptions() const {
    return {accelerator == "none" ? Accelerator::None : Accelerator::Bvh, threads};
}

void RenderArguments::warn(const std::string& warning) const {
    const std::string line = scene + ": " + warning;
    if (strict) throw SceneError(line);
    if (!quiet) std::fprintf(stderr, "warning: %s\n", line.c_str());
}

SceneDescription RenderArguments::load() const {
    LoadedScene loaded = loadScene(scene, strict);
    if (!warns()) return std::move(loaded.description);
    if (!quiet)
        for (const std::string& warning : loaded.warnings)
            std::fprintf(stderr, "warning: %s\n", warning.c_str());
    for (const std::string& advice : sceneAdvice(loaded.description)) warn(advice);
    return std::move(loaded.description);
}

RenderOptions RenderArguments::prepare(SceneDescription& description) const {
    const Terms chosen = terms();
    if (pass == "color") keepTerms(description, chosen);
    if (opaque) makeOpaque(description);
    RenderOptions options;
    options.size = imageSize(description.camera, longEdge);
    options.crop = crop.empty() ? PixelRectangle{0, 0, options.size.width, options.size.height}
                                : parseCrop(crop, options.size);
    options.max_recursion = max_recursion;
    options.pass = pass == "raycast" ? Pass::Raycast : pass == "normals" ? Pass::Normals : Pass::Color;
    options.shadows = chosen.shadows;
    options.refraction = chosen.refraction;
    options.threads = threads;
    options.samples = samples;
    options.adaptive = adaptive;
    options.cutoff = cutoff;
    options.bilinear = textureFilter == "bilinear";
    return options;
}

}  // namespace raytracer::commands
