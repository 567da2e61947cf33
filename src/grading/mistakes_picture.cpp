// Mistakes after the light model: other bytes, or a picture of something else than was asked for (another
// stage, other terms, several rays per pixel).
#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/common.hpp>

#include "mistake.h"
#include "raytracer/grading/grade.h"
#include "raytracer/pictures/image.h"
#include "raytracer/tracer/sample_sequence.h"
#include "raytracer/tracer/term_names.h"

namespace raytracer {

namespace {

glm::dvec3 channelwise(const glm::dvec3& color, double (*f)(double)) {
    const glm::dvec3 c = glm::clamp(color, 0.0, 1.0);
    return {f(c.x), f(c.y), f(c.z)};
}

// IEC 61966-2-1.
double toSrgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
double toGamma(double linear) { return std::pow(linear, 1 / 2.2); }
double fromGamma(double value) { return std::pow(value, 2.2); }
double squareRoot(double linear) { return std::sqrt(linear); }

// The integer part, clamped to the range of int: far above a byte, it does not matter to which byte it wraps.
int toInt(double value) { return value > 0 ? static_cast<int>(std::min(value, 1e9)) : 0; }  // NaN: 0

std::uint8_t wrapped(double channel) { return static_cast<std::uint8_t>(toInt(255 * channel + 0.5) & 255); }
std::uint8_t wrappedAndCut(double channel) { return static_cast<std::uint8_t>(toInt(255 * channel) & 255); }
std::uint8_t cut(double channel) { return static_cast<std::uint8_t>(toInt(255 * std::min(channel, 1.0))); }
std::uint8_t of256(double channel) {
    return static_cast<std::uint8_t>(std::min(255, toInt(256 * std::min(channel, 1.0))));
}

std::string stageInWords(const Stage& stage) {
    const std::string name = "the stage -" + std::string(stage.name);
    const bool isLight = stage.only == "ambient" || stage.only == "diffuse" || stage.only == "specular";
    return "that shows " + (isLight ? std::string(stage.only) + " light alone, as " + name + " does" : name);
}

// Starts again from the whole scene, since the right
// picture's scene no longer has the terms that it leaves out.
Edit shownAs(const std::shared_ptr<const SceneDescription>& whole, Pass pass, const Terms& terms) {
    return [=](SceneDescription& scene, RenderOptions& options) {
        scene = *whole;
        if (pass == Pass::Color) keepTerms(scene, terms);
        options.pass = pass;
        options.shadows = terms.shadows;
        options.refraction = terms.refraction;
    };
}

void addStages(Mistakes& mistakes, const std::shared_ptr<const SceneDescription>& whole, Pass pass,
               const Terms& terms) {
    for (const Stage& stage : stages()) {
        const Pass other = passNamed(stage.pass);
        const Terms kept = termsNamed(std::string(stage.only));
        if (other == pass && (pass != Pass::Color || kept == terms)) continue;
        mistakes.push_back({.what = stageInWords(stage),
                            .hint = "Is it the picture of the stage that was asked for?",
                            .edit = shownAs(whole, other, kept),
                            .alone = true});
    }
}

void addMoreTerms(Mistakes& mistakes, const std::shared_ptr<const SceneDescription>& whole,
                  const Terms& terms) {
    for (const TermName& term : termNames) {
        if (terms.*term.term) continue;
        Terms more = terms;
        more.*term.term = true;
        const std::string name = term.name;
        const bool isLight = name == "ambient" || name == "diffuse" || name == "specular";
        mistakes.push_back({.what = "with " + name + (isLight ? " light" : ""),
                            .hint = "This stage leaves " + name + (isLight ? " light" : "") + " out.",
                            .edit = shownAs(whole, Pass::Color, more),
                            .alone = true});
    }
}

glm::dvec3 turnedInwards(const glm::dvec3& color) {
    const glm::dvec3 miss(54.0 / 255);  // Pass::Normals' colour of a miss
    return color == miss ? color : 1.0 - color;
}

void addNormalMistakes(Mistakes& mistakes) {
    mistakes.push_back({.what = "whose normals point inwards",
                        .hint = "The normal points to the exterior.",
                        .kind = "normals",
                        .color = turnedInwards});
    mistakes.push_back({.what = "whose normals are the colours themselves",
                        .hint = "The colour is (N + 1) / 2.",
                        .kind = "normals",
                        .color = [](const glm::dvec3& color) { return 2.0 * color - 1.0; }});
    mistakes.push_back({.what = "whose normals are the colours, without their signs",
                        .hint = "The colour is (N + 1) / 2.",
                        .kind = "normals",
                        .color = [](const glm::dvec3& color) { return glm::abs(2.0 * color - 1.0); }});
}

void addSamples(Mistakes& mistakes, const std::vector<glm::dvec2>& places) {
    mistakes.push_back({.what = "with " + std::to_string(places.size()) + " samples a pixel",
                        .hint = "One ray goes through each pixel, at its centre: x + 0.5, y + 0.5.",
                        .alone = true,
                        .samples = places});
}

// Samples on the usual grids, and at the places of `--samples`.
void addSampleMistakes(Mistakes& mistakes) {
    for (const std::size_t across : {2, 3, 4}) {
        std::vector<glm::dvec2> grid;
        grid.reserve(across * across);
        for (std::size_t y = 0; y < across; ++y)
            for (std::size_t x = 0; x < across; ++x)
                grid.push_back((glm::dvec2(x, y) + 0.5) / static_cast<double>(across));
        addSamples(mistakes, grid);
    }
    for (const std::uint32_t count : {4U, 16U}) {
        std::vector<glm::dvec2> places;
        for (std::uint32_t i = 0; i < count; ++i) places.push_back(SampleSequence()[i]);
        addSamples(mistakes, places);
    }
}

}  // namespace

void addByteMistakes(Mistakes& mistakes) {
    const auto tone = [&](const char* what, const char* hint, double (*f)(double)) {
        mistakes.push_back(
            {.what = what, .hint = hint, .kind = "tone", .color = [f](const glm::dvec3& color) {
                 return channelwise(color, f);
             }});
    };
    const auto bytes = [&](const char* what, const char* hint, ToByte toByte) {
        mistakes.push_back({.what = what, .hint = hint, .kind = "bytes", .toByte = toByte});
    };
    const char* const linear = "The byte is 255 times the colour, without a gamma curve.";
    tone("with the gamma curve of sRGB applied", linear, toSrgb);
    tone("with a gamma of 2.2 applied", linear, toGamma);
    tone("with a gamma of 1 / 2.2 applied", linear, fromGamma);
    tone("with square roots of the colours", linear, squareRoot);
    mistakes.push_back({.what = "with red and blue exchanged",
                        .hint = "The bytes of a pixel are red, green, blue.",
                        .kind = "channels",
                        .color = [](const glm::dvec3& c) { return glm::dvec3(c.z, c.y, c.x); }});
    const char* const clamp = "Is the colour clamped to 1 before it becomes a byte?";
    bytes("without the clamp: bytes wrap", clamp, wrapped);
    bytes("without the clamp: bytes wrap, and are cut instead of rounded", clamp, wrappedAndCut);
    bytes("whose bytes are cut instead of rounded", "The byte is lround(255 c).", cut);
    bytes("whose bytes are 256 times the colour", "The byte is lround(255 c).", of256);
}

void addStageMistakes(Mistakes& mistakes, const SceneDescription& whole, const RenderOptions& options,
                      const Terms& terms) {
    const auto shared = std::make_shared<const SceneDescription>(whole);
    addStages(mistakes, shared, options.pass, terms);
    if (options.pass == Pass::Color) addMoreTerms(mistakes, shared, terms);
    if (options.pass == Pass::Normals) addNormalMistakes(mistakes);
    addSampleMistakes(mistakes);
}

}  // namespace raytracer
