// An observer of rayColor, for one camera ray and the rays that come of it. A render has none.
#pragma once

#include "raytracer/tracer/explanation.h"
#include "raytracer/tracer/shading.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

struct RayPath;

// Called for a single ray, or for its lane of a packet: the numbers are the same. The calls for the rays that
// it casts come between its `enter` and its `leave`.
class Observer {
  public:
    virtual ~Observer() = default;
    // Whether `shadow` needs the nearest shape in a light's way; if not, any will do.
    virtual bool asksWhatShadows() const = 0;

    virtual void enter(const Ray& ray, const RayPath& path) = 0;
    // K_D: color_diffuse times the texture's colour.
    virtual void meet(const Intersection& hit, const Color& K_D) = 0;
    // A shadow ray: the shape that it hit (null: none) and S_L. Comes before the light's own `light`.
    virtual void shadow(const Shape* by, const Color& S_L) = 0;
    // sum: the light's whole term.
    virtual void light(const DirectLight& direct, const Color& sum) = 0;
    virtual void terminate(RayKind kind, TerminationReason reason) = 0;
    virtual void leave(const Color& color) = 0;
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
