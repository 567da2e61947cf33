// Renders pictures of a scene, or the colours at some points, on several threads.
#pragma once

#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene.h"
#include "raytracer/util/parallel.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// As onThreads, with the stack that options.max_recursion needs. Throws Error where no thread can have it.
void onTracingThreads(std::uint32_t jobs, const RenderOptions& options,
                      const std::function<void(JobQueue&)>& work);

// Renderer's functions (renderer.h), for a scene in this precision.
RenderCounts renderPicture(const Scene& scene, const RenderOptions& options, PixelSink& sink,
                           ProgressListener* progress, const FirstSamples* first);
RenderCounts renderPoints(const Scene& scene, const RenderOptions& options,
                          std::span<const glm::dvec2> points, std::span<glm::dvec3> colors);
RenderCounts traceRayTrees(const Scene& scene, const RenderOptions& options,
                           std::span<const glm::dvec2> points, RayTrees& trees);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
