// Points spread evenly over a picture, in pixels, for pilot samples.
#pragma once

#include <cstdint>
#include <vector>

#include "raytracer/pictures/pixels.h"
#include "raytracer/tracer/sample_sequence.h"

namespace raytracer {

// Who asks for points. The values are numbers of a SampleSequence; 0 is not among them, since its first point
// is always the centre. Where one command uses two of them they must differ: what has been chosen by some
// points looks better there than elsewhere. --target-time uses depth and then tiles, tradeoff depth and then
// depthsOfGrid.
enum class PointsFor : std::uint32_t {
    rayGrowth = 1,     // the estimate of a picture's rays before a render
    depth = 3,         // how deep is deep enough: for --target-error, and for the reference of tradeoff
    tiles = 4,         // the tiles that --target-time renders to estimate the time
    depthsOfGrid = 5,  // the depths that tradeoff tries, by their errors
};

inline std::vector<glm::dvec2> picturePoints(const ImageSize& size, std::size_t count, PointsFor purpose) {
    const SampleSequence points(static_cast<std::uint32_t>(purpose));
    std::vector<glm::dvec2> scattered;
    for (std::size_t i = 0; i < count; ++i)
        scattered.push_back(glm::dvec2(size.width, size.height) * points[static_cast<std::uint32_t>(i)]);
    return scattered;
}

}  // namespace raytracer
