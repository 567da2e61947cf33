// Lines through a closed mesh's vertices and along its edges: how often they cross it. The CTest run and the
// long run in bench/ share it.
#pragma once

#include "core_random.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {
namespace test {

// Star-shaped about `center` and neither convex nor concave: an icosahedron with its vertices at 0.7 to 1.3.
inline std::shared_ptr<const MeshData> starMesh(const glm::dvec3& center, Random& random) {
    auto mesh = std::make_shared<MeshData>(*roundMesh(true));
    for (glm::dvec3& p : mesh->positions) p = p * random.between(0.7, 1.3) + center;
    mesh->findBounds();
    return mesh;
}

struct Crossings {
    std::uint64_t rays = 0;
    std::uint64_t through = 0;  // from inside, and met nothing
    std::uint64_t twice = 0;    // from inside, and the line crosses more than once, or not outwards
    std::uint64_t odd = 0;      // from outside, and the line enters and leaves not equally often
};

class WatertightTest {
  public:
    WatertightTest(const glm::dvec3& center, std::uint64_t seed) : random_(seed), center_(center) {}

    // A new star for every 100,000.
    Crossings run(std::uint64_t rays) {
        for (; result_.rays < rays; ++result_.rays) {
            if (result_.rays % 100000 == 0) makeStar();
            const Place place = static_cast<Place>(1 + random_.below(2));  // an edge or a vertex
            const Vec3 target(meshPlace(*data_, place, random_));
            const bool inside = random_.bits() & 1;
            // Along the axes and aslant, so that coordinates vanish as they do in scenes made by hand.
            glm::dvec3 way = random_.below(4) == 0 ? glm::dvec3(0) : random_.direction();
            if (way == glm::dvec3(0)) way[random_.below(3)] = random_.sign();
            const Vec3 origin = inside ? Vec3(center_) + Vec3(0.3 * random_.box())
                                       : target - Vec3(random_.magnitude(2) * way);
            cross(origin, inside ? target - origin : Vec3(way), inside);
        }
        return result_;
    }

  private:
    void makeStar() {
        data_ = starMesh(center_, random_);
        triangles_ = std::make_shared<TriangleMesh>(data_, BuildOptions{});
        mesh_.emplace(ShapeType::Mesh, Transform(Affine{}), material_, 0, triangles_);
    }

    void cross(const Vec3& origin, const Vec3& direction, bool inside) {
        const ObjectRay ray{origin, direction};
        int in = 0, out = 0, ahead = 0;
        for (std::uint32_t triangle = 0; triangle < triangles_->triangleCount(); ++triangle) {
            const auto line = meetLine(*triangles_, ray, triangle);
            if (!line.hit) continue;
            ++(line.entering ? in : out);
            ahead += line.t > 0;
        }
        result_.odd += in != out;
        if (!inside) return;
        result_.twice += ahead > 1;
        result_.through += !mesh_->rayIntersect({origin, direction, {}}).valid;
    }

    Random random_;
    glm::dvec3 center_;
    std::shared_ptr<const MeshData> data_;
    std::shared_ptr<const TriangleMesh> triangles_;
    Material material_;
    std::optional<Shape> mesh_;
    Crossings result_;
};

}  // namespace test
}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
