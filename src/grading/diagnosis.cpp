#include "raytracer/grading/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

#include "mistake.h"
#include "raytracer/grading/compare.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/util/text.h"
#include "specks.h"
#include "variant.h"

namespace raytracer {

// A scene, and what each mistake makes of it.
struct KnownVariants {
    KnownVariants(const SceneDescription& description, RenderOptions options) {
        options.samples = 1;
        options.adaptive = 0;
        scene = std::make_shared<RenderedScene>(description, options);
        mistakes = knownMistakes(description, options);
        for (const Mistake& mistake : mistakes)
            singles.push_back(std::make_shared<Variant>(std::vector{&mistake}, scene));
        right = Variant({}, scene).picture();
        std::size_t parts = description.shapes.size();
        for (const ShapeDescription& shape : description.shapes)
            if (shape.mesh) parts += shape.mesh->triangleCount();
        isSmall = parts <= 200;
    }

    std::shared_ptr<RenderedScene> scene;
    std::vector<Mistake> mistakes;
    std::vector<std::shared_ptr<Variant>> singles;
    ByteImage right;
    bool isSmall;  // to build such a scene takes less than a tenth of a millisecond
};

namespace {

// A name explains at least this share of the wrong pixels.
constexpr double leastExplained = 0.9;
// What explains this much is not improved by a second mistake: the rest is the rounding of another program.
constexpr double fullyExplained = 0.998;
// Fewer wrong pixels, which right programs have at edges, say nothing.
constexpr std::size_t fewestWrong = 24;
constexpr std::size_t mostNames = 3;

int difference(const std::uint8_t* a, const std::uint8_t* b) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
    return largest;
}

const std::uint8_t* at(const ByteImage& image, std::size_t pixel) { return &image.pixels[3 * pixel]; }

// The pixels of a picture that are wrong, and those that are right: numbers in reading order. Where few
// differ by 1 only, that is rounding, and neither.
struct Judged {
    Judged(const ByteImage& picture, const ByteImage& right) {
        std::vector<std::size_t> offByOne;
        const std::size_t count = picture.pixels.size() / 3;
        for (std::size_t i = 0; i < count; ++i) {
            const int off = difference(at(picture, i), at(right, i));
            differing += off != 0;
            (off == 0 ? rightPixels : off == 1 ? offByOne : wrongPixels).push_back(i);
        }
        constexpr double rounding = 0.05;  // of the pixels: above what float does
        if (static_cast<double>(offByOne.size()) < rounding * static_cast<double>(count)) return;
        wrongPixels.insert(wrongPixels.end(), offByOne.begin(), offByOne.end());
    }

    std::size_t differing = 0;
    std::vector<std::size_t> wrongPixels, rightPixels;
};

// Some of them, the same on every machine.
std::vector<std::size_t> someOf(std::vector<std::size_t> all, std::size_t count) {
    std::mt19937 bits(1);
    count = std::min(count, all.size());
    for (std::size_t i = 0; i < count; ++i) std::swap(all[i], all[i + bits() % (all.size() - i)]);
    all.resize(count);
    std::ranges::sort(all);  // neighbours are faster
    return all;
}

// Pixels to hold variants against.
struct Sample {
    Sample(const Judged& judged, std::size_t wrong, std::size_t right, int width)
        : numbers(someOf(judged.wrongPixels, wrong)), wrongCount(numbers.size()) {
        const auto rights = someOf(judged.rightPixels, right);
        numbers.insert(numbers.end(), rights.begin(), rights.end());
        for (const std::size_t i : numbers) {
            const int number = static_cast<int>(i);
            pixels.push_back({number % width, number / width});
        }
        rightsOfWrong = static_cast<double>(judged.rightPixels.size()) /
                        static_cast<double>(std::max<std::size_t>(1, judged.wrongPixels.size()));
    }

    std::vector<std::size_t> numbers;
    std::size_t wrongCount;  // the first ones
    double rightsOfWrong;    // in the whole picture
    Pixels pixels;
    Trees trees;  // of the scene without a mistake; see Variant::bytes
};

// How well a variant explains a picture.
struct Fit {
    double explained = 0;     // of the wrong pixels
    double contradicted = 0;  // right pixels that the variant has wrong, as a share of the wrong ones
    std::size_t looked = 0;
    std::optional<std::uint64_t> off = {};  // of the whole picture
    double net() const { return explained - contradicted; }
};

// An equal pixel counts 1. One that is off by 1 is rounding, unless all are.
double likeness(const std::uint8_t* picture, const std::uint8_t* right, const Rgb& variant) {
    constexpr double offByOne = 0.8;
    const int off = difference(picture, variant.data());
    if (off == 0) return 1;
    return off == 1 && difference(picture, right) > 2 ? offByOne : 0;
}

struct Candidate {
    std::shared_ptr<Variant> variant;
    Fit fit;
};

using Candidates = std::vector<Candidate>;

double netOf(const Candidate& candidate) { return candidate.fit.net(); }

// One picture, held against the variants.
class Search {
  public:
    Search(const KnownVariants& known, const ByteImage& picture, const Judged& judged)
        : known_(known),
          picture_(picture),
          judged_(judged),
          some_(judged, 96, 32, picture.width),
          many_(judged, 1000, 1000, picture.width) {}

