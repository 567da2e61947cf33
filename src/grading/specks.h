// Recognises specks: single wrong pixels among right ones, made by rays that hit the surface that they leave.
#pragma once

#include <optional>
#include <span>

#include "picture_fit.h"
#include "raytracer/grading/diagnosis.h"

namespace raytracer {

// Names shadow acne if shadows on some lights of a pixel's ray tree give its bytes, reflection acne if a
// mirror that reflects itself does, or both. `wrong` are all wrong pixels, as numbers in reading order;
// `sample` has some of them, with their ray trees.
std::optional<NamedMistake> specksIn(const ByteImage& picture, const ByteImage& right,
                                     std::span<const std::size_t> wrong, const SceneDescription& scene,
                                     const Sample& sample);

}  // namespace raytracer
