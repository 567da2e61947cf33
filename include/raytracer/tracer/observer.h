// Someone who watches rayColor at work, for one camera ray and those that come of it. A render has none.
#pragma once

#include "raytracer/tracer/explanation.h"
#include "raytracer/tracer/shading.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct RayPath;

// Told of a ray alone, or of its lane of a packet: the numbers are the same. What a ray sends on comes
// between its `enter` and its `leave`.
class Observer {
  public:
    virtual ~Observer() = default;
    // If not, any shape in a light's way will do for `shadow`.
    virtual bool asksWhatShadows() const = 0;

    virtual void enter(const Ray& ray, const RayPath& path) = 0;
    // K_D: color_diffuse times the texture's colour.
    virtual void meet(const Intersection& hit, const Color& K_D) = 0;
    // A shadow ray: what it hit (null: nothing) and S_L. Before the light's own `light`.
    virtual void shadow(const Shape* by, const Color& S_L) = 0;
    // sum: the light's whole term.
    virtual void light(const DirectLight& direct, const Color& sum) = 0;
    virtual void terminate(RayKind kind, TerminationReason reason) = 0;
    virtual void leave(const Color& color) = 0;
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
