#include "raytracer/grading/diagnosis.h"

#include <algorithm>
#include <cmath>

#include "mistake_search.h"
#include "raytracer/grading/compare.h"
#include "raytracer/util/text.h"
#include "specks.h"

namespace raytracer {

namespace {

// Fewer wrong pixels, which right programs have at edges, say nothing.
constexpr std::size_t fewestWrong = 24;
constexpr std::size_t mostNames = 3;

NamedMistake nameOf(const Candidate& candidate) {
    NamedMistake name;
    for (const Mistake* mistake : candidate.variant->mistakes()) {
        name.what += (name.what.empty() ? "" : " and ") + mistake->what;
        if (!mistake->hint.empty()) name.hint += (name.hint.empty() ? "" : " ") + mistake->hint;
    }
    name.explained = std::max(0.0, candidate.fit.net());
    name.sampled = candidate.fit.sampled;
    name.off = candidate.fit.off;
    return name;
}

// More names than that say nothing: the picture shows too little.
void addNames(Diagnosis& diagnosis, const Candidates& candidates) {
    for (const Candidate& candidate : candidates) {
        NamedMistake name = nameOf(candidate);
        const auto isThere = [&](const NamedMistake& other) { return other.what == name.what; };
        if (std::ranges::none_of(diagnosis.mistakes, isThere)) diagnosis.mistakes.push_back(std::move(name));
    }
    if (diagnosis.mistakes.size() > mostNames) diagnosis.mistakes.clear();
}

bool isOneColor(const ByteImage& picture) {
    for (std::size_t i = 3; i < picture.pixels.size(); ++i)
        if (picture.pixels[i] != picture.pixels[i - 3]) return false;
    return true;
}

std::string measure(const NamedMistake& mistake, const Diagnosis& diagnosis) {
    const auto count = [](std::uint64_t value) { return std::to_string(value); };
    const std::string wrong = count(diagnosis.wrong) + " differ from the right one)";
    constexpr double all = 0.999;
    if (mistake.explained < all) return "";
    if (mistake.off)
        return " (" + count(*mistake.off) + " of " + count(diagnosis.pixels) + " pixels differ; " + wrong;
    return " (in a sample of " + count(mistake.sampled) + " pixels; " + count(diagnosis.wrong) + " of " +
           count(diagnosis.pixels) + " differ from the right one)";
}

}  // namespace

struct MistakeNamer::State : KnownVariants {
    using KnownVariants::KnownVariants;
};

std::string Diagnosis::names() const {
    std::string text;
    for (const NamedMistake& mistake : mistakes) text += (text.empty() ? "" : ", or ") + mistake.what;
    return text;
}

std::string Diagnosis::sentence() const {
    if (mistakes.empty()) return {};
    const NamedMistake& first = mistakes.front();
    const std::string measured = measure(first, *this);
    if (!measured.empty()) return "equals the picture " + names() + measured;
    return formatted("%.0f", std::floor(100 * first.explained)) +
           " % of the wrong pixels are explained by the picture " + names();
}

MistakeNamer::MistakeNamer(const SceneDescription& scene, const RenderOptions& options)
    : state_(std::make_unique<State>(scene, options)) {}

MistakeNamer::~MistakeNamer() = default;

const ByteImage& MistakeNamer::right() const { return state_->right; }

Diagnosis MistakeNamer::diagnose(const ByteImage& picture) const {
    requireSameSize({picture.width, picture.height}, {state_->right.width, state_->right.height});
    const SplitPixels split(picture, state_->right);
    Diagnosis diagnosis;
    diagnosis.pixels = picture.pixels.size() / 3;
    diagnosis.wrong = split.differing;
    if (split.wrongPixels.size() < fewestWrong || isOneColor(picture)) return diagnosis;
    addNames(diagnosis, explanationsOf(picture, split, *state_));
    if (!diagnosis.mistakes.empty()) return diagnosis;
    Sample sample(split, 1000, 0, picture.width);
    for (const PixelPlace& pixel : sample.pixels) sample.trees.push_back(state_->scene->explain(pixel));
    const SpeckSample specks{sample.pixels, sample.trees};
    if (const auto name = specksIn(picture, state_->right, split.wrongPixels, specks))
        diagnosis.mistakes.push_back(*name);
    return diagnosis;
}

}  // namespace raytracer
