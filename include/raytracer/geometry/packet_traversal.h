// A packet's way to the shapes that it meets: through the trees as a beam, or one ray after the other where
// it is too wide. Only packet_tracer.cpp includes it.
#pragma once

#include "raytracer/geometry/mesh_formulas.h"
#include "raytracer/geometry/packet_query.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

template <>
struct LaneByLane<Chord<Lanes>> : OneLaneAfterTheOther<Chord<Lanes>> {};

inline namespace RAYTRACER_LANES_NAMESPACE {

inline void setLane(Chord<Lanes>& to, int lane, const Chord<Real>& chord) {
    setLane(to.hit, lane, chord.hit);
    setLane(to.entry, lane, chord.entry);
    setLane(to.exit, lane, chord.exit);
    setLane(to.entryFace, lane, chord.entryFace);
    setLane(to.exitFace, lane, chord.exitFace);
}

namespace {

using RayLanes = RayT<Lanes>;
using Vec3Lanes = Vec3T<Lanes>;

Ray laneOf(const RayLanes& ray, int lane) {
    const DepartureT<Lanes>& departure = ray.departure;
    return {laneOf(ray.origin, lane),
            laneOf(ray.direction, lane),
            {departure.shape, departure.primitive.of[lane], departure.inside,
             laneOf(departure.positionError, lane)}};
}

// Lanes that are not in use hold one that is, so that nothing out of the ordinary happens in them.
Vec3Lanes filled(const Vec3Lanes& v, LaneBits used) {
    return select<Lanes>(maskOf(used), v, Vec3Lanes(laneOf(v, std::countr_zero(used))));
}
RayLanes filled(const RayLanes& ray, LaneBits used) {
    RayLanes result{filled(ray.origin, used), filled(ray.direction, used), ray.departure};
    result.departure.positionError = filled(ray.departure.positionError, used);
    for (int lane = 0; lane < laneCount; ++lane)
        if (!(used >> lane & 1))
            result.departure.primitive.of[lane] = ray.departure.primitive.of[std::countr_zero(used)];
    return result;
}

BvhBeam beamOf(const Vec3Lanes& origin, const Vec3Lanes& direction) {
    BvhBeam beam{};
    storeLeast(origin, beam.originLow);
    storeLeast(-origin, beam.originHigh);
    storeLeast(direction, beam.directionLow);
    storeLeast(-direction, beam.directionHigh);
    for (double& x : beam.originHigh) x = -x;
    for (double& x : beam.directionHigh) x = -x;
    return beam;
}

// The farthest that a ray starts from the world's origin, along an axis.
Real farthest(const BvhBeam& beam) {
    double result = 0;
    for (int axis = 0; axis < 3; ++axis)
        result = std::max(result, std::max(-beam.originLow[axis], beam.originHigh[axis]));
    return static_cast<Real>(result);
}

// The axes that every ray's test is made along (shearAxes); false where they differ.
bool commonAxes(const Vec3Lanes& direction, LaneBits lanes, ShearAxes& axes) {
    axes = shearAxes(laneOf(direction, std::countr_zero(lanes)));
    const Vec3Lanes size = abs(direction);
    const LaneBits xy = bits(size.x > size.y), xz = bits(size.x > size.z), yz = bits(size.y > size.z);
    const LaneBits longest[3] = {xy & xz, ~xy & yz, ~(xy & xz) & ~(~xy & yz)};
    const LaneBits falling = lanes & bits(direction[axes.z] < Lanes(0));
    return (lanes & ~longest[axes.z]) == 0 && (falling == 0 || falling == lanes);
}

void meetMesh(const Mesh& mesh, const RayLanes& ray, PacketQuery& query);

void meet(const Shape& shape, const RayLanes& ray, PacketQuery& query) {
    switch (shape.kind()) {
        case ShapeKind::Sphere: return static_cast<const Sphere&>(shape).meet(ray, query);
        case ShapeKind::Plane: return static_cast<const Plane&>(shape).meet(ray, query);
        case ShapeKind::Cylinder: return static_cast<const Cylinder&>(shape).meet(ray, query);
        case ShapeKind::Cone: return static_cast<const Cone&>(shape).meet(ray, query);
        case ShapeKind::Cube: return static_cast<const Cube&>(shape).meet(ray, query);
        case ShapeKind::Mesh: return meetMesh(static_cast<const Mesh&>(shape), ray, query);
    }
}

// Each ray by itself, where they do not stay together.
template <class Intersect>
void meetOneByOne(const RayLanes& ray, PacketQuery& query, Intersect intersect) {
    forEach(query.asked(), [&](int lane) {
        if (!(laneOf(query.limit(), lane) >= 0)) return;
        HitQuery one = query.one(lane);
        intersect(laneOf(ray, lane), one);
        query.offer(lane, one);
    });
}

void meetMesh(const Mesh& mesh, const RayLanes& ray, PacketQuery& query) {
    const ObjectRayT<Lanes> object = mesh.toObject(ray);
    BvhBeam beam = beamOf(object.origin, object.direction);
    ShearAxes axes;
    const auto alone = [&] {
        meetOneByOne(ray, query, [&](const Ray& one, HitQuery& q) { mesh.intersect(one, q); });
    };
    const Bvh& bvh = mesh.triangles().bvh();
    if (bvh.empty() || !commonAxes(object.direction, query.asked(), axes)) return alone();
    beam.slack = static_cast<double>(mesh.slackFrom(farthest(beam)));
    BvhCursor cursor(bvh, beam);
    if (!cursor.usable()) return alone();
    const Mesh::MeshRay<Lanes> meshRay{ray, {object, axes}};
    while (!query.done() && cursor.next(static_cast<double>(greatest(query.limit()))))
        mesh.meetTriangles(meshRay, cursor.primitives(), query);
}

void traverse(const ShapeTree& tree, const RayLanes& ray, PacketQuery& query) {
    for (const Shape* shape : tree.list()) {
        meet(*shape, ray, query);
        if (query.done()) return;
    }
    if (tree.bvh().empty()) return;
    BvhBeam beam = beamOf(ray.origin, ray.direction);
    beam.slack = static_cast<double>(tree.slackFrom(farthest(beam)));
    const auto alone = [&] {
        meetOneByOne(ray, query, [&](const Ray& one, HitQuery& q) { tree.intersectBoxed(one, q); });
    };
    BvhCursor cursor(tree.bvh(), beam);
    if (!cursor.usable()) return alone();
    while (!query.done() && cursor.next(static_cast<double>(greatest(query.limit()))))
        for (const std::uint32_t name : cursor.primitives()) meet(tree.named(name), ray, query);
}

}  // namespace
}  // namespace RAYTRACER_LANES_NAMESPACE
}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
