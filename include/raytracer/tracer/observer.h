// Someone who watches rayColor at work. A render has none.
#pragma once

#include "raytracer/tracer/explanation.h"
#include "raytracer/tracer/shading.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

struct RayPath;

// S_L, and the shape that the shadow ray hit (first, if anyone asks for it), if any.
struct Shadow {
    Color factor{1};
    const Shape* by = nullptr;
};

class Observer {
  public:
    virtual ~Observer() = default;
    virtual bool asksWhatShadows() const {
        return false;
    }  // if not, any shape in a light's way will do as Shadow::by
    virtual void enter(const Ray& ray, const RayPath& path) = 0;
    virtual void meet(const ShadingPoint& point) = 0;
    virtual void light(const DirectLight& direct, const Shadow* shadow,
                       const Color& sum) = 0;  // null: no shadow ray
    virtual void notCast(RayKind kind, NotCast reason) = 0;
    virtual void leave(const Color& color) = 0;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
