// Packets (packet_tracer.h), compiled once for each instruction set, into a namespace of its own. Except for
// templates on Lanes, nothing may be compiled here that another file might share: the linker keeps one copy
// of it, which may then run on a processor without the instruction set.
#include "raytracer/tracer/packet_tracer.h"

#include "raytracer/numerics/ray_lanes.h"

#include "ray_color.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

template <>
void tracePacket<InstructionSet::RAYTRACER_INSTRUCTION_SET>(const Scene& scene, PointPacket& points,
                                                            const RenderContext& context) {
    const RenderOptions& options = *context.options;
    for (int lane = points.count; lane < laneCount; ++lane) {
        points.x[lane] = points.x[0];
        points.y[lane] = points.y[0];
    }
    const auto uv = scene.camera.getPixelUV(Lanes::load(points.x), Lanes::load(points.y), options.size.width,
                                            options.size.height);
    context.counts->primary += static_cast<std::uint64_t>(points.count);
    const ColorT<Lanes> color =
        withinDouble(scene.rayColor(scene.camera.getRay(uv), allLanesOf<Lanes> >> (laneCount - points.count),
                                    {Color(1), options.max_recursion}, context.ofSamples(points.samples)));
    store(color.x, points.color[0]);
    store(color.y, points.color[1]);
    store(color.z, points.color[2]);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
