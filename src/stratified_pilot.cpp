#include "raytracer/stratified_pilot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raytracer {

namespace {

constexpr std::size_t strataCount = 8;  // more gain little: Cochran, 5A.8

// Of a pixel's size (its weight in the choice) this part is the same for all: what looked flat may not be.
constexpr double evenPart = 0.3;

std::vector<std::size_t> orderOf(std::span<const double> activity) {
    std::vector<std::size_t> order(activity.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return activity[i]; });
    return order;
}

// `count` of them, evenly spread; all if there are no more.
std::vector<PixelPlace> some(std::span<const PixelPlace> pixels, std::span<const std::size_t> indices, std::size_t count) {
    const std::size_t taken = std::min(count, indices.size());
    std::vector<PixelPlace> chosen;
    for (std::size_t k = 0; k < taken; ++k) chosen.push_back(pixels[indices[(2 * k + 1) * indices.size() / (2 * taken)]]);
    return chosen;
}

}  // namespace

StratifiedPilot::StratifiedPilot(const Renderer& renderer, const RenderOptions& options, std::span<const PixelPlace> pixels,
                                 std::span<const double> activity, std::size_t count)
    : looked_(static_cast<double>(pixels.size())) {
    const std::vector<std::size_t> order = orderOf(activity);
    const double total = std::accumulate(activity.begin(), activity.end(), 0.0);
    const double even = total > 0 ? evenPart / (1 - evenPart) * total / looked_ : 1;
    const double whole = total + even * looked_;
    double sum = 0;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        const double limit = whole * static_cast<double>(strata_.size() + 1) / strataCount;
        while (end < order.size() && (end == begin || sum < limit || strata_.size() + 1 == strataCount))
            sum += activity[order[end++]] + even;
        const auto indices = std::span(order).subspan(begin, end - begin);
        strata_.push_back({static_cast<double>(indices.size()) / looked_,
                           std::make_unique<Pilot>(renderer, options, some(pixels, indices, count / strataCount))});
    }
}

PictureError StratifiedPilot::error(const Setting& setting, const Setting& truth) {
    std::vector<PictureError> errors;
    PictureError whole;
    double mean = 0, variance = 0;  // of the pixels' squared errors; of their mean
    for (Stratum& stratum : strata_) {
        const PictureError& error = errors.emplace_back(stratum.pilot->error(setting, truth));
        mean += stratum.share * error.rmse * error.rmse;
        variance += std::pow(stratum.share * 2 * error.rmse * error.standardError, 2);
        whole.maximum = std::max(whole.maximum, error.maximum);
        whole.shareOff += stratum.share * error.shareOff;
    }
    for (std::size_t i = 0; i < strata_.size(); ++i)
        variance += strata_[i].share * std::pow(errors[i].rmse * errors[i].rmse - mean, 2) / looked_;
    whole.rmse = std::sqrt(mean);
    if (mean > 0) whole.standardError = std::sqrt(variance) / (2 * whole.rmse);
    whole.psnr = -20 * std::log10(whole.rmse);
    return whole;
}

double StratifiedPilot::rays(const Setting& setting) {
    double rays = 0;
    for (Stratum& stratum : strata_) rays += stratum.share * stratum.pilot->take(setting).rays;
    return rays;
}

std::size_t StratifiedPilot::pixelCount() const {
    std::size_t count = 0;
    for (const Stratum& stratum : strata_) count += stratum.pilot->pixelCount();
    return count;
}

double StratifiedPilot::raysSpent() const {
    double spent = 0;
    for (const Stratum& stratum : strata_) spent += stratum.pilot->raysSpent();
    return spent;
}

}  // namespace raytracer
