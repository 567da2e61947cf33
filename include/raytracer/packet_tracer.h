// Rays in packets: those that lie together are followed side by side, in the lanes of vector registers, for as long as they
// meet the same shape. A packet's numbers are Scene::rayColor's own, to the bit; it is only sooner there.
#pragma once

#include "raytracer/scene.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// Fills in the points' colours; x and y beyond count may change.
using TracePacket = void (*)(const Scene& scene, PointPacket& points, RenderContext& context);

// For this processor's instruction set (bvh.h); null where it, or Real, has no packets.
TracePacket packetTracer();

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
