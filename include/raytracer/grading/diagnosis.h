// Finds out what is wrong with a picture, by comparing it with
// the pictures that known mistakes make of the same scene.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/pictures/image.h"
#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

// How well the picture that a mistake makes explains another one.
struct Fit {
    double explained = 0;     // the share of the wrong pixels whose bytes are those that the mistake makes
    double contradicted = 0;  // right pixels that the mistake makes wrong, as a share of the wrong ones
    std::size_t sampled = 0;  // number of pixels that the shares were measured on
    std::size_t unknown = 0;  // number of others, for which the mistake's bytes are not known (glass)
    // If the mistake's whole picture was made: the pixels that differ from it, however rounding decides.
    std::optional<std::uint64_t> off{};
    // Pixels that would not differ if rounding decided otherwise which of two surfaces in one place is
    // nearer, or whether an eye that lies on a surface sees it.
    std::uint64_t rounded = 0;

    bool isExact() const { return off == 0U && rounded == 0; }
    double net() const { return explained - contradicted; }
};

// One mistake, or two together, that explain a picture.
struct NamedMistake : Fit {
    std::string what{};  // follows "the picture": "without specular light"
    std::string hint{};  // what the author may check: one sentence, or empty
};

struct Diagnosis {
    std::uint64_t pixels = 0, wrong = 0;  // all pixels, and those that differ from the right picture
    bool isRounding = false;              // few are wrong, by 1 of 255: the program is right
    std::vector<NamedMistake> mistakes;   // at most three, which explain the picture equally well
    std::string unnamed{};                // for a wrong picture without names: why there are none

    // "without specular light", or "A, or B"; empty if there are no mistakes.
    std::string names() const;
    std::vector<std::string> hints() const;  // the mistakes' hints, without repetitions
    // "equals the picture without specular light (0 of 360000 pixels differ; 41022 differ from the right
    // one)", "is, but for 6 of 360000 pixels, the picture ...", "is, but for 6 of 360000 pixels that rounding
    // decides, the picture ..." or "is wrong: 99 % of its 41022 wrong pixels are as in the picture ...";
    // empty if there are no mistakes.
    std::string sentence() const;
};

struct KnownVariants;  // src/grading/mistake_search.h

// Names the mistakes in pictures of one scene. The pictures of mistakes are made when they are first needed;
// their scenes are kept for later calls.
class MistakeNamer {
  public:
    // `options` are those of a render of the right picture; samples and adaptive are ignored. The right
    // picture has the `terms` of the scene. A wrong one may have others.
    MistakeNamer(const SceneDescription& scene, const RenderOptions& options, const Terms& terms = {},
                 Precision precision = Precision::Double);
    ~MistakeNamer();
    MistakeNamer(const MistakeNamer&) = delete;
    MistakeNamer& operator=(const MistakeNamer&) = delete;

    const ByteImage& right() const;

    // Names no mistake if the picture is right except for rounding, or if none explains nearly all of it: a
    // wrong name is worse than none. Throws Error if the sizes differ.
    Diagnosis diagnose(const ByteImage& picture) const;

  private:
    std::unique_ptr<KnownVariants> known_;
};

}  // namespace raytracer
