// Points spread evenly over a picture, in pixels, for pilot samples.
#pragma once

#include <vector>

#include "raytracer/pictures/pixels.h"
#include "raytracer/tracer/sample_sequence.h"

namespace raytracer {

inline std::vector<glm::dvec2> picturePoints(const ImageSize& size, std::size_t count,
                                             std::uint32_t sequence) {
    const SampleSequence points(sequence);
    std::vector<glm::dvec2> scattered;
    for (std::size_t i = 0; i < count; ++i)
        scattered.push_back(glm::dvec2(size.width, size.height) * points[static_cast<std::uint32_t>(i)]);
    return scattered;
}

}  // namespace raytracer
