#include "raytracer/packet_tracer.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// packet_tracer.cpp, compiled for each instruction set.
#if !defined(RAYTRACER_PRECISION_extended)
inline namespace lanes_plain {
void tracePacket(const Scene& scene, PointPacket& points, RenderContext& context);
}
#if defined(RAYTRACER_AVX2_LANES)
namespace lanes_avx2 {
void tracePacket(const Scene& scene, PointPacket& points, RenderContext& context);
}
#endif
#endif

TracePacket packetTracer() {
#if defined(RAYTRACER_PRECISION_extended)
    return nullptr;  // no processor has long doubles side by side
#else
    if (instructionSet() == InstructionSet::Scalar) return nullptr;
#if defined(RAYTRACER_AVX2_LANES)
    if (instructionSet() == InstructionSet::Avx2) return lanes_avx2::tracePacket;
#endif
    return lanes_plain::tracePacket;
#endif
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
