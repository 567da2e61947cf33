// Searches what explains a picture: known mistakes, one or two together, or specks. Those are single wrong
// pixels among right ones, made by rays that hit the surface that they leave.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mistake.h"
#include "picture_fit.h"
#include "variant.h"

namespace raytracer {

// A scene, of which the right picture shows the `terms`, and what each mistake makes of it.
struct KnownVariants {
    KnownVariants(const SceneDescription& whole, RenderOptions options, const Terms& terms,
                  Precision precision);

    std::shared_ptr<RenderedScene> scene;
    Mistakes mistakes;
    std::vector<std::shared_ptr<Variant>> singles;
    ByteImage right;
    bool isSmall;  // whether building such a scene takes less than a tenth of a millisecond
};

struct Candidate {
    std::shared_ptr<Variant> variant;
    Fit fit;
};

using Candidates = std::vector<Candidate>;

// The variants that explain the picture, all equally well. Empty if none does.
Candidates explanationsOf(const ByteImage& picture, const SplitPixels& split, const KnownVariants& known);

// Names shadow acne if shadows on some lights of a pixel's ray tree give its bytes, reflection acne if a
// mirror that reflects itself does, or both. `wrong` are all wrong pixels, as numbers in reading order;
// `sample` has some of them, with their ray trees.
std::optional<NamedMistake> specksIn(const ByteImage& picture, const ByteImage& right,
                                     std::span<const std::size_t> wrong, const SceneDescription& scene,
                                     const Sample& sample);

}  // namespace raytracer
