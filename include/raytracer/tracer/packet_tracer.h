// Traces neighbouring rays in packets, side by side in the lanes of vector registers. The colours are
// bit-identical to those of Scene::rayColor for each ray alone: packets are only faster.
#pragma once

#include "raytracer/numerics/packet_size.h"
#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// A few points of the picture, in pixels, (0, 0) at the top left, and the colours seen there.
struct PointPacket {
    static constexpr int most = packetWidth * packetHeight;

    int count = 0;
    alignas(32) Real x[most], y[most];
    alignas(32) Real color[3][most];  // within the range of double
    SampleTrace samples[most];

    void add(Real pointX, Real pointY, Observer* observer = nullptr) {
        x[count] = pointX;
        y[count] = pointY;
        samples[count++] = {.observer = observer};
    }
    glm::dvec3 colorOf(int i) const { return {color[0][i], color[1][i], color[2][i]}; }
};

// A Scene::tracePacket, compiled for one instruction set.
template <InstructionSet set>
void tracePacket(const Scene& scene, PointPacket& points, const RenderContext& context);

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
