// The core's interface: a scene, built in one of the precisions, that can be rendered.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "raytracer/bvh/build_options.h"
#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/contrast.h"
#include "raytracer/tracer/explanation.h"
#include "raytracer/tracer/ray_tree.h"
#include "raytracer/tracer/render_options.h"
#include "raytracer/util/error.h"
#include "raytracer/util/parallel.h"
#include "raytracer/util/progress.h"

namespace raytracer {

// The first sample of every pixel of a whole picture, as a render with options.samples 1 made them.
struct FirstSamples {
    std::vector<glm::dvec3> colors;  // row by row
    double cutoffBound = 0;          // RenderCounts::cutoffBound of that render
    // For each pixel, the weights of the rays that max_recursion and the cutoff left out, added up: how much
    // it may change by them, where a ray's colour is at most 1.
    std::vector<float> leftOut;
    std::vector<ExtraSample> extra;  // row by row
};

// A call for some pilot samples may cast this many reflected and refracted rays for each of them, on average;
// else it throws TooManyRays. Where a material is both reflective and refractive, the rays double with each
// bounce, to 2^32 at a depth of 32. Mirrors take one ray for each bounce, so no depth that a search tries is
// given up for them.
inline constexpr std::uint64_t mostRaysOfSample = 1024;
class TooManyRays : public Error {
  public:
    explicit TooManyRays(const RenderCounts& cast);
    const RenderCounts& cast() const { return cast_; }  // the rays cast until then

  private:
    RenderCounts cast_;
};

// Thread-safe: what a Renderer makes does not depend on what it made before.
class Renderer {
  public:
    virtual ~Renderer() = default;

    // The precision that it computes in, and whether the scene's numbers fit it (numerics.h).
    virtual Precision precision() const = 0;
    virtual bool fits() const = 0;

    // Sends every pixel of options.part of options.crop to the sink exactly once, in runs within a tile. A
    // pixel depends on the scene, the other options and its place alone. `first`: samples taken with the same
    // options, except for samples and adaptive; they are not taken again.
    virtual RenderCounts render(const RenderOptions& options, PixelSink& sink,
                                ProgressListener* progress = nullptr,
                                const FirstSamples* first = nullptr) const = 0;

    // The first sample of every pixel, and the extra samples.
    virtual RenderCounts renderFirst(RenderOptions options, FirstSamples& first) const = 0;

    // The colours of samples at some points of the picture, in pixels, (0, 0) at its top left: colors[i] is
    // that of points[i]. Points next to each other in the list are faster if they are neighbours in the
    // picture. For pilot samples, of a search or before a render: may throw TooManyRays, as may rayTrees.
    virtual RenderCounts renderPoints(const RenderOptions& options, std::span<const glm::dvec2> points,
                                      std::span<glm::dvec3> colors) const = 0;

    // The ray trees of such samples, always of Pass::Color: that of points[i] is RayTrees::of(i).
    virtual RenderCounts rayTrees(const RenderOptions& options, std::span<const glm::dvec2> points,
                                  RayTrees& trees) const = 0;

    // Finds what adaptive pictures of this size and crop, or of parts of it, need beforehand, and keeps it. A
    // render does that by itself: this is for one whose time counts.
    virtual void prepare(const RenderOptions& options) const = 0;

    // The rays behind the centre of pixel (x, y) of the whole picture: the very rays that `render` traces for
    // it with options.samples 1 and options.pass Color.
    virtual RayExplanation explain(const RenderOptions& options, int x, int y) const = 0;
};

// Builds the scene's shapes and trees in this precision or, where the scene's numbers do not fit it, in the
// next wider one that they fit (at most extended). The description may be dropped afterwards.
std::unique_ptr<Renderer> makeRenderer(const SceneDescription& scene, Precision precision,
                                       const BuildOptions& options = {});

// Bytes of a thread's stack for one reflection or refraction, more than it takes (test/tracer/core_stack.cpp
// measures it): 6 KB for a packet, 2 KB for a ray alone; several times as much where nothing is inlined, or
// with a sanitizer.
inline constexpr std::size_t recursionStack = std::size_t{64} << 10;

// As onThreads, with the stack that max_recursion needs: to trace rays, or to visit the tree that they make.
// Throws Error where no thread can have it.
void onTracingThreads(std::uint32_t jobs, int threads, int max_recursion,
                      const std::function<void(JobQueue&)>& work);

// The longer side of the film gets longEdge pixels, the other lround(longEdge * short / long), at least 1.
ImageSize imageSize(const CameraDescription& camera, int longEdge);

// Takes the terms that are off out of the scene's materials. Shadows and refraction are not among them:
// RenderOptions has these.
void keepTerms(SceneDescription& scene, const Terms& terms);

// Makes every material not refractive.
void makeOpaque(SceneDescription& scene);

}  // namespace raytracer
