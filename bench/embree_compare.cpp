// Our trees side by side with Embree 3's, in one process: rays a second for the nearest hit and for shadows,
// time to build, memory. Embree decides in float (its robust flag on), we in double. Single rays
// (rtcIntersect1, rtcOccluded1), one thread; builds with all threads. Ratios above 1 are in our favour.
//
// embree_compare [ROUNDS]: each number is the median of that many alternated rounds.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <time.h>

#include <embree3/rtcore.h>

#include "../test/support/ball_mesh.h"
#include "median.h"
#include "meet_packet.h"
#include "raytracer/geometry/mesh.h"
#include "raytracer/geometry/shape_tree.h"

using namespace raytracer;

namespace {

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of this thread, so that what else the machine does counts less.
double cpuSeconds(const std::function<void()>& work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

std::shared_ptr<const MeshData> bumpySphere(std::uint32_t n) {
    return test::ballMesh(n, [](double u, double v) {
        return 1 + 0.05 * std::sin(13 * u) * std::sin(11 * v) + 0.01 * std::sin(71 * u) * std::sin(67 * v);
    });
}

struct Ball {
    glm::dvec3 center;
    double radius;
};

// So many in the cube from -1 to 1 that they fill a constant part of it.
std::vector<Ball> randomBalls(std::size_t count) {
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> within(-1, 1), size(0.3, 1);
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 center(within(engine), within(engine), within(engine));
        balls.push_back({center, size(engine) / std::cbrt(static_cast<double>(count))});
    }
    return balls;
}

// Something to trace, in both programs.
struct Subject {
    std::string name;
    std::size_t primitives = 0;
    std::function<void(const Ray&, HitQuery&)> ours;
    RTCScene embree = nullptr;
    double buildOurs = 0, buildEmbree = 0;
    double bytesOurs = 0, bytesEmbree = 0;  // for each primitive, geometry included

    // Owned.
    std::shared_ptr<const MeshData> mesh;
    std::vector<Shape> shapes;
    std::shared_ptr<const TriangleMesh> triangles;
    ShapeTree tree;
};

long long embreeBytes = 0;

RTCDevice device() {
    static const RTCDevice made = [] {
        const RTCDevice result = rtcNewDevice(nullptr);
        rtcSetDeviceMemoryMonitorFunction(
            result,
            [](void*, ssize_t bytes, bool) {
                embreeBytes += bytes;
                return true;
            },
            nullptr);
        return result;
    }();
    return made;
}

RTCScene embreeScene(RTCGeometry geometry) {
    const RTCScene scene = rtcNewScene(device());
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_MEDIUM);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    return scene;
}

RTCScene embreeMesh(const MeshData& mesh) {
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
    for (const glm::dvec3& p : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(p[axis]);
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangleCount()));
    std::copy(mesh.positionIndex.begin(), mesh.positionIndex.end(), indices);
    return embreeScene(geometry);
}

RTCScene embreeBalls(const std::vector<Ball>& balls) {
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, balls.size()));
    for (const Ball& ball : balls) {
        for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(ball.center[axis]);
        *vertices++ = static_cast<float>(ball.radius);
    }
    return embreeScene(geometry);
}

void buildEmbree(Subject& subject, RTCScene scene, long long before) {
    subject.embree = scene;
    subject.buildEmbree = seconds([&] { rtcCommitScene(scene); });
    subject.bytesEmbree = static_cast<double>(embreeBytes - before) / static_cast<double>(subject.primitives);
}

