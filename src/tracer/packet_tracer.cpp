// Packets (packet_tracer.h). Compiled once for each instruction set, into a namespace of its own; nothing but
// templates on Lanes may be compiled here that another file might share, or it would run where the
// instruction set is not.
#include "raytracer/tracer/packet_tracer.h"

#include "ray_follower.h"
#include "raytracer/geometry/packet_traversal.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {
inline namespace RAYTRACER_LANES_NAMESPACE {

namespace {

using ColorLanes = ColorT<Lanes>;

class PacketTracer {
  public:
    PacketTracer(const Scene& scene, RenderContext& context) : scene_(&scene), context_(&context) {}

    ColorLanes rayColor(const RayLanes& ray, LaneBits asked, const RayPath& path);

    double dropped[laneCount] = {};

  private:
    void closestHits(const RayLanes& ray, PacketQuery& query);
    ColorLanes hitColor(const RayLanes& ray, const PacketQuery& query, LaneBits alike, const RayPath& path);
    ColorLanes oneByOne(const RayLanes& ray, const PacketQuery& query, LaneBits lanes, const RayPath& path);
    ColorLanes lightColor(const ShadingPointT<Lanes>& point, LaneBits lanes);
    ColorLanes shadow(const ShadingPointT<Lanes>& point, const Vec3Lanes& toLight, const Light& light,
                      LaneBits lanes);
    ColorLanes reflectedColor(const ShadingPointT<Lanes>& point, LaneBits lanes, const RayPath& path);
    ColorLanes refractedColor(const ShadingPointT<Lanes>& point, LaneBits lanes, const RayPath& path);
    template <class Function>
    void forEachFollower(LaneBits lanes, Function function) {
        if (RayFollower* followers = context_->followers)
            forEach(lanes, [&](int lane) { function(followers[lane], lane); });
    }
    bool isCast(NotCast reason, LaneBits lanes, const RayPath& onwards);

    const Scene* scene_;
    RenderContext* context_;
};

void PacketTracer::closestHits(const RayLanes& ray, PacketQuery& query) {
    traverse(scene_->tree(), ray, query);
    context_->counts.tests += query.tests;
    forEach(query.contended(), [&](int lane) {
        HitQuery one = query.whole();
        query.set(lane, scene_->closestHit(laneOf(ray, lane), one, *context_));
    });
}

ColorLanes PacketTracer::rayColor(const RayLanes& ray, LaneBits asked, const RayPath& path) {
    forEachFollower(asked, [&](RayFollower& follower, int) { follower.enter(path); });
    PacketQuery query(asked);
    closestHits(ray, query);
    ColorLanes color(0);
    for (LaneBits left = query.found(); left != 0;) {
        const LaneBits alike = query.alike(left);
        left &= ~alike;
        const bool together = std::popcount(alike) >= PointPacket::least;
        color = select<Lanes>(
            maskOf(alike), (together ? hitColor(ray, query, alike, path) : oneByOne(ray, query, alike, path)),
            color);
    }
    forEachFollower(asked, [](RayFollower& follower, int) { follower.leave(); });
    return color;
}

ColorLanes PacketTracer::oneByOne(const RayLanes& ray, const PacketQuery& query, LaneBits lanes,
                                  const RayPath& path) {
    ColorLanes color(0);
    forEach(lanes, [&](int lane) {
        context_->dropped = 0;
        if (context_->followers) context_->observer = &context_->followers[lane];
        setLane(color, lane, scene_->hitColor(laneOf(ray, lane), query.hit(lane), path, *context_));
        dropped[lane] += context_->dropped;
    });
    return color;
}

IntersectionT<Lanes> surfaceAt(const RayLanes& ray, const HitT<Lanes>& hit, const ShearAxes& axes) {
    const Shape& shape = *hit.shape;
    switch (shape.kind()) {
        case ShapeKind::Sphere: return static_cast<const Sphere&>(shape).surface(ray, hit);
        case ShapeKind::Plane: return static_cast<const Plane&>(shape).surface(ray, hit);
        case ShapeKind::Cylinder: return static_cast<const Cylinder&>(shape).surface(ray, hit);
        case ShapeKind::Cone: return static_cast<const Cone&>(shape).surface(ray, hit);
        case ShapeKind::Cube: return static_cast<const Cube&>(shape).surface(ray, hit);
        case ShapeKind::Mesh: break;
    }
    return static_cast<const Mesh&>(shape).surface(ray, hit, axes);
}

ColorLanes PacketTracer::hitColor(const RayLanes& ray, const PacketQuery& query, LaneBits alike,
                                  const RayPath& path) {
    RayLanes some;
    if (alike != allLanes) some = filled(ray, alike);
    const RayLanes& together = alike == allLanes ? ray : some;
    const HitT<Lanes> hit = query.hits(alike);
    ShearAxes axes{};
    if (hit.shape->kind() == ShapeKind::Mesh &&
        !commonAxes(hit.shape->transform().toObject(together).direction, alike, axes))
        return oneByOne(ray, query, alike, path);
    const IntersectionT<Lanes> intersection = surfaceAt(together, hit, axes);
    const ShadingPointT<Lanes> point(together, intersection, context_->options->bilinear);
    ColorLanes color = lightColor(point, alike);
    if (intersection.material->reflective) color += reflectedColor(point, alike, path);
    if (intersection.material->refractive) color += refractedColor(point, alike, path);
    return color;
}

ColorLanes PacketTracer::lightColor(const ShadingPointT<Lanes>& point, LaneBits lanes) {
    ColorLanes color(0);
    for (const Light& light : scene_->lights) {
        const DirectLightT<Lanes> direct = directLight(point, light);
        const ColorLanes lit = direct.lit();
        const LaneBits asked =
            context_->options->shadows ? lanes & ~bits((lit.x == 0) & (lit.y == 0) & (lit.z == 0)) : 0;
        ColorLanes sum = direct.ambient;
        sum += asked != 0 ? lit * shadow(point, direct.toLight, light, asked) : lit;
        forEachFollower(lanes, [&](RayFollower& follower, int lane) {
            follower.light((asked >> lane & 1) != 0, laneOf(sum, lane));
        });
        color += sum;
    }
    return color;
}

// S_L.
ColorLanes PacketTracer::shadow(const ShadingPointT<Lanes>& point, const Vec3Lanes& toLight,
                                const Light& light, LaneBits lanes) {
    context_->counts.shadow += static_cast<std::uint64_t>(std::popcount(lanes));
    const RayEnd end{light.position};
    PacketQuery query(lanes, end, !scene_->hasRefractiveShape());
    closestHits(point.leave(toLight, ShadingPointT<Lanes>::Side::Near), query);
    ColorLanes factor = select<Lanes>(maskOf(query.found()), ColorLanes(0), ColorLanes(1));
    if (scene_->hasRefractiveShape())
        forEach(query.found(), [&](int lane) {
            const Material& material = query.hit(lane).shape->material();
            if (material.refractive) setLane(factor, lane, material.color_refract);
        });
    return factor;
}

bool PacketTracer::isCast(NotCast reason, LaneBits lanes, const RayPath& onwards) {
    if (reason == NotCast::Cutoff)
        forEach(lanes, [&](int lane) { dropped[lane] += scene_->mostChange(onwards, *context_); });
    return reason == NotCast::Nothing;
}

ColorLanes PacketTracer::reflectedColor(const ShadingPointT<Lanes>& point, LaneBits lanes,
                                        const RayPath& path) {
    const Material& material = *point.hit->material;
    const RayPath onwards{path.weight * material.color_reflect, path.max_recursion - 1, RayKind::Reflection};
    if (!isCast(scene_->whyNotReflected(material, onwards, *context_), lanes, onwards)) return ColorLanes(0);
    context_->counts.reflection += static_cast<std::uint64_t>(std::popcount(lanes));
    const RayLanes reflected = point.leave(reflectedDirection(point), ShadingPointT<Lanes>::Side::Near);
    return ColorLanes(material.color_reflect) * rayColor(reflected, lanes, onwards);
}

ColorLanes PacketTracer::refractedColor(const ShadingPointT<Lanes>& point, LaneBits lanes,
                                        const RayPath& path) {
    if (!context_->options->refraction) return ColorLanes(0);
    const Material& material = *point.hit->material;
    const RayPath onwards{path.weight * material.color_refract, path.max_recursion - 1, RayKind::Refraction};
    const NotCast reason = scene_->whyNotRefracted(material, onwards, *context_);
    if (reason == NotCast::MaxRecursion || reason == NotCast::Black) return ColorLanes(0);
    Vec3Lanes direction;
    lanes &= bits(refractedDirection(point, direction));
    if (lanes == 0 || !isCast(reason, lanes, onwards)) return ColorLanes(0);
    context_->counts.refraction += static_cast<std::uint64_t>(std::popcount(lanes));
    if (lanes != allLanes) direction = filled(direction, lanes);
    const RayLanes refracted = point.leave(direction, ShadingPointT<Lanes>::Side::Far);
    return select<Lanes>(maskOf(lanes),
                         ColorLanes(material.color_refract) * rayColor(refracted, lanes, onwards),
                         ColorLanes(0));
}

void tracePacket(const Scene& scene, PointPacket& points, RenderContext& context) {
    const RenderOptions& options = *context.options;
    for (int lane = points.count; lane < laneCount; ++lane)
        points.x[lane] = points.x[0], points.y[lane] = points.y[0];
    const auto uv = scene.camera.getPixelUV(lanesOf(points.x), lanesOf(points.y), options.size.width,
                                            options.size.height);
    PacketTracer tracer(scene, context);
    context.counts.primary += static_cast<std::uint64_t>(points.count);
    const ColorLanes color = tracer.rayColor(scene.camera.getRay(uv), allLanes >> (laneCount - points.count),
                                             {Color(1), options.max_recursion});
    store(color.x, points.color[0]);
    store(color.y, points.color[1]);
    store(color.z, points.color[2]);
    for (int lane = 0; lane < laneCount; ++lane) points.dropped[lane] = tracer.dropped[lane];
}

void meetPacket(const ShapeTree& tree, std::span<const Ray> rays, const RayEnd* end, std::span<Hit> hits) {
    RayLanes packet;
    packet.departure.shape = rays[0].departure.shape;
    packet.departure.inside = rays[0].departure.inside;
    const auto count = static_cast<int>(rays.size());
    for (int lane = 0; lane < laneCount; ++lane) {
        const Ray& ray = rays[static_cast<std::size_t>(std::min(lane, count - 1))];
        setLane(packet.origin, lane, ray.origin);
        setLane(packet.direction, lane, ray.direction);
        setLane(packet.departure.positionError, lane, ray.departure.positionError);
        packet.departure.primitive.of[lane] = ray.departure.primitive;
    }
    const LaneBits asked = allLanes >> (laneCount - count);
    PacketQuery query = end ? PacketQuery(asked, *end, true) : PacketQuery(asked);
    traverse(tree, packet, query);
    for (int lane = 0; lane < count; ++lane)
        hits[static_cast<std::size_t>(lane)] = query.found() >> lane & 1 ? query.hit(lane) : Hit{};
}

constexpr PacketKernel kernel{tracePacket, meetPacket};

}  // namespace
}  // namespace RAYTRACER_LANES_NAMESPACE

template <>
const PacketKernel& packetKernel<InstructionSet::RAYTRACER_INSTRUCTION_SET>() {
    return kernel;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