    // What explains the picture, all equally well; nothing where nothing does.
    Candidates best() {
        const Candidates& singles = bestSingles();
        if (rest(singles) <= 1 - fullyExplained) return singles;
        Candidates pairs = pairsWithSingles();
        if (rest(pairs) > 1 - leastExplained && rest(singles) > 1 - leastExplained) pairs = bestPairs();
        constexpr double worthIt = 0.4;  // of what a single mistake leaves unexplained, two may leave
        if (rest(pairs) <= worthIt * rest(singles) && rest(pairs) <= 1 - leastExplained) return pairs;
        return rest(singles) <= 1 - leastExplained ? singles : Candidates();
    }

  private:
    static double rest(const Candidates& some) { return some.empty() ? 1 : 1 - netOf(some.front()); }

    const Candidates& bestSingles() {
        constexpr double least = 0.3;  // in a first look
        for (const auto& single : known_.singles) {
            const Fit fit = fitTo(some_, *single);
            alone_.push_back(fit.explained);
            if (fit.explained >= least) singles_.push_back({single, fit});
        }
        singles_ = looked(std::move(singles_));
        hopeful_ = singles_;
        singles_ = narrowed(std::move(singles_));
        return singles_;
    }

    // What explains the pixels that the best single mistakes leave unexplained, together with these.
    Candidates pairsWithSingles() {
        constexpr double least = 0.5;  // of a single mistake, and then of what is left
        Candidates candidates;
        for (const Candidate& base : hopeful_) {
            if (netOf(base) < least) continue;
            Sample sample(unexplainedBy(*base.variant), 24, 12, picture_.width);
            for (std::size_t other = 0; other < known_.singles.size(); ++other) {
                const std::size_t index =
                    static_cast<std::size_t>(base.variant->mistakes()[0] - known_.mistakes.data());
                if (!canBePair(index, other)) continue;
                addIfGood(candidates, std::min(index, other), std::max(index, other), sample, least);
            }
        }
        return narrowed(looked(std::move(candidates)));
    }

    Judged unexplainedBy(Variant& variant) const {
        Sample dense(judged_, 4000, 0, picture_.width);
        const auto bytes = variant.bytes(dense.pixels, dense.trees);
        Judged left = judged_;
        left.wrongPixels.clear();
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            const std::size_t pixel = dense.numbers[i];
            if (bytes[i] && likeness(at(picture_, pixel), at(known_.right, pixel), *bytes[i]) < 1)
                left.wrongPixels.push_back(pixel);
        }
        return left;
    }

    Candidates bestPairs() {
        constexpr double least = 0.75;  // in a first look
        Candidates candidates;
        Sample few(judged_, 24, 12, picture_.width);
        for (std::size_t a = 0; a < known_.singles.size(); ++a)
            for (std::size_t b = a + 1; b < known_.singles.size(); ++b)
                if (canBePair(a, b) && isWorthIt(a, b)) addIfGood(candidates, a, b, few, least);
        return narrowed(looked(std::move(candidates)));
    }

    void addIfGood(Candidates& candidates, std::size_t a, std::size_t b, Sample& sample, double least) const {
        const auto pair = std::make_shared<Variant>(*known_.singles[a], *known_.singles[b]);
        const Fit fit = fitTo(sample, *pair);
        if (fit.explained >= least) candidates.push_back({pair, fit});
    }

    bool canBePair(std::size_t a, std::size_t b) const {
        const Mistake &one = known_.mistakes[a], &other = known_.mistakes[b];
        return a != b && (one.kind.empty() || one.kind != other.kind);
    }

    // Of a scene that takes long to build, a pair that needs one of its own is looked at where one of the two
    // alone explains some pixels.
    bool isWorthIt(std::size_t a, std::size_t b) const {
        constexpr double some = 0.04;
        const bool isCheap = known_.isSmall || !known_.mistakes[a].edit || !known_.mistakes[b].edit;
        return isCheap || std::max(alone_[a], alone_[b]) >= some;
    }

