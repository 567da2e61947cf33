// The core's interface: a scene, built in one of the precisions, that can be rendered.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>

#include "raytracer/bvh/build_options.h"
#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/explanation.h"
#include "raytracer/tracer/ray_tree.h"
#include "raytracer/tracer/render_options.h"
#include "raytracer/util/error.h"
#include "raytracer/util/progress.h"

namespace raytracer {

// The first sample of every pixel of a whole picture, as a render with options.samples 1 made them.
struct FirstSamples {
    std::vector<glm::dvec3> colors;  // row by row
    double cutoffBound = 0;          // RenderCounts::cutoffBound of that render
};

// A call for some pixels casts more reflected and refracted rays than this for each of its samples: where a
// material is both reflective and refractive they double with each bounce, to 2^32 at a depth of 32. Mirrors
// take one for each bounce, so no depth that a search tries is given up for them.
inline constexpr std::uint64_t mostRaysOfSample = 1024;
class TooManyRays : public Error {
  public:
    explicit TooManyRays(const RenderCounts& cast);
    const RenderCounts& cast() const { return cast_; }  // rays, until then

  private:
    RenderCounts cast_;
};

// Thread-safe: a Renderer does not change once it is made.
class Renderer {
  public:
    virtual ~Renderer() = default;

    // What it computes in, and whether the scene's numbers fit into that (numerics.h).
    virtual Precision precision() const = 0;
    virtual bool fits() const = 0;

    // Every pixel of options.part of options.crop goes to the sink exactly once, in runs within a tile; it
    // depends on the scene, the other options and its place alone. With `first`, of the same options but for
    // samples and adaptive, these are not cast again.
    virtual RenderCounts render(const RenderOptions& options, PixelSink& sink,
                                ProgressListener* progress = nullptr,
                                const FirstSamples* first = nullptr) const = 0;

    // The colours of samples at some points of the picture, in pixels, (0, 0) at its top left: colors[i] is
    // that of points[i]. Neighbours in the list are faster if they are neighbours in the picture.
    // These take pilot samples, for a search or before a render: this and rayTrees may throw TooManyRays.
    virtual RenderCounts renderPoints(const RenderOptions& options, std::span<const glm::dvec2> points,
                                      std::span<glm::dvec3> colors) const = 0;

    // The rays of such samples, those of points[i] as RayTrees::of(i); of Pass::Color.
    virtual RenderCounts rayTrees(const RenderOptions& options, std::span<const glm::dvec2> points,
                                  RayTrees& trees) const = 0;

    // The rays behind the centre of pixel (x, y) of the whole picture: the very ones that render follows for
    // it when options.samples is 1 and options.pass is Color.
    virtual RayExplanation explain(const RenderOptions& options, int x, int y) const = 0;
};

// Builds the scene's shapes and trees. The description may be dropped afterwards. In this precision, or in
// the next one that is wide enough for the scene's numbers.
std::unique_ptr<Renderer> makeRenderer(const SceneDescription& scene, Precision precision,
                                       const BuildOptions& options = {});

// The longer side of the film gets longEdge pixels, the other lround(longEdge * short / long), at least 1.
ImageSize imageSize(const CameraDescription& camera, int longEdge);

// Takes the terms that are a matter of the materials' colours out of the scene: what is left is rendered as
// it is.
void keepTerms(SceneDescription& scene, const Terms& terms);

// Reads every material as not refractive.
void makeOpaque(SceneDescription& scene);

}  // namespace raytracer
