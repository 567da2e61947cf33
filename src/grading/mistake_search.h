// Searches the known mistakes, one or two together, that explain a picture.
#pragma once

#include <memory>
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

}  // namespace raytracer
