// The list of the types of shape, and the dispatch by type.
#pragma once

#include "raytracer/geometry/cone.h"
#include "raytracer/geometry/cube.h"
#include "raytracer/geometry/cylinder.h"
#include "raytracer/geometry/mesh.h"
#include "raytracer/geometry/plane.h"
#include "raytracer/geometry/sphere.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

template <class... Kinds>
struct KindList {};
using AllKinds = KindList<Sphere, Plane, Cylinder, Cone, Cube, Mesh>;

// Calls function(Kind()) for the Kind of this type.
template <class Function, class First, class... Rest>
decltype(auto) visit(ShapeType type, Function function, KindList<First, Rest...>) {
    if constexpr (sizeof...(Rest) > 0)
        if (type != First::type) return visit(type, function, KindList<Rest...>());
    return function(First());
}
template <class Function>
decltype(auto) visit(ShapeType type, Function function) {
    return visit(type, function, AllKinds());
}

// The support function of a shape, in object space: the largest n . p of its points p. `mesh`: a mesh's data.
inline Real support(ShapeType type, const MeshData* mesh, const Vec3& n) {
    return visit(type, [&](auto kind) {
        if constexpr (kind.type == ShapeType::Mesh) return kind.support(*mesh, n);
        else return kind.support(n);
    });
}

// Not inlined: it has several callers, and all shapes in it.
template <class T>
[[gnu::noinline]] void Shape::meet(const RayT<T>& ray, HitQueryT<T>& query) const {
    visit(type_, [&](auto kind) { kind.meet(*this, ray, query); });
}

template <class T>
IntersectionT<T> Shape::surface(const RayT<T>& ray, const HitT<T>& hit) const {
    return visit(type_, [&](auto kind) { return kind.surface(*this, ray, hit); });
}

template <class T>
bool Shape::areCoherent(const RayT<T>& ray, LaneBits lanes) const {
    return visit(type_, [&](auto kind) { return kind.areCoherent(*this, ray, lanes); });
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
