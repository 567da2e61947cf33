// Random poses over many orders of magnitude, random places on surfaces, and the surfaces' equations in long
// double for the reference values. Deterministic: the same seed, the same rays, on every machine and with
// every library.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <optional>

#include "core_support.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {
namespace test {

// Steele, Lea and Flood 2014 (SplitMix).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * uniform(); }
    double sign() { return bits() & 1 ? 1 : -1; }
    double magnitude(double decades) { return std::pow(10, between(-decades, decades)); }  // 10^+-decades
    glm::dvec3 box() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 v = box();
            const double squared = glm::dot(v, v);
            if (squared > 0.01 && squared <= 1) return v / std::sqrt(squared);
        }
    }

  private:
    std::uint64_t state_;
};

// How far the numbers go, as powers of ten.
struct Extents {
    double size = 4;     // of radii
    double stretch = 4;  // of each axis against the others
    double origin = 8;   // of the distance from the world's origin
};

// Rotated, and in turn: a plain radius; each axis scaled by its own factor; sheared and mirrored as well.
inline Affine randomAffine(Random& random, const Extents& extents) {
    TransformDescription t;
    t.rotate = {random.between(-180, 180), random.direction()};
    t.translate = random.direction() * random.magnitude(extents.origin);
    const double radius = random.magnitude(extents.size);
    glm::dvec3 scale(radius);
    const int variety = random.below(3);
    if (variety > 0)
        for (int axis = 0; axis < 3; ++axis) scale[axis] *= random.sign() * random.magnitude(extents.stretch);
    t.scale = scale;
    if (variety > 1) {
        const glm::dvec3 a = 0.4 * random.box(), b = 0.4 * random.box();  // diagonally dominant: invertible
        t.matrix = glm::dmat4(1, a.x, a.y, 0, a.z, 1, b.x, 0, b.y, b.z, 1, 0, 0, 0, 0, 1);
    }
    return compose(t);
}

// A closed, strictly convex mesh with its vertices on the unit sphere: an icosahedron, each face split in
// four unless `coarse`.
inline std::shared_ptr<const MeshData> roundMesh(bool coarse = false) {
    auto mesh = std::make_shared<MeshData>();
    const double g = (1 + std::sqrt(5.0)) / 2, length = std::sqrt(1 + g * g);
    for (int axis = 0; axis < 3; ++axis)
        for (const double one : {-1.0, 1.0})
            for (const double golden : {-g, g}) {
                glm::dvec3 p(0);
                p[axis] = one / length, p[(axis + 1) % 3] = golden / length;
                mesh->positions.push_back(p);
            }
    const auto& p = mesh->positions;
    const double edge = 2 / length * 1.001;
    const auto split = [&](std::uint32_t a, std::uint32_t b) {
        const glm::dvec3 middle = glm::normalize(mesh->positions[a] + mesh->positions[b]);
        for (std::uint32_t i = 0; i < p.size(); ++i)
            if (p[i] == middle) return i;
        mesh->positions.push_back(middle);
        return static_cast<std::uint32_t>(p.size() - 1);
    };
    for (std::uint32_t a = 0; a < 12; ++a)
        for (std::uint32_t b = a + 1; b < 12; ++b)
            for (std::uint32_t c = a + 1; c < 12; ++c) {
                if (glm::distance(p[a], p[b]) > edge || glm::distance(p[b], p[c]) > edge ||
                    glm::distance(p[c], p[a]) > edge)
                    continue;
                if (b == c || glm::dot(glm::cross(p[b] - p[a], p[c] - p[a]), p[a]) < 0) continue;
                std::vector<std::uint32_t> triangles{a, b, c};
                if (!coarse) {
                    const std::uint32_t ab = split(a, b), bc = split(b, c), ca = split(c, a);
                    triangles = {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca};
                }
                mesh->positionIndex.insert(mesh->positionIndex.end(), triangles.begin(), triangles.end());
            }
    mesh->findBounds();
    return mesh;
}

// Where on a shape a test aims.
enum class Place { Anywhere, Edge, Corner };  // rims and edges; cap centres, corners and the apex

inline Wide circle(double turns) {
    const long double angle = turns * 6.28318530717958647692L;
    return {std::cos(angle), std::sin(angle), 0};
}

inline Wide meshPlace(const MeshData& mesh, Place place, Random& random) {
    const std::size_t triangle =
        static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangleCount())));
    const auto corner = [&](std::size_t i) {
        return Wide(mesh.positions[mesh.positionIndex[3 * triangle + i]]);
    };
    if (place == Place::Corner) return corner(0);
    const long double u = place == Place::Edge ? 0 : random.uniform(), v = (1 - u) * random.uniform();
    return u * corner(0) + v * corner(1) + (1 - u - v) * corner(2);
}

