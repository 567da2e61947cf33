#include "raytracer/accuracy/stratified_pilot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace raytracer {

namespace {

constexpr std::size_t strataCount = 8;  // more strata gain little (Cochran, 5A.8)

constexpr double evenPart = 0.1;  // of the sum of contrast, after adding

std::vector<std::size_t> orderOf(std::span<const double> contrast) {
    std::vector<std::size_t> order(contrast.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return contrast[i]; });
    return order;
}

// Up to `count` of the pixels at these indices, evenly spread, in the picture's order, so that neighbours
// share packets.
std::vector<PixelPlace> some(std::span<const PixelPlace> pixels, std::span<const std::size_t> indices,
                             std::size_t count) {
    const std::size_t taken = std::min(count, indices.size());
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < taken; ++k)
        places.push_back(indices[(2 * k + 1) * indices.size() / (2 * taken)]);
    std::ranges::sort(places);
    std::vector<PixelPlace> chosen;
    for (const std::size_t place : places) chosen.push_back(pixels[place]);
    return chosen;
}

}  // namespace

double evenContrast(double total, double count) {
    return total > 0 ? evenPart / (1 - evenPart) * total / count : 1;
}

void StratifiedPilot::add(std::span<const PixelPlace> pixels, std::span<const double> contrast,
                          std::size_t count) {
    Sample sample{{}, static_cast<double>(pixels.size())};
    const std::vector<std::size_t> order = orderOf(contrast);
    const double total = std::accumulate(contrast.begin(), contrast.end(), 0.0);
    const double even = evenContrast(total, sample.pixels), whole = total + even * sample.pixels;
    double sum = 0;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        const std::size_t number = sample.strata.size() + 1;
        const double limit = whole * static_cast<double>(number) / strataCount;
        while (end < order.size() && (end == begin || sum < limit || number == strataCount))
            sum += contrast[order[end++]] + even;
        const auto indices = std::span(order).subspan(begin, end - begin);
        sample.strata.push_back(
            {static_cast<double>(indices.size()) / sample.pixels,
             std::make_unique<Pilot>(renderer_, options_, some(pixels, indices, count / strataCount))});
    }
    samples_.push_back(std::move(sample));
}

// From the mean square of each stratum. The variance (Cochran, 12.32) has a term within the strata, from the
// second phase's pixels, and a term between them, from the first phase's.
template <class SquaredError>
ErrorEstimate StratifiedPilot::estimate(SquaredError squaredError) {
    MeanSquare all;
    for (Sample& sample : samples_) {
        MeanSquare whole;
        std::vector<double> means;
        for (Stratum& stratum : sample.strata) {
            const MeanSquare one = squaredError(*stratum.pilot);
            means.push_back(one.mean);
            whole.mean += stratum.share * one.mean;
            whole.variance += std::pow(stratum.share, 2) * one.variance;
        }
        for (std::size_t i = 0; i < means.size(); ++i)
            whole.variance += sample.strata[i].share * std::pow(means[i] - whole.mean, 2) / sample.pixels;
        all.mean += part(sample) * whole.mean;
        all.variance += std::pow(part(sample), 2) * whole.variance;
    }
    return rootOf(all);
}

ErrorEstimate StratifiedPilot::error(const Setting& setting, const Setting& truth) {
    return estimate([&](Pilot& pilot) { return pilot.squaredError(setting, truth); });
}

ErrorEstimate StratifiedPilot::error(const Setting& setting) {
    return estimate([&](Pilot& pilot) { return pilot.squaredError(setting); });
}

ErrorEstimate StratifiedPilot::errorOfShallow(const Setting& setting, const Setting& deep) {
    return estimate([&](Pilot& pilot) { return pilot.squaredErrorOfShallow(setting, deep); });
}

ErrorEstimate StratifiedPilot::errorOfFlat(const Setting& setting) {
    return estimate([&](Pilot& pilot) { return pilot.squaredErrorOfFlat(setting); });
}

void StratifiedPilot::sampleTruth(const Setting& depth, int n) {
    for (Sample& sample : samples_)
        for (Stratum& stratum : sample.strata) stratum.pilot->sampleTruth(depth, n);
}

double StratifiedPilot::part(const Sample& sample) const {
    double pixels = 0;
    for (const Sample& each : samples_) pixels += each.pixels;
    return sample.pixels / pixels;
}

double StratifiedPilot::rays(const Setting& setting) {
    double rays = 0;
    for (Sample& sample : samples_)
        for (Stratum& stratum : sample.strata)
            rays += part(sample) * stratum.share * stratum.pilot->rays(setting);
    return rays;
}

std::size_t StratifiedPilot::pixelCount() const {
    std::size_t count = 0;
    for (const Sample& sample : samples_)
        for (const Stratum& stratum : sample.strata) count += stratum.pilot->pixelCount();
    return count;
}

double StratifiedPilot::raysSpent() const {
    double spent = 0;
    for (const Sample& sample : samples_)
        for (const Stratum& stratum : sample.strata) spent += stratum.pilot->raysSpent();
    return spent;
}

}  // namespace raytracer
