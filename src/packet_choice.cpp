#include "raytracer/packet_tracer.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// packet_tracer.cpp, compiled for each instruction set.
#if !defined(RAYTRACER_PRECISION_extended)
inline namespace lanes_plain {
void tracePackets(const Scene& scene, std::span<const Vec2> points, std::span<PointColor> colors, RenderContext& context);
}
#if defined(__x86_64__)
namespace lanes_avx2 {
void tracePackets(const Scene& scene, std::span<const Vec2> points, std::span<PointColor> colors, RenderContext& context);
}
#endif
#endif

TracePackets packetTracer() {
#if defined(RAYTRACER_PRECISION_extended)
    return nullptr;  // no processor has long doubles side by side
#else
    switch (instructionSet()) {
#if defined(__x86_64__)
        case InstructionSet::Avx2: return lanes_avx2::tracePackets;
#endif
        case InstructionSet::Sse2: return lanes_plain::tracePackets;
        default: return nullptr;
    }
#endif
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
