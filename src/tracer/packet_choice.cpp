#include "raytracer/tracer/packet_tracer.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

template <InstructionSet set>
const PacketKernel* kernel() {
    // No processor has long doubles side by side.
    if constexpr (set == InstructionSet::scalar || std::is_same_v<Real, long double>) return nullptr;
    else return &packetKernel<set>();
}

template <InstructionSet... sets>
const PacketKernel* kernelAmong(InstructionSet set) {
    const PacketKernel* const kernels[] = {kernel<sets>()...};
    return kernels[static_cast<std::size_t>(set)];
}

}  // namespace

const PacketKernel* packetKernel(InstructionSet set) {
    using enum InstructionSet;
    return kernelAmong<RAYTRACER_INSTRUCTION_SETS>(set);
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
