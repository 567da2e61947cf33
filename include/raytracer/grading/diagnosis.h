// What is wrong with a picture: it is held against the pictures that known mistakes make of the same scene.
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
    double explained = 0;     // the share of the wrong pixels that have the bytes which the mistake makes
    double contradicted = 0;  // right pixels that the mistake has wrong, as a share of the wrong ones
    std::size_t sampled = 0;  // pixels that the shares were measured on
    std::size_t unknown = 0;  // more of them, of which it is not known what the mistake makes: glass
    // Of the whole picture, where it was made: those that differ all the same, whatever rounding decides.
    std::optional<std::uint64_t> off{};
    // Those that would not differ if rounding decided otherwise which of two surfaces in one place is nearer,
    // or whether an eye sees the surface that it lies on.
    std::uint64_t rounded = 0;

    bool isExact() const { return off == 0U && rounded == 0; }
    double net() const { return explained - contradicted; }
};

// One or two mistakes that explain a picture.
struct NamedMistake : Fit {
    std::string what{};  // follows "the picture": "without specular light"
    std::string hint{};  // what the author may check: one sentence, or empty
};

struct Diagnosis {
    std::uint64_t pixels = 0, wrong = 0;  // of the picture; wrong: different from the right one
    bool isRounding = false;              // few are wrong, and by 1 of 255: the picture of a right program
    std::vector<NamedMistake> mistakes;   // at most three, which explain the picture equally well

    // "without specular light", or "A, or B"; empty without a name.
    std::string names() const;
    std::vector<std::string> hints() const;  // of the mistakes, each once
    // "equals the picture without specular light (0 of 360000 pixels differ; 41022 differ from the right
    // one)", "is, but for 6 of 360000 pixels, the picture ...", "is, but for 6 of 360000 pixels that rounding
    // decides, the picture ..." or "is wrong: 99 % of its 41022 wrong pixels are as in the picture ...";
    // empty without a name.
    std::string sentence() const;
};

struct KnownVariants;  // src/grading/mistake_search.h

// Of one scene, with the options of its right picture. The pictures of mistakes are made when they are first
// needed, and their scenes kept for the pictures to come.
class MistakeNamer {
  public:
    // `options` as for a render of the whole picture; samples and adaptive are ignored. The right picture has
    // these terms of the scene, others can be in a wrong one.
    MistakeNamer(const SceneDescription& scene, const RenderOptions& options, const Terms& terms = {},
                 Precision precision = Precision::Double);
    ~MistakeNamer();
    MistakeNamer(const MistakeNamer&) = delete;
    MistakeNamer& operator=(const MistakeNamer&) = delete;

    const ByteImage& right() const;

    // Names nothing where the picture is right but for roundings, and where nothing explains nearly all of
    // it: a wrong name is worse than none. Throws Error if the sizes differ.
    Diagnosis diagnose(const ByteImage& picture) const;

  private:
    std::unique_ptr<KnownVariants> known_;
};

}  // namespace raytracer
