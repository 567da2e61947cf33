// SceneDescription to Scene.
#pragma once

#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Composes the transforms in long double, chooses the scene's frame, and rounds to Real once, at the end.
std::unique_ptr<const Scene> buildScene(const SceneDescription& description,
                                        const BuildOptions& options = {});

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
