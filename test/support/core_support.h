// What tests of the core share: shapes by kind, poses by name, and the same maps in long double to hold them
// to.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "raytracer/geometry/shapes.h"
#include "raytracer/tracer/shading.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {
namespace test {

using Kind = ShapeType;
inline constexpr std::array<Kind, 6> allKinds{Kind::Sphere, Kind::Plane, Kind::Cylinder,
                                              Kind::Cone,   Kind::Cube,  Kind::Mesh};
inline constexpr std::array<Kind, 5> allSolids{Kind::Sphere, Kind::Cylinder, Kind::Cone, Kind::Cube,
                                               Kind::Mesh};

inline const char* nameOf(Kind kind) { return typeName(kind); }

inline std::unique_ptr<Shape> makeShape(Kind kind, const Affine& worldFromObject, const Material& material,
                                        std::shared_ptr<const MeshData> mesh = nullptr,
                                        std::uint32_t index = 0) {
    std::shared_ptr<const TriangleMesh> triangles;
    if (kind == Kind::Mesh) triangles = std::make_shared<TriangleMesh>(std::move(mesh), BuildOptions{});
    return std::make_unique<Shape>(kind, Transform(worldFromObject), material, index, std::move(triangles));
}

// The arithmetic of the reference values.
using Wide = glm::vec<3, long double, glm::defaultp>;

inline Wide pointToWorld(const Affine& affine, const Wide& p) {
    Wide world;
    for (int row = 0; row < 3; ++row) {
        const auto& r = affine.linear[row];
        world[row] = r[0] * p.x + r[1] * p.y + r[2] * p.z + affine.translation[row];
    }
    return world;
}

inline Wide directionToWorld(const Affine& affine, const Wide& d) {
    return pointToWorld(affine, d) - pointToWorld(affine, Wide(0));
}

// The inverse transpose as the cofactors over the determinant's sign: exact where the entries are small
// integers.
inline Wide normalToWorld(const Affine& affine, const Wide& n) {
    Wide column[3];
    for (int c = 0; c < 3; ++c) column[c] = {affine.linear[0][c], affine.linear[1][c], affine.linear[2][c]};
    const Wide x = glm::cross(column[1], column[2]), y = glm::cross(column[2], column[0]),
               z = glm::cross(column[0], column[1]);
    const Wide world = n.x * x + n.y * y + n.z * z;
    return world * ((glm::dot(column[0], x) < 0 ? -1 : 1) / std::sqrt(glm::dot(world, world)));
}

// Where a line in object space meets one of the triangles.
inline LineHit<Real> meetLine(const TriangleMesh& mesh, const ObjectRay& line, std::uint32_t triangle) {
    return intersectLine(ShearedRayT<Real>(line, shearAxes(line.direction)), mesh.corners<Real>(triangle));
}

// A cube as a mesh: the same faces in the same order, two triangles each, with the cube's texture
// coordinates.
inline std::shared_ptr<const MeshData> cubeMesh() {
    auto mesh = std::make_shared<MeshData>();
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2, first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
        const double side = face % 2 == 0 ? 1 : -1;
        const auto base = static_cast<std::uint32_t>(mesh->positions.size());
        for (const double v : {-1.0, 1.0})
            for (const double u : {-1.0, 1.0}) {
                glm::dvec3 p(0);
                p[axis] = side, p[first] = u, p[second] = v;
                mesh->positions.push_back(p);
                mesh->texCoords.push_back({(u + 1) / 2, (v + 1) / 2});
            }
        const bool counterClockwise = (side > 0) == (axis != 1);  // x, y, z: (y, z), (x, z), (x, y)
        const std::uint32_t order[2][6] = {{0, 2, 1, 1, 2, 3}, {0, 1, 2, 2, 1, 3}};
        for (const std::uint32_t corner : order[counterClockwise]) {
            mesh->positionIndex.push_back(base + corner);
            mesh->texCoordIndex.push_back(base + corner);
        }
    }
    mesh->findBounds();
    return mesh;
}

struct Pose {
    std::string name;
    TransformDescription transform;
    bool exact = true;  // all of its numbers and its inverse's are short binary fractions
};

inline std::vector<Pose> poses() {
    const glm::dmat4 shear(1, 0, 0, 0, 2, 1, 0, 0, -1, 4, 1, 0, 4, 0, -2, 1);  // by columns; powers of 2
    const TransformDescription::Rotation quarter{90, {1, 0, 0}}, odd{37, {1, 2, 3}};
    const glm::dvec3 far(4, -8, 2);
    return {
        {"identity", {}},
        {"translation", {"", far, {}, {}, {}}},
        {"scale", {"", {}, {}, glm::dvec3(2, 4, 0.5), {}}},
        {"mirroring", {"", far, {}, glm::dvec3(-1, 2, 1), {}}},
        {"quarter turn", {"", far, quarter, {}, {}}},
        {"shear", {"", {}, {}, {}, shear}},
        {"all, exact", {"", far, quarter, glm::dvec3(-2, 0.5, 4), shear}},
        {"rotation", {"", {}, odd, {}, {}}, false},
        {"non-uniform scale", {"", glm::dvec3(0.1, 0.2, 0.3), {}, glm::dvec3(0.3, 1.7, 3.1), {}}, false},
        {"all", {"", glm::dvec3(-1.1, 2.3, 0.7), odd, glm::dvec3(-1.3, 0.6, 2.1), shear}, false},
    };
}

}  // namespace test
}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