std::unique_ptr<Subject> meshSubject(std::uint32_t n, int rounds) {
    auto subject = std::make_unique<Subject>();
    static const Material material;
    subject->mesh = bumpySphere(n);
    subject->primitives = subject->mesh->triangleCount();
    subject->name = std::to_string(subject->primitives) + " triangles";
    std::vector<double> ours, theirs;
    for (int round = 0; round < rounds; ++round) {
        subject->triangles.reset();
        ours.push_back(seconds(
            [&] { subject->triangles = std::make_shared<TriangleMesh>(subject->mesh, BuildOptions{}); }));
        if (subject->embree) rtcReleaseScene(subject->embree);
        const long long before = embreeBytes;
        buildEmbree(*subject, embreeMesh(*subject->mesh), before);
        theirs.push_back(subject->buildEmbree);
    }
    subject->buildOurs = median(ours), subject->buildEmbree = median(theirs);
    const std::size_t geometry =
        subject->mesh->positions.size() * 24 + subject->mesh->positionIndex.size() * 4;
    subject->bytesOurs = static_cast<double>(geometry + subject->triangles->bvh().memory()) /
                         static_cast<double>(subject->primitives);
    subject->shapes.emplace_back(ShapeType::Mesh, Transform(Affine{}), material, 0, subject->triangles);
    subject->ours = [shape = subject->shapes.data()](const Ray& ray, HitQuery& query) {
        shape->intersect(ray, query);
    };
    return subject;
}

std::unique_ptr<Subject> ballSubject(std::size_t count, int rounds) {
    auto subject = std::make_unique<Subject>();
    static const Material material;
    subject->primitives = count;
    subject->name = std::to_string(count) + " spheres";
    const std::vector<Ball> balls = randomBalls(count);
    for (const Ball& ball : balls) {
        Affine affine;
        for (int axis = 0; axis < 3; ++axis) {
            affine.linear[axis][axis] = ball.radius;
            affine.translation[axis] = ball.center[axis];
        }
        subject->shapes.emplace_back(ShapeType::Sphere, Transform(affine), material,
                                     static_cast<std::uint32_t>(subject->shapes.size()));
    }
    std::vector<double> ours, theirs;
    for (int round = 0; round < rounds; ++round) {
        ours.push_back(seconds([&] { subject->tree = ShapeTree(subject->shapes, BuildOptions{}); }));
        if (subject->embree) rtcReleaseScene(subject->embree);
        const long long before = embreeBytes;
        buildEmbree(*subject, embreeBalls(balls), before);
        theirs.push_back(subject->buildEmbree);
    }
    subject->buildOurs = median(ours), subject->buildEmbree = median(theirs);
    subject->ours = [tree = &subject->tree](const Ray& ray, HitQuery& query) { tree->meet(ray, query); };
    return subject;
}

// Rays through the pixels of a square picture, in blocks of 4 x 2 and tiles of 32 x 32 as render.cpp has
// them.
std::vector<Ray> primaryRays(int edge) {
    std::vector<Ray> rays;
    const Vec3 eye(0.7, -2.9, 0.8), forward = glm::normalize(-eye),
                                    right = glm::normalize(glm::cross(forward, Vec3(0, 0, 1))),
                                    up = glm::cross(right, forward);
    for (int tile = 0; tile < edge * edge / 1024; ++tile)
        for (int pixel = 0; pixel < 1024; ++pixel) {
            const int block = pixel / 8;
            const int x = tile % (edge / 32) * 32 + block % 8 * 4 + pixel % 4;
            const int y = tile / (edge / 32) * 32 + block / 8 * 2 + pixel / 4 % 2;
            const double u = 0.8 * (x + 0.5) / edge - 0.4, v = 0.4 - 0.8 * (y + 0.5) / edge;
            rays.push_back({eye, forward + u * right + v * up, {}});
        }
    return rays;
}

const Vec3 lightPosition(4, -3, 5);

// From the points that the rays hit: towards a light, and in random directions of the outer half space.
void secondaryRays(const Subject& subject, const std::vector<Ray>& rays, std::vector<Ray>& shadow,
                   std::vector<Ray>& diffuse) {
    std::mt19937 engine(7);
    std::normal_distribution<double> normal;
    for (const Ray& ray : rays) {
        HitQuery query;
        subject.ours(ray, query);
        if (!query.found()) continue;
        const Intersection hit = query.nearest().shape->surface(ray, query.nearest());
        const Departure departure{hit.shape, hit.primitive, false, false, hit.positionError};
        const Vec3 toLight = lightPosition - hit.position;
        if (glm::dot(toLight, hit.normal) > 0) shadow.push_back({hit.position, toLight, departure});
        const Vec3 any = glm::normalize(Vec3(normal(engine), normal(engine), normal(engine)));
        diffuse.push_back({hit.position, glm::dot(any, hit.normal) < 0 ? -any : any, departure});
    }
}

