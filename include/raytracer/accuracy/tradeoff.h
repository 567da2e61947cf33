// Measures the cost and the error of a scene's render with many settings.
//
// Two errors are measured separately. For the rounding error of the arithmetic, the truth is the same samples
// in extended precision. For the error of too few samples and truncated recursion, it is a converged
// reference in double, in which all settings are measured: its rounding error is far smaller, and surfaces
// that touch up to the rounding of their decimals touch in both.
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
    int repeats = 3;   // timings of each setting near the Pareto front
    int threads = 0;
    std::function<void(const std::string&)> report;  // called with the current step's name; may be empty
};

// One setting, rendered.
struct Trial {
    Setting setting;
    Precision precision = Precision::Double;
    RenderCounts counts{};
    PictureError error{};
    std::vector<double> timings{};  // processor seconds of each render, summed over all threads
    bool onFront = false;

    double seconds() const;  // the median of `timings`
};

struct Reference {
    Setting setting;
    double cutoffBound = 0;    // upper bound on any pixel's error from the reference's own cutoff
    Setting half;              // half as many samples, from another sequence
    double doublingError = 0;  // RMSE of `half` against the reference: larger than the reference's own error
    std::vector<glm::dvec3> colors;
};

// An example picture: a setting on the front.
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
    // The sampling error falls like (samples per pixel)^-sampleRate. Empty if fewer than two points are
    // usable.
    std::optional<double> sampleRate;
    std::vector<Exhibit> exhibits;  // the cheapest first
};

SceneTradeoff measureTradeoff(const std::string& name, const SceneDescription& scene,
                              const TradeoffOptions& options);

// The steps of measureTradeoff.
Reference makeReference(const Renderer& renderer, const RenderOptions& options, int samples);
std::vector<Setting> settingsToTry(const Renderer& renderer, const RenderOptions& options,
                                   const Reference& reference, bool hasTextures, int samples);

// The rate in error = c cost^-rate, fitted by least squares to the logarithms.
double fallRate(std::span<const CostAndError> points);

}  // namespace raytracer
