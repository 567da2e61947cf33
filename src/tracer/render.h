// Pictures of a scene, or what is seen at some points, on several threads.
#pragma once

#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene.h"
#include "raytracer/util/parallel.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// onThreads, with the stack that rays of options.max_recursion need. Throws Error where no thread has it.
void onTracingThreads(std::uint32_t jobs, const RenderOptions& options,
                      const std::function<void(JobQueue&)>& work);

// As Renderer has them (renderer.h).
RenderCounts renderPicture(const Scene& scene, const RenderOptions& options, PixelSink& sink,
                           ProgressListener* progress, const FirstSamples* first);
RenderCounts renderPoints(const Scene& scene, const RenderOptions& options,
                          std::span<const glm::dvec2> points, std::span<glm::dvec3> colors);
RenderCounts traceRayTrees(const Scene& scene, const RenderOptions& options,
                           std::span<const glm::dvec2> points, RayTrees& trees);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
