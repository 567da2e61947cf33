// A scene in Real, and the recursion that sees it.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "raytracer/camera.h"
#include "raytracer/render_options.h"
#include "raytracer/shading.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// A render's own state while it follows rays; one for each thread.
struct RenderContext {
    const RenderOptions* options;
    RenderCounts counts;
};

class Scene {
  public:
    Camera camera;
    std::vector<Material> materials;  // shapes point into it: complete before the first shape is made
    std::vector<Light> lights;
    std::vector<std::unique_ptr<Shape>> shapes;
    std::vector<std::shared_ptr<const Texture>> textures;  // keeps alive what materials point to

    // The nearest intersection with t >= 0; where surfaces coincide, with the one listed first.
    Intersection closestIntersection(const Ray& ray, RenderContext& context) const;

    // The colour seen along a ray:
    // K_R I_R + K_T I_T + sum over lights (K_A I_AL + [K_D I_L (N.L) + K_S I_L (V.R)^n] S_L). A miss is black.
    Color rayColor(const Ray& ray, int max_recursion, RenderContext& context) const;

    // The colour of a point of the picture in pixels, (0, 0) at the top left.
    Color pointColor(Real x, Real y, RenderContext& context) const;

    // Every pixel of options.crop to the sink, by tiles on options.threads threads (render.cpp).
    RenderCounts render(const RenderOptions& options, PixelSink& sink, ProgressListener* progress) const;

  private:
    void traverse(const Ray& ray, HitQuery& query, RenderContext& context) const;
    Hit closestHit(const Ray& ray, HitQuery& query, RenderContext& context) const;
    Color shadowFactor(const ShadingPoint& point, const Vec3& toLight, const Light& light, RenderContext& context) const;
    Color lightColor(const ShadingPoint& point, RenderContext& context) const;
    Color reflectedColor(const ShadingPoint& point, int max_recursion, RenderContext& context) const;
    Color refractedColor(const ShadingPoint& point, int max_recursion, RenderContext& context) const;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
