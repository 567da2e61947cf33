// Compiled as packet_tracer.cpp is (bench/CMakeLists.txt).
#include "meet_packet.h"

#include "raytracer/numerics/ray_lanes.h"

namespace raytracer {

void meetPacket(const ShapeTree& tree, std::span<const Ray> rays, const Vec3* end, std::span<Hit> hits) {
    RayT<Lanes> packet;
    packet.departure.shape = rays[0].departure.shape;
    packet.departure.inside = rays[0].departure.inside;
    const auto count = static_cast<int>(rays.size());
    for (int lane = 0; lane < laneCount; ++lane) {
        const Ray& ray = rays[static_cast<std::size_t>(std::min(lane, count - 1))];
        setLane(packet.origin, lane, ray.origin);
        setLane(packet.direction, lane, ray.direction);
        setLane(packet.departure.positionError, lane, ray.departure.positionError);
        setLane(packet.departure.primitive, lane, ray.departure.primitive);
    }
    const LaneBits active = allLanesOf<Lanes> >> (laneCount - count);
    HitQueryT<Lanes> query = end ? HitQueryT<Lanes>(*end, true, active) : HitQueryT<Lanes>(active);
    tree.meet(packet, query);
    for (int lane = 0; lane < count; ++lane) hits[static_cast<std::size_t>(lane)] = query.nearest(lane);
}

}  // namespace raytracer
