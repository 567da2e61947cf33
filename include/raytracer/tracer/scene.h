// A scene in Real, and the recursion that sees it.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "raytracer/geometry/shape_tree.h"
#include "raytracer/tracer/camera.h"
#include "raytracer/tracer/observer.h"
#include "raytracer/tracer/packet_order.h"
#include "raytracer/tracer/ray_tree.h"
#include "raytracer/tracer/render_options.h"
#include "raytracer/util/progress.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

class RayFollower;

// A render's own state while it follows rays; one for each thread.
struct RenderContext {
    const RenderOptions* options;
    const Color* brightest = nullptr;  // by max_recursion: Scene::brightestColors; only for a cutoff
    Observer* observer = nullptr;
    RayFollower* followers = nullptr;  // one for each point of a packet (Scene::rayTrees)
    RenderCounts counts{};
    double dropped = 0;  // the most that rays not cast so far can have changed the pixel
};

// What a ray's colour is multiplied by on its way to the pixel, and how often it may be reflected or
// refracted.
struct RayPath {
    Color weight{1};
    int max_recursion = 0;
    RayKind kind = RayKind::Primary;
};

// A few points of the picture, in pixels, (0, 0) at the top left; and what is seen there.
struct PointPacket {
    static constexpr int width = packetWidth,
                         height = packetHeight;             // pixels that it holds when it is filled best
    static constexpr int most = width * height, least = 3;  // fewer are sooner traced one at a time

    int count = 0;
    alignas(32) Real x[most], y[most];
    alignas(32) Real color[3][most];
    double dropped[most];  // RenderContext::dropped

    void add(Real pointX, Real pointY) {
        x[count] = pointX;
        y[count++] = pointY;
    }
    Color colorOf(int i) const { return {color[0][i], color[1][i], color[2][i]}; }
};

struct PacketKernel;  // packet_tracer.h

class Scene {
  public:
    SceneFrame frame;
    Camera camera;
    std::vector<Material> materials;  // shapes point into it: complete before the first shape is made
    std::vector<Light> lights;
    std::vector<std::unique_ptr<Shape>> shapes;
    std::vector<std::shared_ptr<const Texture>> textures;  // keeps alive what materials point to

    // Once shapes and materials are complete: prepares to find the ones that a ray meets.
    void index(const BuildOptions& options);

    // The nearest intersection with t >= 0; where surfaces coincide, with the one listed first.
    Intersection closestIntersection(const Ray& ray, RenderContext& context) const;

    // The colour seen along a ray:
    // K_R I_R + K_T I_T + sum over lights (K_A I_AL + [K_D I_L (N.L) + K_S I_L (V.R)^n] S_L). A miss is
    // black.
    Color rayColor(const Ray& ray, const RayPath& path, RenderContext& context) const;

    // rayColor where the ray's nearest hit is known.
    Color hitColor(const Ray& ray, const Hit& hit, const RayPath& path, RenderContext& context) const;

    // The query's nearest hit; where another one is within rounding of it, the first listed of those that go
    // through the same point.
    Hit closestHit(const Ray& ray, HitQuery& query, RenderContext& context) const;

    // Fills in the points' colours: each its own, whatever the others are, but soonest where they lie
    // together.
    void pointColors(PointPacket& points, RenderContext& context) const;

    // The means of pixels' samples, of up to PointPacket::most: soonest where they lie together.
    void pixelColors(std::span<const PixelPlace> pixels, std::span<Color> colors,
                     RenderContext& context) const;

    // Why the next ray on a path is not cast: for all rays that meet the same material alike.
    NotCast whyNotReflected(const Material& material, const RayPath& onwards,
                            const RenderContext& context) const;
    NotCast whyNotRefracted(const Material& material, const RayPath& onwards,
                            const RenderContext& context) const;
    // The most that a ray on this path can change its sample; only for a cutoff.
    double mostChange(const RayPath& path, const RenderContext& context) const;

    const ShapeTree& tree() const { return tree_; }
    bool hasRefractiveShape() const { return hasRefractiveShape_; }

    // The most that a ray's colour can be, by the materials' and lights' colours alone: for max_recursion 0,
    // 1, ...
    std::vector<Color> brightestColors(int max_recursion) const;

    // Every pixel of options.crop to the sink, by tiles on options.threads threads (render.cpp).
    RenderCounts render(const RenderOptions& options, PixelSink& sink, ProgressListener* progress) const;

    // Some pixels of the picture, as render has them.
    RenderCounts renderPixels(const RenderOptions& options, std::span<const PixelPlace> pixels,
                              std::span<glm::dvec3> colors) const;

    // Renderer::rayTrees.
    RenderCounts rayTrees(const RenderOptions& options, std::span<const PixelPlace> pixels,
                          RayTrees& trees) const;

  private:
    void traverse(const Ray& ray, HitQuery& query, RenderContext& context) const;
    Color pointColor(Real x, Real y, RenderContext& context) const;
    Shadow castShadow(const ShadingPoint& point, const Vec3& toLight, const Light& light,
                      RenderContext& context) const;
    Color lightColor(const ShadingPoint& point, RenderContext& context) const;
    Color reflectedColor(const ShadingPoint& point, const RayPath& path, RenderContext& context) const;
    Color refractedColor(const ShadingPoint& point, const RayPath& path, RenderContext& context) const;
    Color notCast(const RayPath& path, NotCast reason, RenderContext& context) const;
    bool isWorthCasting(const RayPath& path, const RenderContext& context) const;

    ShapeTree tree_;
    bool hasRefractiveShape_ = false;
    const PacketKernel* packets_ = nullptr;
};

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
