// Colours seen at points of the picture, traced a packet at a time.
#pragma once

#include <cstddef>

#include <glm/vec2.hpp>

#include "raytracer/tracer/packet_tracer.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Fills in the points' colours, by a packet or one point at a time.
void traceAll(const Scene& scene, PointPacket& points, const RenderContext& context);

// Calls take(owner, color, trace) for each point, in the order in which they were added; for the last ones in
// finish(). A colour depends on its own point only, but neighbouring points are faster.
template <class Take>
class PointStream {
  public:
    PointStream(const Scene& scene, const RenderContext& context, Take take)
        : scene_(scene), context_(context), take_(take) {}

    void add(std::size_t owner, const glm::dvec2& point, Observer* observer = nullptr) {
        owners_[points_.count] = owner;
        points_.add(static_cast<Real>(point.x), static_cast<Real>(point.y), observer);
        if (points_.count == PointPacket::most) finish();
    }

    void finish() {
        if (points_.count == 0) return;
        traceAll(scene_, points_, context_);
        for (int i = 0; i < points_.count; ++i) take_(owners_[i], points_.colorOf(i), points_.samples[i]);
        points_.count = 0;
    }

  private:
    const Scene& scene_;
    const RenderContext& context_;
    Take take_;
    PointPacket points_;
    std::size_t owners_[PointPacket::most];
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
