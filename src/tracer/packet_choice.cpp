#include "raytracer/tracer/packet_tracer.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

// The sets are listed from the least to the best.
template <InstructionSet... sets>
const PacketKernel* bestUpTo([[maybe_unused]] InstructionSet most) {
    const PacketKernel* best = nullptr;
    [[maybe_unused]] const auto consider = [&]<InstructionSet set>() {
        if (set <= most) best = &packetKernel<set>();
    };
    (consider.template operator()<sets>(), ...);
    return best;
}

}  // namespace

const PacketKernel* packetKernel(InstructionSet set) {
    using enum InstructionSet;
    return bestUpTo<RAYTRACER_PACKET_SETS>(set);  // the list is CMakeLists.txt's
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
