#include "depth_search.h"

#include <algorithm>
#include <iterator>

#include "target_statistics.h"

namespace raytracer {

namespace {

// Of the picture's pixels: measured first, when its cost is not known.
constexpr double firstPart = 1.0 / 200, firstPixels = 500;
constexpr double widePart = 0.009;  // of the picture's rays: for measuring again
// 100 MB of ray trees. What lies in three of 100,000 pixels is missed once in 20 times.
constexpr double mostPixels = 100000;
constexpr double smallestStep = 1.1;     // in rays, between which halving is worth its cost
constexpr double smallestGrowth = 3;     // in pixels, for which measuring again is worth its cost
constexpr double negligibleStep = 1.02;  // in rays: such depths are not both tried

// Of depths on a front that cost nearly the same, the most accurate.
std::vector<DepthChoice> distinct(const std::vector<DepthChoice>& front) {
    std::vector<DepthChoice> few;
    for (std::size_t i = front.size(); i-- > 0;)
        if (few.empty() || negligibleStep * front[i].rays < few.back().rays) few.push_back(front[i]);
    std::ranges::reverse(few);
    return few;
}

}  // namespace

DepthSearch::DepthSearch(const Renderer& renderer, const RenderOptions& options, double target)
    : renderer_(renderer),
      options_(options),
      target_(target),
      deepest_{.max_recursion = 32, .cutoff = std::min(0.1, 3 * target), .bilinear = options.bilinear} {
    measure(std::max(firstPixels, firstPart * options.crop.area()));
}

void DepthSearch::measure(double pixels) {
    const auto count = static_cast<std::size_t>(std::min(options_.crop.area(), pixels));
    pilot_.emplace(renderer_, options_, scatteredPixels(options_.crop, count, 1), deepest_);
    spent_ += pilot_->raysSpent();
    choices_ = front(enough);
}

std::vector<DepthChoice> DepthSearch::front(double part) {
    std::vector<double> cutoffs;
    std::ranges::copy_if(gridCutoffs, std::back_inserter(cutoffs),
                         [&](double cutoff) { return cutoff >= deepest_.cutoff; });
    const auto measure = [&](int depth, double cutoff) { return pilot_->measured(depth, cutoff); };
    return distinct(depthFront(measure, deepest_.max_recursion, cutoffs, part * target_));
}

bool DepthSearch::widen(double raysOfPixel) {
    const double raysOfTree = pilot_->raysSpent() / static_cast<double>(pilot_->pixelCount());
    const double affordable = widePart * raysOfPixel / raysOfTree * options_.crop.area();
    const double pixels = std::min({options_.crop.area(), mostPixels, affordable});
    if (pixels < smallestGrowth * static_cast<double>(pilot_->pixelCount())) return false;
    measure(pixels);
    return true;
}

bool DepthSearch::halve(const Setting& setting) {
    const DepthChoice expensive = of(setting);
    const DepthChoice* cheap = nullptr;
    for (const DepthChoice& choice : choices_)
        if (smallestStep * choice.rays < expensive.rays && (!cheap || choice.rays > cheap->rays))
            cheap = &choice;
    if (!cheap) return false;
    const int depth = (cheap->max_recursion + expensive.max_recursion + 1) / 2;
    const double cutoff = roundedMean(cheap->cutoff, expensive.cutoff);
    if (has(depth, cutoff)) return false;
    choices_.push_back(pilot_->measured(depth, cutoff));
    return true;
}

const DepthChoice& DepthSearch::deeper(double part) {
    if (fine(part).error > part * target_)
        for (const DepthChoice& choice : front(part))
            if (!has(choice.max_recursion, choice.cutoff)) choices_.push_back(choice);
    return fine(part);
}

const DepthChoice& DepthSearch::fine(double part) const {
    const DepthChoice* fine = &*std::ranges::min_element(choices_, {}, &DepthChoice::error);
    for (const DepthChoice& choice : choices_)
        if (choice.error <= part * target_ && choice.rays < fine->rays) fine = &choice;
    return *fine;
}

const DepthChoice& DepthSearch::coarsest() const {
    for (const DepthChoice& depth : choices_)
        if (depth.error < target_) return depth;
    return choices_.back();
}

bool DepthSearch::has(int max_recursion, double cutoff) const {
    return std::ranges::any_of(choices_, [&](const DepthChoice& choice) {
        return choice.max_recursion == max_recursion && choice.cutoff == cutoff;
    });
}

}  // namespace raytracer
