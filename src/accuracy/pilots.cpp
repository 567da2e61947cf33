#include "pilots.h"

#include <algorithm>
#include <cmath>

#include "depth.h"
#include "raytracer/accuracy/picture_error.h"

namespace raytracer {

SquaredError squaredErrorOf(std::span<const PilotPixel> pilots, double draws) {
    double first = 0, second = 0, third = 0;  // moments of a draw
    for (const PilotPixel& pixel : pilots) {
        const double value =
            pixel.weight * squaredError(pixel.own.color(), pixel.truth[0].color(), pixel.truth[1].color());
        const double part = pixel.draws / draws;
        first += part * value;
        second += part * value * value;
        third += part * value * value * value;
    }
    const double variance = std::max(0.0, second - first * first);
    const double thirdCentral = std::max(0.0, third - first * (3 * variance + first * first));
    const double skewness = variance > 0 ? thirdCentral / variance / std::sqrt(variance) : 0;
    const double deviations =
        standardErrors + skewness / std::sqrt(draws) / 6 * (1 + 2 * standardErrors * standardErrors);
    // The estimate may be negative by chance, or above the largest error that a picture can have.
    return {std::clamp(first, 0.0, 1.0), deviations * std::sqrt(variance / draws)};
}

Samples samplesOf(std::span<const PilotPixel> pilots, double draws, double pixels) {
    Samples samples;
    for (const PilotPixel& pixel : pilots) {
        const int own = pixel.own.samples();
        samples.ofPilots += own + 2 * pixel.truth[0].samples();
        samples.ofPicture += pixels * pixel.draws / draws * pixel.weight * own;
    }
    return samples;
}

bool isBetterToDraw(const SquaredError& error, const Samples& samples) {
    return error.margin * (1 - std::sqrt(0.5)) * samples.ofPicture > 1.5 * error.mean * samples.ofPilots;
}

}  // namespace raytracer
