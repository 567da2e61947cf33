// Pictures that show something else than was asked for: another stage, other terms, several rays a pixel.
#include <algorithm>
#include <memory>

#include <glm/common.hpp>

#include "mistake.h"
#include "raytracer/grading/grade.h"
#include "raytracer/tracer/sample_sequence.h"
#include "raytracer/tracer/term_names.h"

namespace raytracer {

namespace {

bool areSameTerms(const Terms& a, const Terms& b) {
    return std::ranges::all_of(termNames, [&](const TermName& term) { return a.*term.term == b.*term.term; });
}

std::string stageInWords(const Stage& stage) {
    const std::string name = "the stage -" + std::string(stage.name);
    const bool isLight = stage.only == "ambient" || stage.only == "diffuse" || stage.only == "specular";
    return isLight ? "of " + std::string(stage.only) + " light alone, " + name : "of " + name;
}

// The whole scene anew: the terms that the right picture leaves out are no longer in its scene.
std::function<void(SceneDescription&, RenderOptions&)> shownAs(
    const std::shared_ptr<const SceneDescription>& whole, Pass pass, const Terms& terms) {
    return [=](SceneDescription& scene, RenderOptions& options) {
        scene = *whole;
        if (pass == Pass::Color) keepTerms(scene, terms);
        options.pass = pass;
        options.shadows = terms.shadows;
        options.refraction = terms.refraction;
    };
}

void addStages(std::vector<Mistake>& mistakes, const std::shared_ptr<const SceneDescription>& whole,
               Pass pass, const Terms& terms) {
    for (const Stage& stage : stages()) {
        const Pass other = passNamed(stage.pass);
        const Terms kept = termsNamed(std::string(stage.only));
        if (other == pass && (pass != Pass::Color || areSameTerms(kept, terms))) continue;
        mistakes.push_back({.what = stageInWords(stage),
                            .hint = "Is it the picture of the stage that was asked for?",
                            .edit = shownAs(whole, other, kept),
                            .alone = true});
    }
}

void addMoreTerms(std::vector<Mistake>& mistakes, const std::shared_ptr<const SceneDescription>& whole,
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
    const glm::dvec3 miss(54.0 / 255);  // of Pass::Normals
    return color == miss ? color : 1.0 - color;
}

void addNormalMistakes(std::vector<Mistake>& mistakes) {
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

void addSamples(std::vector<Mistake>& mistakes, const std::vector<glm::dvec2>& places) {
    mistakes.push_back({.what = "with " + std::to_string(places.size()) + " samples a pixel",
                        .hint = "One ray goes through each pixel, at its centre: x + 0.5, y + 0.5.",
                        .alone = true,
                        .samples = places});
}

// On the usual grids, and where `--samples` has them.
void addSampleMistakes(std::vector<Mistake>& mistakes) {
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

void addStageMistakes(std::vector<Mistake>& mistakes, const SceneDescription& whole,
                      const RenderOptions& options, const Terms& terms) {
    const auto shared = std::make_shared<const SceneDescription>(whole);
    addStages(mistakes, shared, options.pass, terms);
    if (options.pass == Pass::Color) addMoreTerms(mistakes, shared, terms);
    if (options.pass == Pass::Normals) addNormalMistakes(mistakes);
    addSampleMistakes(mistakes);
}

}  // namespace raytracer
