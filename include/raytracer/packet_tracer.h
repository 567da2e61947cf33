// Rays in packets: those that lie together are followed side by side, in the lanes of vector registers, for as long as they
// meet the same shape. A packet's numbers are Scene::rayColor's own, to the bit; it is only sooner there.
#pragma once

#include <span>

#include "raytracer/scene.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// The colours of points of the picture, as Scene::pointColors has them.
using TracePackets = void (*)(const Scene& scene, std::span<const Vec2> points, std::span<PointColor> colors,
                              RenderContext& context);

// For this processor's instruction set (bvh.h); null where it, or Real, has no packets.
TracePackets packetTracer();

// Packets of this many points are filled best.
inline constexpr int packetWidth = 4, packetHeight = 2;

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