RTCRay embreeRay(const Ray& ray, float far) {
    // Off the surface as its users do: Embree has no way to say where a ray departs.
    const auto f = [](Real x) { return static_cast<float>(x); };
    RTCRay result{};
    result.org_x = f(ray.origin.x), result.org_y = f(ray.origin.y), result.org_z = f(ray.origin.z);
    result.dir_x = f(ray.direction.x), result.dir_y = f(ray.direction.y), result.dir_z = f(ray.direction.z);
    result.tnear = ray.departure.shape ? 1e-4f : 0;
    result.tfar = far;
    result.mask = ~0u;
    return result;
}

struct Result {
    double ours, theirs;  // seconds for a ray
    std::size_t hitsOurs, hitsTheirs;
};

template <class Ours, class Theirs>
Result race(std::size_t rays, int rounds, const Ours& ours, const Theirs& theirs) {
    Result result{};
    std::vector<double> timesOurs, timesTheirs;
    for (int round = 0; round < rounds; ++round) {
        timesOurs.push_back(cpuSeconds([&] { result.hitsOurs = ours(); }) / static_cast<double>(rays));
        timesTheirs.push_back(cpuSeconds([&] { result.hitsTheirs = theirs(); }) / static_cast<double>(rays));
    }
    result.ours = median(timesOurs), result.theirs = median(timesTheirs);
    return result;
}

Result raceNearest(const Subject& subject, const std::vector<Ray>& rays, RTCIntersectContext& context,
                   int rounds) {
    const auto ours = [&] {
        std::size_t hits = 0;
        for (const Ray& ray : rays) {
            HitQuery query;
            subject.ours(ray, query);
            hits += query.found();
        }
        return hits;
    };
    const auto theirs = [&] {
        std::size_t hits = 0;
        for (const Ray& ray : rays) {
            RTCRayHit hit{embreeRay(ray, std::numeric_limits<float>::infinity()), {}};
            hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(subject.embree, &context, &hit);
            hits += hit.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        }
        return hits;
    };
    return race(rays.size(), rounds, ours, theirs);
}

Result raceShadow(const Subject& subject, const std::vector<Ray>& rays, RTCIntersectContext& context,
                  int rounds) {
    const auto ours = [&] {
        std::size_t hits = 0;
        for (const Ray& ray : rays) {
            const Vec3 end = ray.origin + ray.direction;
            HitQuery query(end, true);
            subject.ours(ray, query);
            hits += query.found();
        }
        return hits;
    };
    const auto theirs = [&] {
        std::size_t hits = 0;
        for (const Ray& ray : rays) {
            RTCRay shadow = embreeRay(ray, 1);
            rtcOccluded1(subject.embree, &context, &shadow);
            hits += shadow.tfar < 0;
        }
        return hits;
    };
    return race(rays.size(), rounds, ours, theirs);
}

// Rays that can be followed together: up to eight in a row that leave the same shape.
std::vector<std::span<const Ray>> packetsOf(const std::vector<Ray>& rays) {
    std::vector<std::span<const Ray>> packets;
    for (std::size_t begin = 0, end; begin < rays.size(); begin = end) {
        for (end = begin + 1; end < rays.size() && end < begin + 8 &&
                              rays[end].departure.shape == rays[begin].departure.shape;)
            ++end;
        packets.emplace_back(&rays[begin], end - begin);
    }
    return packets;
}

