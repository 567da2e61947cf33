#include "mistake_search.h"

#include <algorithm>

#include "raytracer/scene/mesh_file.h"

namespace raytracer {

namespace {

// A mistake is named if it explains at least this share of the wrong pixels. In tests, some variant explained
// up to 0.98 of them in pictures that are wrong for another reason.
constexpr double leastExplained = 0.99;
// If a mistake explains this much, no second one is looked for: the rest is the rounding of another program.
constexpr double fullyExplained = 0.998;

double netOf(const Candidate& candidate) { return candidate.fit.net(); }

// Searches the variants that explain one picture.
class Search {
  public:
    Search(const KnownVariants& known, const ByteImage& picture, const SplitPixels& split)
        : known_(known),
          picture_(picture),
          split_(split),
          some_(split, 96, 32, picture.width),
          many_(split, 1000, 1000, picture.width) {}

    // The variants that explain the picture, all equally well. Empty if none does.
    Candidates best() {
        const Candidates& singles = bestSingles();
        if (isWhole(singles)) return singles;
        Candidates pairs = pairsWithSingles();
        const bool isExplained = rest(singles) <= 1 - leastExplained;
        if (rest(pairs) > 1 - leastExplained && !isExplained) pairs = bestPairs();
        if (isWhole(pairs)) return pairs;
        return isExplained ? singles : Candidates();
    }

  private:
    // Whether the best explains all wrong pixels, also those that show glass. Two mistakes must: too many
    // pairs explain a bit less of a picture that is wrong for another reason.
    static bool isWhole(const Candidates& some) {
        return rest(some) <= 1 - fullyExplained && some.front().fit.unknown == 0;
    }
    static double rest(const Candidates& some) { return some.empty() ? 1 : 1 - netOf(some.front()); }

    const Candidates& bestSingles() {
        constexpr double least = 0.3;  // in the first sample
        for (const auto& single : known_.singles) {
            const Fit fit = fitTo(some_, *single, single->mistakes()[0]->moves);
            alone_.push_back(fit.explained);
            if (fit.explained >= least) singles_.push_back({single, fit});
        }
        singles_ = refitted(std::move(singles_));
        hopeful_ = singles_;
        singles_ = narrowed(std::move(singles_));
        return singles_;
    }

    // Pairs of the best single mistakes with others that explain the pixels which these leave unexplained.
    Candidates pairsWithSingles() {
        constexpr double least = 0.5;  // for a single mistake, and then for the other in the rest
        Candidates candidates;
        for (const Candidate& base : hopeful_) {
            if (netOf(base) < least) continue;
            Sample sample(unexplainedBy(*base.variant, picture_, known_.right, split_), split_.rightPixels,
                          24, 12, picture_.width);
            for (std::size_t other = 0; other < known_.singles.size(); ++other) {
                const std::size_t index =
                    static_cast<std::size_t>(base.variant->mistakes()[0] - known_.mistakes.data());
                if (!canBePair(index, other)) continue;
                addIfGood(candidates, std::min(index, other), std::max(index, other), sample, least);
            }
        }
        return narrowed(refitted(std::move(candidates)));
    }

    Candidates bestPairs() {
        constexpr double least = 0.75;  // in the first sample
        Candidates candidates;
        Sample few(split_, 24, 12, picture_.width);
        for (std::size_t a = 0; a < known_.singles.size(); ++a)
            for (std::size_t b = a + 1; b < known_.singles.size(); ++b)
                if (canBePair(a, b) && isWorthIt(a, b)) addIfGood(candidates, a, b, few, least);
        return narrowed(refitted(std::move(candidates)));
    }

    void addIfGood(Candidates& candidates, std::size_t a, std::size_t b, Sample& sample, double least) const {
        const auto pair = std::make_shared<Variant>(*known_.singles[a], *known_.singles[b]);
        const Fit fit = fitTo(sample, *pair);
        if (fit.explained >= least) candidates.push_back({pair, fit});
    }

