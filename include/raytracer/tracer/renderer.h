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
#include "raytracer/util/progress.h"

namespace raytracer {

// The first sample of every pixel of a whole picture, as a render with options.samples 1 made them.
struct FirstSamples {
    std::vector<glm::dvec3> colors;  // row by row
    double cutoffBound = 0;          // RenderCounts::cutoffBound of that render
};

// Thread-safe: a Renderer does not change once it is made.
class Renderer {
  public:
    virtual ~Renderer() = default;

    // Every pixel of options.crop goes to the sink exactly once; it depends on the scene, options and its
    // place alone. With `first`, of the same options but for samples and adaptive, these are not cast again.
    virtual RenderCounts render(const RenderOptions& options, PixelSink& sink,
                                ProgressListener* progress = nullptr,
                                const FirstSamples* first = nullptr) const = 0;

    // The colours of samples at some points of the picture, in pixels, (0, 0) at its top left: colors[i] is
    // that of points[i]. Neighbours in the list are faster if they are neighbours in the picture.
    virtual RenderCounts renderPoints(const RenderOptions& options, std::span<const glm::dvec2> points,
                                      std::span<glm::dvec3> colors) const = 0;

    // The rays of such samples, those of points[i] as RayTrees::of(i); of Pass::Color.
    virtual RenderCounts rayTrees(const RenderOptions& options, std::span<const glm::dvec2> points,
                                  RayTrees& trees) const = 0;

    // The rays behind the centre of pixel (x, y) of the whole picture: the very ones that render follows for
    // it when options.samples is 1 and options.pass is Color.
    virtual RayExplanation explain(const RenderOptions& options, int x, int y) const = 0;
};

// Builds the scene's shapes and trees. The description may be dropped afterwards.
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
