// Measures the cost and the error of a scene's render with many settings.
//
// Two errors are measured apart: the rounding error of the arithmetic (the same samples in extended precision
// are the truth) and the error of too few samples and truncated recursion (a converged reference is the
// truth).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/accuracy/picture_error.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/pictures/image.h"
#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

struct TradeoffOptions {
    int size = 160;    // pixels of the long edge
    int samples = 64;  // most samples of a pixel
    int repeats = 3;   // timings of each setting near the front
    int threads = 0;
    Precision referencePrecision = Precision::Extended;
    std::function<void(const std::string&)> report;  // gets the current step, in words; may be empty
};

// One setting, rendered.
struct Trial {
    Setting setting;
    RenderCounts counts;
    PictureError error;
    std::vector<double> timings;  // processor seconds of a render, all threads together
    bool onFront = false;

    double seconds() const;  // their median
};

struct Reference {
    Setting setting;
    double cutoffBound = 0;    // upper bound on any pixel's error from the reference's own cutoff
    Setting half;              // half of the samples, and other ones
    double doublingError = 0;  // RMSE of `half` against the reference: larger than the reference's own error
    std::vector<glm::dvec3> colors;
};

// An example picture of the front.
struct Exhibit {
    Setting setting;
    PictureError error;
    ByteImage picture, difference;  // the difference in linear light, magnified
};
inline constexpr double exhibitMagnification = 16;

struct SceneTradeoff {
    std::string name;
    ImageSize size;
    ByteImage referencePicture;
    Reference reference;
    std::vector<Trial> truncation;  // against the reference, in double; the cheapest first
    std::vector<Trial> arithmetic;  // against the same samples in extended precision
    // The sampling error falls like (rays a pixel)^-sampleRate; empty if fewer than two points give the rate.
    std::optional<double> sampleRate;
    std::vector<Exhibit> exhibits;  // the cheapest first
};

SceneTradeoff measureTradeoff(const std::string& name, const SceneDescription& scene,
                              const TradeoffOptions& options);

// The steps of measureTradeoff.
Reference makeReference(const Renderer& renderer, const RenderOptions& options, int samples);
std::vector<Setting> settingsToTry(const Renderer& renderer, const RenderOptions& options,
                                   const Reference& reference, bool hasTextures, int samples);

// The rate of error = c cost^-rate, by least squares on the logarithms.
double fallRate(std::span<const CostAndError> points);

}  // namespace raytracer
