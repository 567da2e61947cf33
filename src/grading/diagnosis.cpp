#include "raytracer/grading/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mistake_search.h"
#include "raytracer/grading/compare.h"
#include "raytracer/util/memory.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

// Fewer wrong pixels tell nothing: right programs have some at edges.
constexpr std::size_t fewestWrong = 24;
constexpr std::size_t mostNames = 3;

NamedMistake nameOf(const Candidate& candidate) {
    NamedMistake name{candidate.fit};
    name.explained = std::max(0.0, candidate.fit.net());
    name.contradicted = 0;
    for (const Mistake* mistake : candidate.variant->mistakes()) {
        name.what += (name.what.empty() ? "" : " and ") + mistake->what;
        if (!mistake->hint.empty()) name.hint += (name.hint.empty() ? "" : " ") + mistake->hint;
    }
    return name;
}

// Whether the mistake is one that is only looked for alone: programs seldom make it.
bool isRare(const Candidate& candidate) { return candidate.variant->mistakes()[0]->alone; }

void addNames(Diagnosis& diagnosis, const Candidates& candidates, bool rare) {
    for (const Candidate& candidate : candidates) {
        if (isRare(candidate) != rare) continue;
        NamedMistake name = nameOf(candidate);
        const auto isThere = [&](const NamedMistake& other) { return other.what == name.what; };
        if (std::ranges::none_of(diagnosis.mistakes, isThere)) diagnosis.mistakes.push_back(std::move(name));
    }
}

using Names = std::set<std::string>;

// The partners of this mistake in the pairs that contain it.
Names partnersOf(const std::string& one, const std::set<Names>& pairs) {
    Names partners;
    for (const Names& pair : pairs)
        if (pair.contains(one)) partners.insert(*pair.begin() == one ? *pair.rbegin() : *pair.begin());
    return partners;
}

std::string alternatives(const Names& names) { return listed({names.begin(), names.end()}, "or"); }

// One name for many pairs, if they are the product of a few mistakes
// and a few others: "A or B, and C". Empty if they are not.
std::optional<NamedMistake> productOf(const Candidates& candidates) {
    std::set<Names> pairs;
    for (const Candidate& candidate : candidates) {
        const auto mistakes = candidate.variant->mistakes();
        if (mistakes.size() != 2) return {};
        pairs.insert({mistakes[0]->what, mistakes[1]->what});
    }
    const auto first = candidates.front().variant->mistakes();
    const Names ones = partnersOf(first[1]->what, pairs), others = partnersOf(first[0]->what, pairs);
    const auto hasOthers = [&](const std::string& one) { return partnersOf(one, pairs) == others; };
    if (std::max(ones.size(), others.size()) > mostNames || ones.size() * others.size() != pairs.size() ||
        !std::ranges::all_of(ones, hasOthers))
        return {};
    NamedMistake name = nameOf(candidates.front());
    name.what = alternatives(ones) + ", and " + alternatives(others);
    return name;
}

// Alternatives, with the words that all begin with written once: "flipped left and right or up and down".
std::string shortAlternatives(const Names& names) {
    const std::string &first = *names.begin(), &last = *names.rbegin();  // they are sorted
    const auto common = std::ranges::mismatch(first, last).in1 - first.begin();
    const std::size_t prefix = first.rfind(' ', static_cast<std::size_t>(common)) + 1;
    std::vector<std::string> rests;
    for (const std::string& name : names) rests.push_back(name.substr(prefix));
    return first.substr(0, prefix) + listed(rests, "or");
}

// One name for all single mistakes of a kind. Empty if there are pairs.
std::vector<NamedMistake> namesOfKinds(const Candidates& candidates) {
    std::map<std::string, NamedMistake> names;
    std::map<std::string, Names> members;
    for (const Candidate& candidate : candidates) {
        const auto mistakes = candidate.variant->mistakes();
        if (mistakes.size() != 1) return {};
        const std::string& kind = mistakes[0]->kind.empty() ? mistakes[0]->what : mistakes[0]->kind;
        names.try_emplace(kind, nameOf(candidate));
        members[kind].insert(mistakes[0]->what);
    }
    std::vector<NamedMistake> list;
    for (auto& [kind, name] : names) {
        name.what = shortAlternatives(members[kind]);
        list.push_back(std::move(name));
    }
    return list;
}

// Adds the candidates' names. If there are more than mostNames, the picture shows too little to tell them
// apart: then they are joined by kind, or as a product of pairs. Names that are still too many are left out.
void nameAll(Diagnosis& diagnosis, const Candidates& candidates) {
    addNames(diagnosis, candidates, false);
    if (diagnosis.mistakes.size() > mostNames) {
        diagnosis.mistakes = namesOfKinds(candidates);
        if (diagnosis.mistakes.size() > mostNames) diagnosis.mistakes.clear();
        if (const auto name = productOf(candidates)) diagnosis.mistakes.push_back(*name);
        return;
    }
    const std::size_t usual = diagnosis.mistakes.size();
    addNames(diagnosis, candidates, true);
    if (diagnosis.mistakes.size() > mostNames) diagnosis.mistakes.resize(usual);
}

