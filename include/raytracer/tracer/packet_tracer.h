// Rays in packets: those that lie together are followed side by side, in the lanes of vector registers, for
// as long as they meet the same shape. A packet's numbers are Scene::rayColor's own, to the bit; it is only
// sooner there.
#pragma once

#include <span>

#include "raytracer/tracer/scene.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// What packet_tracer.cpp, compiled for an instruction set, offers.
struct PacketKernel {
    // Fills in the points' colours; x and y beyond count may change.
    void (*trace)(const Scene& scene, PointPacket& points, RenderContext& context);

    // The traversal alone, for benchmarks and tests: the nearest hits of up to PointPacket::most rays, which
    // leave the same side of the same shape, if any; with an end, any hit before it. (What coincides is left
    // to Scene::closestHit.)
    void (*meet)(const ShapeTree& tree, std::span<const Ray> rays, const RayEnd* end, std::span<Hit> hits);
};

template <InstructionSet set>
const PacketKernel& packetKernel();

// Null where it, or Real, has no packets.
const PacketKernel* packetKernel(InstructionSet set);

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
