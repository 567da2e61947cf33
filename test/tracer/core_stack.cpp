// What a reflection takes of a thread's stack: onTracingThreads makes threads that have it.
#include <algorithm>

#include <catch2/catch.hpp>

#include "raytracer/tracer/packet_tracer.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/scene_builder.h"

using namespace raytracer;

namespace {

// Where the stack is when a ray begins, at the first one and at the last.
class StackWatch final : public Observer {
  public:
    bool asksWhatShadows() const override { return false; }
    void enter(const Ray&, const RayPath& path) override {
        const auto* here = static_cast<const char*>(__builtin_frame_address(0));
        if (path.kind == RayKind::Primary) first_ = here;
        last_ = here;
        rays_ += path.kind != RayKind::Primary;
    }
    void meet(const Intersection&, const Color&) override {}
    void shadow(const Shape*, const Color&) override {}
    void light(const DirectLight&, const Color&) override {}
    void terminate(RayKind, TerminationReason) override {}
    void leave(const Color&) override {}

    std::ptrdiff_t eachRay() const { return (first_ - last_) / rays_; }
    int rays() const { return rays_; }

  private:
    const char *first_ = nullptr, *last_ = nullptr;
    int rays_ = 0;
};

constexpr int reflections = 20;

// Two mirrors that face each other.
std::unique_ptr<const Scene> facingMirrors() {
    SceneDescription scene;
    scene.camera.eye = {0, 0, 1};
    scene.materials.emplace_back().reflective = true;
    for (const double z : {0., 2.}) {
        scene.transforms.push_back({"", glm::dvec3(0, 0, z), {}, {}, {}});
        scene.shapes.push_back({ShapeType::Plane, scene.transforms.size() - 1, 0, nullptr});
    }
    scene.lights.emplace_back();
    return buildScene(scene);
}

RenderOptions deepOptions() {
    RenderOptions options;
    options.size = {4, 2};
    options.max_recursion = reflections;
    return options;
}

void checkStack(const StackWatch& watch) {
    INFO(watch.eachRay() << " bytes");
    CHECK(watch.rays() == reflections);
    CHECK(watch.eachRay() > 0);
    CHECK(watch.eachRay() < static_cast<std::ptrdiff_t>(recursionStack));
}

}  // namespace

TEST_CASE("stack: a reflected ray takes less than threads have for it") {
    const auto scene = facingMirrors();
    const RenderOptions options = deepOptions();
    RenderCounts counts;
    StackWatch watch;
    SampleTrace sample{.observer = &watch};
    const RenderContext context{&options, nullptr, &counts, &sample};
    scene->rayColor(scene->camera.getRay(Vec2(0)), {Color(1), reflections}, context);
    checkStack(watch);
}

TEST_CASE("stack: a packet of reflected rays takes less than threads have for it") {
    const auto scene = facingMirrors();
    if (!scene->tracePacket) return;
    const RenderOptions options = deepOptions();
    RenderCounts counts;
    StackWatch watches[PointPacket::most];
    PointPacket points;
    for (int i = 0; i < PointPacket::most; ++i)
        points.add(Real(i % 4) + Real(0.5), Real(i / 4) + Real(0.5), &watches[i]);
    const RenderContext context{&options, nullptr, &counts, points.samples};
    scene->tracePacket(*scene, points, context);
    checkStack(watches[0]);
}
