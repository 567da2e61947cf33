// What a picture takes, where it is more than its author may think.
#pragma once

#include "raytracer/tracer/renderer.h"
#include "render_arguments.h"

namespace raytracer::commands {

// Says how many rays a deep recursion casts, where they are many.
void remarkOnRays(const RenderArguments& arguments, const SceneDescription& scene, const Renderer& renderer,
                  const RenderOptions& options);

// Says how long the picture, or this part of it, takes, where that is long.
void remarkOnTime(const RenderArguments& arguments, const Renderer& renderer, const RenderOptions& options);

// "under 0.01 s", "4.50 s", "12 min", "3.5 h", "2.1 days".
std::string durationInWords(double seconds);

}  // namespace raytracer::commands
