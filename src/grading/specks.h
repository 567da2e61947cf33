// Specks: single wrong pixels among right ones, which rays make that meet again the surface they leave.
#pragma once

#include <optional>
#include <span>

#include "raytracer/grading/diagnosis.h"
#include "raytracer/tracer/explanation.h"

namespace raytracer {

// Some wrong pixels with their ray trees.
struct SpeckSample {
    const SceneDescription& scene;
    std::span<const PixelPlace> pixels;
    std::span<const RayExplanation> trees;
};

// Shadow acne, where a shadow on some lights of a pixel's ray tree gives its bytes; reflection acne, where a
// mirror that sees itself does; or both. `wrong`: all wrong pixels, numbered in reading order.
std::optional<NamedMistake> specksIn(const ByteImage& picture, const ByteImage& right,
                                     std::span<const std::size_t> wrong, const SpeckSample& sample);

}  // namespace raytracer
