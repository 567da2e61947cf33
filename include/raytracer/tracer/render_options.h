// What the user asks of a render, and what a render has counted.
#pragma once

#include <cstddef>
#include <cstdint>

#include "raytracer/pictures/pixels.h"
#include "raytracer/pictures/tiles.h"

namespace raytracer {

enum class Precision { Float, Double, Extended };

// In the same order.
inline constexpr const char* precisionNames[] = {"float", "double", "extended"};
inline const char* precisionName(Precision precision) {
    return precisionNames[static_cast<std::size_t>(precision)];
}

// What a pixel shows: the light model, or one of the stages on the way to it.
enum class Pass {
    Color,    // the light model
    Raycast,  // color_diffuse of the closest hit
    Normals,  // (N + 1) / 2 of the unit exterior normal; a miss is 54/255
};

// The terms of the light model; one that is off is left out of the sum.
struct Terms {
    bool ambient = true, diffuse = true, specular = true;
    bool shadows = true;  // coloured by refractive shapes, whether or not `refraction` is on
    bool reflections = true, refraction = true;
    bool textures = true;
    bool operator==(const Terms&) const = default;
};

// The most that a command line may ask for.
inline constexpr int mostRecursion = 1000, mostSamples = 65536;

// The knobs that trade speed for accuracy. The default values are those of the command line.
struct Setting {
    int samples = 1;      // for each pixel, at the first points of the sequence, box-filtered; 1: its centre
    double adaptive = 0;  // > 0: a pixel takes `samples` at most, and stops when its weighted error
                          // (pixel_estimate.h) is at most this
    int max_recursion = 3;
    double cutoff = 0;      // a reflected or refracted ray that changes its sample by less is not cast
    bool bilinear = false;  // textures: the four nearest texels, weighted, instead of the nearest one

    bool operator==(const Setting&) const = default;
};

struct RenderOptions : Setting {
    ImageSize size;       // of the whole picture
    PixelRectangle crop;  // the rectangle to render
    PicturePart part{};   // its tiles to render
    Pass pass = Pass::Color;
    bool shadows = true, refraction = true;  // the terms that keepTerms cannot take out of the materials
    int threads = 0;                         // 0: one for each processor
    std::uint32_t sequence = 0;  // of the samples; another one is for measuring the error of this one
};

// Rays cast and intersection tests made (of shapes and triangles, not of boxes).
struct RenderCounts {
    std::uint64_t primary = 0, shadow = 0, reflection = 0, refraction = 0;
    std::uint64_t tests = 0;
    std::uint64_t limited = 0;  // pixels that `samples` stopped before they reached `adaptive`
    // An upper bound on the change of any one pixel by the rays that RenderOptions::cutoff has left out, for
    // the samples that were taken. It does not cover that without the cutoff `adaptive` might have taken
    // other samples.
    double cutoffBound = 0;

    std::uint64_t onwards() const { return reflection + refraction; }
    std::uint64_t all() const { return primary + shadow + onwards(); }
    RenderCounts& operator+=(const RenderCounts& other);
};

}  // namespace raytracer