// Both in packets of eight: the nearest hits, or whether there is one before the light.
Result racePackets(const Subject& subject, const std::vector<Ray>& rays, const Vec3* end,
                   RTCIntersectContext& context, int rounds) {
    const auto packets = packetsOf(rays);
    const ShapeTree tree(subject.shapes, BuildOptions{});
    const auto ours = [&] {
        std::size_t found = 0;
        Hit hits[8];
        for (const auto packet : packets) {
            meetPacket(tree, packet, end, {hits, packet.size()});
            for (std::size_t i = 0; i < packet.size(); ++i) found += hits[i].shape != nullptr;
        }
        return found;
    };
    const auto theirs = [&] {
        std::size_t found = 0;
        for (const auto packet : packets) {
            alignas(32) int valid[8] = {};
            RTCRayHit8 hit{};
            for (std::size_t i = 0; i < packet.size(); ++i) {
                const RTCRay ray = embreeRay(packet[i], end ? 1 : std::numeric_limits<float>::infinity());
                valid[i] = -1;
                hit.ray.org_x[i] = ray.org_x, hit.ray.org_y[i] = ray.org_y, hit.ray.org_z[i] = ray.org_z;
                hit.ray.dir_x[i] = ray.dir_x, hit.ray.dir_y[i] = ray.dir_y, hit.ray.dir_z[i] = ray.dir_z;
                hit.ray.tnear[i] = ray.tnear, hit.ray.tfar[i] = ray.tfar, hit.ray.mask[i] = ray.mask;
                hit.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            }
            if (end) rtcOccluded8(valid, subject.embree, &context, &hit.ray);
            else rtcIntersect8(valid, subject.embree, &context, &hit);
            for (std::size_t i = 0; i < packet.size(); ++i)
                found += end ? hit.ray.tfar[i] < 0 : hit.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        }
        return found;
    };
    return race(rays.size(), rounds, ours, theirs);
}

void print(const char* what, const Result& result) {
    std::printf("  %-28s %7.0f ns %7.0f ns   %5.2f   hits %zu %zu\n", what, 1e9 * result.ours,
                1e9 * result.theirs, result.theirs / result.ours, result.hitsOurs, result.hitsTheirs);
}

void compare(const Subject& subject, int rounds) {
    RTCIntersectContext coherent, incoherent;
    rtcInitIntersectContext(&coherent);
    rtcInitIntersectContext(&incoherent);
    coherent.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    const std::vector<Ray> primary = primaryRays(512);
    std::vector<Ray> shadow, diffuse;
    secondaryRays(subject, primary, shadow, diffuse);
    std::printf("%s                      ours      Embree   ratio\n", subject.name.c_str());
    print("nearest hit, from the camera", raceNearest(subject, primary, coherent, rounds));
    print("nearest hit, scattered", raceNearest(subject, diffuse, incoherent, rounds));
    print("shadow", raceShadow(subject, shadow, coherent, rounds));
    print("packets, from the camera", racePackets(subject, primary, nullptr, coherent, rounds));
    print("packets, scattered", racePackets(subject, diffuse, nullptr, incoherent, rounds));
    print("packets, shadow", racePackets(subject, shadow, &lightPosition, coherent, rounds));
    std::printf("  %-28s %7.1f ms %7.1f ms   %5.2f\n", "build", 1e3 * subject.buildOurs,
                1e3 * subject.buildEmbree, subject.buildEmbree / subject.buildOurs);
    if (subject.bytesOurs > 0)
        std::printf("  %-28s %7.1f    %7.1f      %5.2f\n", "bytes for each primitive", subject.bytesOurs,
                    subject.bytesEmbree, subject.bytesEmbree / subject.bytesOurs);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
    const std::string only = argc > 2 ? argv[2] : "";
    for (const std::uint32_t n : {18u, 288u})
        if (only.empty() || only == "mesh" + std::to_string(n)) compare(*meshSubject(n, rounds), rounds);
    for (const std::size_t count : {std::size_t{100}, std::size_t{10000}, std::size_t{1000000}})
        if (only.empty() || only == "balls" + std::to_string(count))
            compare(*ballSubject(count, rounds), rounds);
}
