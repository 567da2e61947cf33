// What each setting of a scene's render costs and how far off its picture is, measured.
//
// Two questions, kept apart: how far off the samples that are taken are for the arithmetic they are computed
// in (the same samples, against extended precision), and how far off the picture is for the samples and the
// rays that are left out (against a converged reference).
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/accuracy/pilot.h"
#include "raytracer/pictures/image.h"
#include "raytracer/scene/scene_description.h"

namespace raytracer {

struct TradeoffOptions {
    int size = 160;   // pixels of the long edge
    int samples = 8;  // the grid's settings up to so many, squared
    int repeats = 3;  // of every timing of what is near the front
    int threads = 0;
    Precision referencePrecision = Precision::Extended;
    std::function<void(const std::string&)> tell;  // what is being done, for the impatient; may be empty
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
    double cutoffBound = 0;    // the most that its own cutoff can have changed a pixel
    Setting half;              // half of its samples,
    double doublingError = 0;  // and their RMSE against it: an upper estimate of its own error
    std::vector<glm::dvec3> colors;
};

// A picture of the front, to be looked at.
struct Exhibit {
    Setting setting;
    PictureError error;
    ByteImage picture, difference;  // difference: of linear light, magnified
};
inline constexpr double exhibitMagnification = 16;

struct SceneTradeoff {
    std::string name;
    ImageSize size;
    ByteImage referencePicture;
    Reference reference;
    std::vector<Trial> truncation;  // against the reference, in double; from the cheapest on
    std::vector<Trial> arithmetic;  // against the same samples in extended precision
    // The error between the samples falls like (rays a pixel)^-sampleRate; none where fewer than two of them
    // tell.
    std::optional<double> sampleRate;
    std::vector<Exhibit> exhibits;  // from the cheapest on
};

SceneTradeoff measureTradeoff(const std::string& name, const SceneDescription& scene,
                              const TradeoffOptions& options);

// The parts of it, each in a file of its own.
Reference makeReference(const Renderer& renderer, const RenderOptions& options, int samples);
std::vector<Setting> settingsToTry(const Renderer& renderer, const RenderOptions& options,
                                   const Reference& reference, bool hasTextures, int samples);

// The slope of a line through the logarithms: error = c cost^-rate.
double fallRate(std::span<const CostAndError> points);

}  // namespace raytracer