    bool canBePair(std::size_t a, std::size_t b) const {
        const Mistake &one = known_.mistakes[a], &other = known_.mistakes[b];
        return a != b && !one.alone && !other.alone && (one.kind.empty() || one.kind != other.kind);
    }

    // Whether to try a pair. If it needs a scene of its own, which takes long to build, then only if one of
    // the two explains some pixels alone.
    bool isWorthIt(std::size_t a, std::size_t b) const {
        constexpr double some = 0.04;
        const bool isCheap = known_.isSmall || !known_.mistakes[a].edit || !known_.mistakes[b].edit;
        return isCheap || std::max(alone_[a], alone_[b]) >= some;
    }

    // The best candidates, each compared with more pixels.
    Candidates refitted(Candidates candidates) const {
        keepBest(candidates, 16, [](const Candidate& c) { return c.fit.explained; });
        for (Candidate& candidate : candidates) candidate.fit = fitTo(many_, *candidate.variant, true);
        keepBest(candidates, 6, netOf);
        return candidates;
    }

    // The best of these, each compared with the whole picture.
    Candidates narrowed(Candidates candidates) const {
        constexpr double equallyWell = 0.003, hopeful = 0.1;
        std::erase_if(candidates, [&](const Candidate& c) { return netOf(c) < leastExplained - hopeful; });
        for (Candidate& candidate : candidates)
            if (candidate.variant->isPicture())
                candidate.fit = fitOfAll(picture_, known_.right, split_, *candidate.variant);
        // A mistake that is only looked for alone must explain nearly everything: it makes another
        // picture as a whole. So must one whose bytes are not known for some pixels.
        std::erase_if(candidates, [](const Candidate& c) {
            return (c.variant->mistakes()[0]->alone || c.fit.unknown > 0) && netOf(c) < fullyExplained;
        });
        keepBest(candidates, candidates.size(), netOf);
        std::erase_if(candidates,
                      [&](const Candidate& c) { return netOf(c) < netOf(candidates.front()) - equallyWell; });
        const auto isExact = [](const Candidate& c) { return c.fit.isExact(); };
        if (std::ranges::any_of(candidates, isExact))
            std::erase_if(candidates, [](const Candidate& c) { return c.fit.unknown > 0; });
        std::stable_partition(candidates.begin(), candidates.end(), isExact);
        return candidates;
    }

    template <class Value>
    static void keepBest(Candidates& candidates, std::size_t count, Value value) {
        std::ranges::stable_sort(candidates, std::greater(), value);
        if (candidates.size() > count)
            candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(count), candidates.end());
    }

    Fit fitTo(Sample& sample, Variant& variant, bool anyRounding = false) const {
        return fitOfSome(picture_, known_.right, sample, variant, anyRounding);
    }

    const KnownVariants& known_;
    const ByteImage& picture_;
    const SplitPixels& split_;
    mutable Sample some_, many_;  // mutable: their trees are made when needed
    std::vector<double> alone_;   // share that each mistake explains alone
    Candidates hopeful_, singles_;
};

}  // namespace

KnownVariants::KnownVariants(const SceneDescription& whole, RenderOptions options, const Terms& terms,
                             Precision precision) {
    options.samples = 1;
    options.adaptive = 0;
    SceneDescription shown = copyOf(whole);
    if (options.pass == Pass::Color) keepTerms(shown, terms);
    scene = std::make_shared<RenderedScene>(std::move(shown), options, precision);
    mistakes = knownMistakes(whole, options, terms);
    for (const Mistake& mistake : mistakes)
        singles.push_back(std::make_shared<Variant>(std::vector{&mistake}, scene));
    right = Variant({}, scene).picture();
    std::size_t parts = whole.shapes.size();
    for (const ShapeDescription& shape : whole.shapes)
        if (shape.mesh) parts += shape.mesh->triangleCount();
    isSmall = parts <= 200;
}

Candidates explanationsOf(const ByteImage& picture, const SplitPixels& split, const KnownVariants& known) {
    return Search(known, picture, split).best();
}

}  // namespace raytracer
