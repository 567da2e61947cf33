#include "raytracer/tracer/packet_tracer.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

// packet_tracer.cpp, compiled for each instruction set; no processor has long doubles side by side.
#if !defined(RAYTRACER_PRECISION_extended)
namespace lanes_plain {
void tracePacket(const Scene& scene, PointPacket& points, RenderContext& context);
void meetPacket(const ShapeTree& tree, std::span<const Ray> rays, const RayEnd* end, std::span<Hit> hits);
}  // namespace lanes_plain
#endif
#if defined(RAYTRACER_AVX2_LANES)
namespace lanes_avx2 {
void tracePacket(const Scene& scene, PointPacket& points, RenderContext& context);
void meetPacket(const ShapeTree& tree, std::span<const Ray> rays, const RayEnd* end, std::span<Hit> hits);
}  // namespace lanes_avx2
#endif

namespace {

template <class Function>
Function choose([[maybe_unused]] Function plain, [[maybe_unused]] Function avx2) {
    switch (instructionSet()) {
        case InstructionSet::Avx2: return avx2;
        case InstructionSet::Sse2: return plain;
        default: return nullptr;
    }
}

}  // namespace

#if defined(RAYTRACER_PRECISION_extended)
TracePacket packetTracer() { return choose<TracePacket>(nullptr, nullptr); }
MeetPacket packetMeeter() { return choose<MeetPacket>(nullptr, nullptr); }
#elif defined(RAYTRACER_AVX2_LANES)
TracePacket packetTracer() { return choose(lanes_plain::tracePacket, lanes_avx2::tracePacket); }
MeetPacket packetMeeter() { return choose(lanes_plain::meetPacket, lanes_avx2::meetPacket); }
#else
TracePacket packetTracer() { return choose(lanes_plain::tracePacket, lanes_plain::tracePacket); }
MeetPacket packetMeeter() { return choose(lanes_plain::meetPacket, lanes_plain::meetPacket); }
#endif

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