// A point on the surface in object space.
inline Wide placeOn(Kind kind, const MeshData* mesh, Place place, Random& random) {
    const Wide around = circle(random.uniform());
    const long double height = random.uniform(), r = std::sqrt(random.uniform());
    const int which = random.below(3);
    switch (kind) {
        case Kind::Sphere:
            return place == Place::Corner ? Wide(0, 0, random.sign()) : Wide(random.direction());
        case Kind::Plane:
            return place == Place::Corner ? Wide(0) : Wide(random.magnitude(2), random.magnitude(2), 0);
        case Kind::Cylinder:
            if (place == Place::Edge) return around + Wide(0, 0, which % 2);
            if (place == Place::Corner) return Wide(0, 0, which % 2);
            return which == 0 ? around + Wide(0, 0, height) : r * around + Wide(0, 0, which - 1);
        case Kind::Cone:
            if (place == Place::Edge) return around;
            if (place == Place::Corner) return Wide(0, 0, which % 2);
            return which == 0 ? r * around : (1 - height) * around + Wide(0, 0, height);
        case Kind::Cube: {
            Wide p(random.box());
            p[which] = random.sign();
            if (place != Place::Anywhere) p[(which + 1) % 3] = random.sign();
            if (place == Place::Corner) p[(which + 2) % 3] = random.sign();
            return p;
        }
        case Kind::Mesh: break;
    }
    return meshPlace(*mesh, place, random);
}

// A point of object space in a convex solid's inside.
inline Wide placeInside(Random& random) { return 0.2L * Wide(random.box()) + Wide(0, 0, 0.3L); }

// The planes of a mesh's triangles, with unit normals.
struct Facet {
    Wide normal, corner;
};

inline std::vector<Facet> facetsOf(const MeshData& mesh) {
    std::vector<Facet> facets;
    for (std::size_t i = 0; i < mesh.positionIndex.size(); i += 3) {
        const auto corner = [&](std::size_t c) { return Wide(mesh.positions[mesh.positionIndex[i + c]]); };
        const Wide n = glm::cross(corner(1) - corner(0), corner(2) - corner(0));
        facets.push_back({n / std::sqrt(glm::dot(n, n)), corner(0)});
    }
    return facets;
}

// F(p) <= 0 inside, convex, of the order of the distance in object units: the shape's equation without its
// code.
inline long double offsetOf(Kind kind, const Wide& p) {
    const long double r = std::sqrt(p.x * p.x + p.y * p.y);
    switch (kind) {
        case Kind::Sphere: return std::sqrt(glm::dot(p, p)) - 1;
        case Kind::Plane: return p.z;
        case Kind::Cylinder: return std::max({r - 1, -p.z, p.z - 1});
        case Kind::Cone: return std::max(r - (1 - p.z), -p.z);
        case Kind::Cube: return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 1;
        case Kind::Mesh: break;
    }
    return -1;  // isDeepInside
}

// Whether p is inside by more than `depth`; of a convex mesh, behind all of its facets.
inline bool isDeepInside(Kind kind, const std::vector<Facet>& facets, const Wide& p, long double depth) {
    if (kind != Kind::Mesh) return offsetOf(kind, p) < -depth;
    return std::all_of(facets.begin(), facets.end(),
                       [&](const Facet& facet) { return glm::dot(facet.normal, p - facet.corner) < -depth; });
}

#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 Quad;
#else
using Quad = long double;
#endif

// World to object in quadruple precision: the inverse by cofactors, where ill-conditioned maps cancel.
class WideInverse {
  public:
    explicit WideInverse(const Affine& affine) : affine_(affine) {
        const auto& a = affine.linear;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
                inverse_[j][i] = Quad(a[i1][j1]) * Quad(a[i2][j2]) - Quad(a[i1][j2]) * Quad(a[i2][j1]);
            }
        Quad determinant = 0;
        for (int j = 0; j < 3; ++j) determinant += Quad(a[0][j]) * inverse_[j][0];
        for (auto& row : inverse_)
            for (Quad& entry : row) entry /= determinant;
    }
    Wide direction(const Wide& d) const { return times(Quad(d.x), Quad(d.y), Quad(d.z)); }
    Wide point(const Wide& p) const {
        const auto& t = affine_.translation;
        return times(Quad(p.x) - Quad(t[0]), Quad(p.y) - Quad(t[1]), Quad(p.z) - Quad(t[2]));
    }
    // What a box of +-error becomes: the largest |component| along each object axis.
    Wide error(const Wide& e) const {
        Wide object;
        for (int row = 0; row < 3; ++row) {
            long double r[3];
            for (int i = 0; i < 3; ++i) r[i] = std::abs(static_cast<long double>(inverse_[row][i]));
            object[row] = r[0] * e.x + r[1] * e.y + r[2] * e.z;
        }
        return object;
    }

  private:
    Wide times(Quad x, Quad y, Quad z) const {
        Wide object;
        for (int row = 0; row < 3; ++row)
            object[row] =
                static_cast<long double>(inverse_[row][0] * x + inverse_[row][1] * y + inverse_[row][2] * z);
        return object;
    }

    Affine affine_;
    Quad inverse_[3][3];
};

}  // namespace test
}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