    // The best of them, each held against more pixels.
    Candidates looked(Candidates candidates) const {
        keepBest(candidates, 16, [](const Candidate& c) { return c.fit.explained; });
        for (Candidate& candidate : candidates) candidate.fit = fitTo(many_, *candidate.variant);
        keepBest(candidates, 6, netOf);
        return candidates;
    }

    // The best of these, each held against the whole picture.
    Candidates narrowed(Candidates candidates) const {
        constexpr double equallyWell = 0.003, hopeful = 0.1;
        std::erase_if(candidates, [&](const Candidate& c) { return netOf(c) < leastExplained - hopeful; });
        for (Candidate& candidate : candidates)
            if (!candidate.variant->isOfTrees()) lookAtAll(candidate);
        keepBest(candidates, candidates.size(), netOf);
        std::erase_if(candidates,
                      [&](const Candidate& c) { return netOf(c) < netOf(candidates.front()) - equallyWell; });
        return candidates;
    }

    template <class Value>
    static void keepBest(Candidates& candidates, std::size_t count, Value value) {
        std::ranges::stable_sort(candidates, std::greater(), value);
        if (candidates.size() > count)
            candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(count), candidates.end());
    }

    Fit fitTo(Sample& sample, Variant& variant) const {
        const auto bytes = variant.bytes(sample.pixels, sample.trees);
        double wrong = 0, explained = 0, right = 0, contradicted = 0;
        for (std::size_t i = 0; i < bytes.size(); ++i) {
            if (!bytes[i]) continue;
            const std::uint8_t* pixel = at(picture_, sample.numbers[i]);
            (i < sample.wrongCount ? wrong : right) += 1;
            if (i < sample.wrongCount)
                explained += likeness(pixel, at(known_.right, sample.numbers[i]), *bytes[i]);
            else contradicted += difference(pixel, bytes[i]->data()) > 1;
        }
        constexpr double leastKnown = 0.25;  // of the wrong pixels
        if (wrong < leastKnown * static_cast<double>(sample.wrongCount)) return {};
        return {
            explained / wrong, right > 0 ? contradicted / right * sample.rightsOfWrong : 0, bytes.size(), {}};
    }

    void lookAtAll(Candidate& candidate) const {
        const ByteImage whole = candidate.variant->picture();
        double explained = 0, contradicted = 0;
        for (const std::size_t i : judged_.wrongPixels) {
            const std::uint8_t* made = at(whole, i);
            explained += likeness(at(picture_, i), at(known_.right, i), {made[0], made[1], made[2]});
        }
        for (const std::size_t i : judged_.rightPixels)
            contradicted += difference(at(picture_, i), at(whole, i)) > 1;
        std::uint64_t off = 0;
        for (std::size_t i = 0; i < whole.pixels.size() / 3; ++i)
            off += difference(at(picture_, i), at(whole, i)) != 0;
        const auto wrong = static_cast<double>(judged_.wrongPixels.size());
        candidate.fit = {explained / wrong, contradicted / wrong, whole.pixels.size() / 3, off};
    }

    const KnownVariants& known_;
    const ByteImage& picture_;
    const Judged& judged_;
    mutable Sample some_, many_;  // whose trees are made when needed
    std::vector<double> alone_;   // what each mistake explains without another
    Candidates hopeful_, singles_;
};

NamedMistake nameOf(const Candidate& candidate) {
    NamedMistake name;
    for (const Mistake* mistake : candidate.variant->mistakes()) {
        name.what += (name.what.empty() ? "" : " and ") + mistake->what;
        if (!mistake->hint.empty()) name.hint += (name.hint.empty() ? "" : " ") + mistake->hint;
    }
    name.explained = std::max(0.0, candidate.fit.net());
    name.looked = candidate.fit.looked;
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
    return " (in " + count(mistake.looked) + " pixels looked at; " + count(diagnosis.wrong) + " of " +
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
    const Judged judged(picture, state_->right);
    Diagnosis diagnosis;
    diagnosis.pixels = picture.pixels.size() / 3;
    diagnosis.wrong = judged.differing;
    if (judged.wrongPixels.size() < fewestWrong || isOneColor(picture)) return diagnosis;
    addNames(diagnosis, Search(*state_, picture, judged).best());
    if (!diagnosis.mistakes.empty()) return diagnosis;
    Sample sample(judged, 1000, 0, picture.width);
    for (const PixelPlace& pixel : sample.pixels) sample.trees.push_back(state_->scene->explain(pixel));
    const SpeckSample specks{sample.pixels, sample.trees};
    if (const auto name = specksIn(picture, state_->right, judged.wrongPixels, specks))
        diagnosis.mistakes.push_back(*name);
    return diagnosis;
}

}  // namespace raytracer