bool isOneColor(const ByteImage& picture) {
    for (std::size_t i = 3; i < picture.pixels.size(); ++i)
        if (picture.pixels[i] != picture.pixels[i - 3]) return false;
    return true;
}

std::optional<NamedMistake> specksIn(const ByteImage& picture, const SplitPixels& split,
                                     const KnownVariants& known) {
    Sample sample(split, 1000, 0, picture.width);
    for (const PixelPlace& pixel : sample.pixels) sample.trees.push_back(known.scene->explain(pixel));
    return specksIn(picture, known.right, split.wrongPixels, known.scene->scene(), sample);
}

void search(Diagnosis& diagnosis, const ByteImage& picture, const SplitPixels& split,
            const KnownVariants& known) {
    const Candidates candidates = explanationsOf(picture, split, known);
    nameAll(diagnosis, candidates);
    if (!diagnosis.mistakes.empty()) return;
    if (const auto specks = specksIn(picture, split, known)) diagnosis.mistakes.push_back(*specks);
    else
        diagnosis.unnamed =
            candidates.empty() ? "no known mistake" : "more known mistakes than can be told apart";
}

// "equals the picture", or how many pixels keep it from that.
std::string likenessInWords(const NamedMistake& mistake, const Diagnosis& diagnosis) {
    const std::string pixels = std::to_string(diagnosis.pixels) + " pixels";
    if (!mistake.off)
        return "is, in the " + std::to_string(mistake.sampled) + " pixels looked at" +
               (mistake.unknown > 0 ? ", none of which shows glass" : "") + ", the picture ";
    std::vector<std::string> but;
    if (*mistake.off > 0) but.push_back(std::to_string(*mistake.off) + " of " + pixels);
    if (mistake.rounded > 0)
        but.push_back(std::to_string(mistake.rounded) + " of " + pixels + " that rounding decides");
    if (but.empty()) return "equals the picture ";
    return "is, but for " + listed(but, "and") + ", the picture ";
}

std::string differenceInWords(const NamedMistake& mistake, const Diagnosis& diagnosis) {
    const std::string of = " of " + std::to_string(diagnosis.pixels), wrong = std::to_string(diagnosis.wrong);
    if (mistake.isExact()) return " (0" + of + " pixels differ; " + wrong + " differ from the right one)";
    return " (" + wrong + of + " pixels differ from the right one)";
}

}  // namespace

std::string Diagnosis::names() const {
    std::string text;
    for (const NamedMistake& mistake : mistakes) text += (text.empty() ? "" : ", or ") + mistake.what;
    return text;
}

std::vector<std::string> Diagnosis::hints() const {
    std::vector<std::string> hints;
    for (const NamedMistake& mistake : mistakes)
        if (!mistake.hint.empty() && std::ranges::find(hints, mistake.hint) == hints.end())
            hints.push_back(mistake.hint);
    return hints;
}

std::string Diagnosis::sentence() const {
    if (mistakes.empty()) return {};
    const NamedMistake& first = mistakes.front();
    constexpr double all = 0.999;
    if (first.explained >= all)
        return likenessInWords(first, *this) + names() + differenceInWords(first, *this);
    return formatted("is wrong: %.0f %% of its ", std::floor(100 * first.explained)) + std::to_string(wrong) +
           " wrong pixels are as in the picture " + names();
}

MistakeNamer::MistakeNamer(const SceneDescription& scene, const RenderOptions& options, const Terms& terms,
                           Precision precision)
    : known_(std::make_unique<KnownVariants>(scene, options, terms, precision)) {}

MistakeNamer::~MistakeNamer() = default;

const ByteImage& MistakeNamer::right() const { return known_->right; }

Diagnosis MistakeNamer::diagnose(const ByteImage& picture) const {
    requireSameSize(picture, known_->right);
    Diagnosis diagnosis;
    diagnosis.pixels = picture.pixels.size() / 3;
    constexpr double bytesOfPixel =
        sizeof(std::size_t) + 3 * 3;  // its number, and a mistake's three pictures
    requireMemory({}, "the diagnosis of " + pixelsInWords(picture.width, picture.height),
                  bytesOfPixel * static_cast<double>(diagnosis.pixels));
    const SplitPixels split(picture, known_->right);
    diagnosis.wrong = split.differing;
    diagnosis.isRounding = split.differing > 0 && split.wrongPixels.empty();
    if (split.wrongPixels.empty()) return diagnosis;
    if (split.wrongPixels.size() < fewestWrong)
        diagnosis.unnamed = "too few wrong pixels to tell the mistake";
    else if (isOneColor(picture)) diagnosis.unnamed = "one colour tells no mistake";
    else search(diagnosis, picture, split, *known_);
    return diagnosis;
}

}  // namespace raytracer
