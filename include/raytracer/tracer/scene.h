// A scene in Real, and the recursion that finds the colour of a ray.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "raytracer/geometry/shape_tree.h"
#include "raytracer/tracer/camera.h"
#include "raytracer/tracer/observer.h"
#include "raytracer/tracer/render_options.h"
#include "raytracer/util/large_vector.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// The state of the recursion at a ray: the factor of its colour in the pixel's (throughput), and how often it
// may still be reflected or refracted.
struct RayPath {
    Color weight{1};
    int max_recursion = 0;
    RayKind kind = RayKind::Primary;

    // For a ray that is reflected or refracted, and whose colour is multiplied by `factor`.
    RayPath onwards(RayKind next, const Color& factor) const {
        return {withinBrightest(weight * factor), max_recursion - 1, next};
    }
};

// What is kept for a camera ray besides its colour.
struct SampleTrace {
    double truncationBound = 0;  // an upper bound on what rays terminated by the cutoff change it by
    double leftOut = 0;          // the weights of rays terminated by max_recursion or the cutoff, added up
    Observer* observer = nullptr;
};

struct Scene;

// What a thread traces rays with.
struct RenderContext {
    const RenderOptions* options;
    const Color* brightest;  // by max_recursion, Scene::brightestColors; null where there is no cutoff
    RenderCounts* counts;
    SampleTrace* samples = nullptr;  // of the rays traced now, one for each lane
    std::uint64_t mostRays =
        std::numeric_limits<std::uint64_t>::max();  // in counts->onwards(); beyond it, TooManyRays

    RenderContext ofSamples(SampleTrace* which) const {
        return {options, brightest, counts, which, mostRays};
    }
};

struct PointPacket;  // packet_tracer.h
// Fills in the points' colours; x and y beyond count may change.
using TracePacket = void(const Scene& scene, PointPacket& points, const RenderContext& context);

// Fewer rays are faster one at a time.
inline constexpr unsigned fewestRays = 3;

// Made by scene_builder.h. A function with T is for one ray or several (ray_color.h); `active` are the lanes
// in use.
struct Scene {
    SceneFrame frame;
    Camera camera;
    std::vector<Material> materials;
    std::vector<Light> lights;
    LargeVector<Shape> shapes;                             // with materials as above
    std::vector<std::shared_ptr<const Texture>> textures;  // keeps alive what materials point to
    ShapeTree tree;                                        // of the shapes
    DirectionBuffer fromEye;                               // empty for an orthographic camera
    std::vector<DirectionBuffer> toLights;                 // of the first lights; maybe empty
    bool hasRefractiveShape = false;
    bool fits = true;                    // in Real, as numerics.h has it; where not, the picture may be wrong
    TracePacket* tracePacket = nullptr;  // null: each ray is traced alone

    Scene() = default;
    Scene(const Scene&) = delete;  // shapes point to materials

    // The nearest intersection with t >= 0; where surfaces coincide, that with the one listed first.
    Intersection closestIntersection(const Ray& ray, const RenderContext& context) const;

    // The colour seen along a ray, and along a ray whose nearest hit is known. A path of RayKind::Primary is
    // for a ray from the camera.
    Color rayColor(const Ray& ray, const RayPath& path, const RenderContext& context) const;
    Color hitColor(const Ray& ray, const Hit& hit, const RayPath& path, const RenderContext& context) const;
    template <class T>
    ColorT<T> rayColor(const RayT<T>& ray, LaneBits active, const RayPath& path,
                       const RenderContext& context) const;

    // Upper bounds on a ray's colour for max_recursion 0, 1, ..., from the colours of the materials and
    // lights alone.
    std::vector<Color> brightestColors(int max_recursion) const;

  private:
    template <class T>
    void closestHits(const RayT<T>& ray, HitQueryT<T>& query, const DirectionBuffer* buffer,
                     const RenderContext& context) const;
    Hit firstOfCoincident(const Ray& ray, Hit nearest, const RenderContext& context) const;
    template <class T>
    ColorT<T> coherentColor(const RayT<T>& ray, const HitQueryT<T>& query, LaneBits coherent,
                            const RayPath& path, const RenderContext& context) const;
    template <class T>
    ColorT<T> hitColor(const RayT<T>& ray, const HitT<T>& hit, LaneBits active, const RayPath& path,
                       const RenderContext& context) const;
    template <class T>
    ColorT<T> lightColor(const ShadingPointT<T>& point, LaneBits active, const RenderContext& context) const;
    template <class T>
    ColorT<T> shadow(const ShadingPointT<T>& point, const Vec3T<T>& toLight, std::size_t light,
                     LaneBits active, const RenderContext& context) const;
    template <class T>
    ColorT<T> reflectedColor(const ShadingPointT<T>& point, LaneBits active, const RayPath& path,
                             const RenderContext& context) const;
    template <class T>
    ColorT<T> refractedColor(const ShadingPointT<T>& point, LaneBits active, const RayPath& path,
                             const RenderContext& context) const;
    static void count(std::uint64_t& kind, unsigned rays, const RenderContext& context);
    // Why a surface casts no ray onwards: the same for all rays that hit one material. `terminate` records
    // it.
    TerminationReason terminationReason(const RayPath& onwards, const Color& factor,
                                        const RenderContext& context) const;
    void terminate(LaneBits lanes, const RayPath& onwards, TerminationReason reason,
                   const RenderContext& context) const;
};

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
