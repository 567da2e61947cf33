// Specks: single wrong pixels among right ones, which rays make that meet again the surface they leave.
#pragma once

#include <optional>
#include <span>

#include "picture_fit.h"
#include "raytracer/grading/diagnosis.h"

namespace raytracer {

// Shadow acne, where a shadow on some lights of a pixel's ray tree gives its bytes; reflection acne, where a
// mirror that sees itself does; or both. `wrong`: all wrong pixels, numbered in reading order; `sample`: some
// of them, with their ray trees.
std::optional<NamedMistake> specksIn(const ByteImage& picture, const ByteImage& right,
                                     std::span<const std::size_t> wrong, const SceneDescription& scene,
                                     const Sample& sample);

}  // namespace raytracer
