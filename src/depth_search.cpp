#include "depth_search.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "target_statistics.h"

namespace raytracer {

namespace {

constexpr double lookPart = 1.0 / 400, leastLook = 500;  // of the picture's pixels: looked at before its cost is known
constexpr double widePart = 0.005;    // of the picture's rays, for each depth that is looked at again: ten are a twentieth
constexpr double mostPixels = 100000;  // see what is in three of 100,000, missed in 1 of 20; and are 2.4 MB for each depth
constexpr double worthHalving = 1.1;  // a step of the rays
constexpr double worthwhile = 4;      // times the pixels before: half the standard error

// Of cutoffs the ones that leave an error of the target's order: on the scenes a cutoff's RMSE is 1/30 to 1/300 of it.
std::vector<double> cutoffsFor(double target) {
    std::vector<double> cutoffs;
    for (const double cutoff : gridCutoffs)
        if (cutoff >= 9 * target && cutoff <= 110 * target) cutoffs.push_back(cutoff);
    if (cutoffs.empty()) cutoffs.push_back(target > 0.01 ? std::end(gridCutoffs)[-1] : gridCutoffs[0]);
    return cutoffs;
}

// The grid's next smaller cutoff, put before the others; false if there is none.
bool addSmaller(std::vector<double>& cutoffs) {
    const auto* next = std::ranges::find(gridCutoffs, cutoffs.front());
    if (next == std::begin(gridCutoffs)) return false;
    cutoffs.insert(cutoffs.begin(), next[-1]);
    return true;
}

// A part of the picture's pixels; but no fewer than tell anything.
std::size_t firstPixels(const PixelRectangle& crop) {
    return static_cast<std::size_t>(std::min(crop.area(), std::max(leastLook, lookPart * crop.area())));
}

}  // namespace

DepthSearch::DepthSearch(const Renderer& renderer, const RenderOptions& options, double target)
    : renderer_(renderer), options_(options), target_(target),
      deepest_{.max_recursion = 32, .cutoff = std::min(0.1, 3 * target), .bilinear = options.bilinear},
      pilot_(std::make_unique<Pilot>(renderer, options, scatteredPixels(options.crop, firstPixels(options.crop), 1))) {
    std::vector<double> cutoffs = cutoffsFor(target);
    do choices_ = depthFront(*pilot_, deepest_, cutoffs, enough * target);
    while (choices_.back().error > enough * target && addSmaller(cutoffs));
}

bool DepthSearch::widen(double raysOfPixel) {
    const double area = options_.crop.area();
    const double affordable = widePart * raysOfPixel / pilot_->rays(deepest_) * area;
    const double pixels = std::min({area, mostPixels, affordable});
    if (pixels < worthwhile * static_cast<double>(pilot_->pixelCount())) return false;
    spent_ += pilot_->raysSpent();
    pilot_ = std::make_unique<Pilot>(renderer_, options_, scatteredPixels(options_.crop, static_cast<std::size_t>(pixels), 1));
    const DepthChoice* const deep = &fine();
    for (DepthChoice& choice : choices_) {
        const bool isTooShallow = choice.error > target_ && &choice != deep;
        choice.error = isTooShallow ? std::numeric_limits<double>::infinity() : measured(choice.max_recursion, choice.cutoff);
        if (!isTooShallow) choice.rays = pilot_->rays(setting(choice.max_recursion, choice.cutoff));
    }
    goDeeper(enough);
    return true;
}

// By the grid's steps: more bounces, and where they tell no more, a smaller cutoff.
void DepthSearch::goDeeper(double part) {
    DepthChoice last = *std::ranges::min_element(choices_, {}, &DepthChoice::error);
    bool mayBeDeeper = true;
    while (last.error > part * target_) {
        const auto* deeper = std::ranges::upper_bound(gridDepths, last.max_recursion);
        const auto* cutoff = std::ranges::lower_bound(gridCutoffs, last.cutoff);
        const double before = last.error;
        if (mayBeDeeper && deeper != std::end(gridDepths)) last = add(*deeper, last.cutoff);
        else if (cutoff != std::begin(gridCutoffs)) last = add(last.max_recursion, cutoff[-1]);
        else return;
        mayBeDeeper = last.error < 0.99 * before;
    }
}

bool DepthSearch::halve(const Setting& setting) {
    const DepthChoice dear = of(setting);
    const DepthChoice* cheap = nullptr;
    for (const DepthChoice& choice : choices_)
        if (choice.rays < dear.rays && (!cheap || choice.rays > cheap->rays)) cheap = &choice;
    if (!cheap || dear.rays < worthHalving * cheap->rays) return false;
    const int depth = (cheap->max_recursion + dear.max_recursion + 1) / 2;
    const double cutoff = roundedMean(cheap->cutoff, dear.cutoff);
    if (std::ranges::any_of(choices_, [&](const DepthChoice& c) { return c.max_recursion == depth && c.cutoff == cutoff; }))
        return false;
    add(depth, cutoff);
    return true;
}

DepthChoice DepthSearch::add(int depth, double cutoff) {
    const double rays = pilot_->rays(setting(depth, cutoff));
    choices_.push_back({depth, cutoff, rays, measured(depth, cutoff)});
    return choices_.back();
}

const DepthChoice& DepthSearch::deeper(double part) {
    goDeeper(part);
    return fine(part);
}

const DepthChoice& DepthSearch::fine(double part) const {
    const DepthChoice* fine = &*std::ranges::min_element(choices_, {}, &DepthChoice::error);
    for (const DepthChoice& choice : choices_)
        if (choice.error <= part * target_ && choice.rays < fine->rays) fine = &choice;
    return *fine;
}

const DepthChoice& DepthSearch::of(const Setting& setting) const {
    return *std::ranges::find_if(choices_, [&](const DepthChoice& depth) {
        return depth.max_recursion == setting.max_recursion && depth.cutoff == setting.cutoff;
    });
}

const DepthChoice& DepthSearch::coarsest() const {
    for (const DepthChoice& depth : choices_)
        if (depth.error < target_) return depth;
    return choices_.back();
}

double DepthSearch::distance(const DepthChoice& a, const DepthChoice& b) {
    return pilot_->error(setting(a.max_recursion, a.cutoff), setting(b.max_recursion, b.cutoff)).rmse;
}

double DepthSearch::measured(int depth, double cutoff) { return pilot_->error(setting(depth, cutoff), deepest_).rmse; }

Setting DepthSearch::setting(int depth, double cutoff) const {
    Setting setting = deepest_;
    setting.max_recursion = depth;
    setting.cutoff = cutoff;
    return setting;
}

}  // namespace raytracer
