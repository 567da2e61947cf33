#include "raytracer/tracer/scene.h"

#include "ray_color.h"
#include "raytracer/tracer/cutoff.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

Color Scene::rayColor(const Ray& ray, const RayPath& path, const RenderContext& context) const {
    return rayColor(ray, allLanesOf<Real>, path, context);
}

Color Scene::hitColor(const Ray& ray, const Hit& hit, const RayPath& path,
                      const RenderContext& context) const {
    return hitColor(ray, hit, allLanesOf<Real>, path, context);
}

Intersection Scene::closestIntersection(const Ray& ray, const RenderContext& context) const {
    HitQuery query;
    closestHits(ray, query, nullptr, context);
    return query.found() ? query.nearest().shape->surface(ray, query.nearest()) : Intersection{};
}

// Surfaces that lie apart may have the same rounded t. A ray from `nearest` back along `ray` shows whether a
// surface lies before it. That surface counts if `ray` itself, rounded, hits its shape. Each round goes one
// surface nearer; `passed` counts the surfaces left behind.
Hit Scene::firstOfCoincident(const Ray& ray, Hit nearest, const RenderContext& context) const {
    for (unsigned passed = 0;; ++passed) {
        const Intersection place = nearest.shape->surface(ray, nearest);
        HitQuery coincident(nearest, place.position, place.positionError);
        tree.meet(ray, coincident);
        context.counts->tests += coincident.tests;
        if (coincident.apart() <= passed) return coincident.nearest();
        HitQuery before = HitQuery::upTo(nearest.t * coincidenceWindow);
        const ShadingPoint point(ray, place, false);
        tree.meet(point.leave(-ray.direction, ShadingPoint::Side::Near, ray.departure.isScattered), before);
        context.counts->tests += before.tests;
        if (!before.found()) return coincident.nearest();
        HitQuery ahead = HitQuery::upTo(nearest.t * (1 + coincidenceWindow));
        before.nearest().shape->intersect(ray, ahead);
        context.counts->tests += ahead.tests;
        if (!ahead.found()) return coincident.nearest();
        nearest = ahead.nearest();
    }
}

void Scene::count(std::uint64_t& kind, unsigned rays, const RenderContext& context) {
    kind += rays;
    if (context.counts->onwards() > context.mostRays) throw TooManyRays(*context.counts);
}

TerminationReason Scene::terminationReason(const RayPath& onwards, const Color& factor,
                                           const RenderContext& context) const {
    if (onwards.max_recursion < 0) return TerminationReason::MaxRecursion;
    if (isBlack(factor)) return TerminationReason::Black;
    if (!context.brightest) return TerminationReason::None;
    const double bound = throughputBound(onwards.weight, context.brightest[onwards.max_recursion]);
    return bound >= context.options->cutoff ? TerminationReason::None : TerminationReason::Cutoff;
}

void Scene::terminate(LaneBits lanes, const RayPath& onwards, TerminationReason reason,
                      const RenderContext& context) const {
    for (; lanes != 0; lanes &= lanes - 1) {
        SampleTrace& sample = context.samples[firstLane(lanes)];
        if (reason == TerminationReason::Cutoff)
            sample.truncationBound +=
                throughputBound(onwards.weight, context.brightest[onwards.max_recursion]);
        if (reason == TerminationReason::Cutoff || reason == TerminationReason::MaxRecursion)
            sample.leftOut += static_cast<double>(maxComponent(abs(onwards.weight)));
        if (sample.observer) sample.observer->terminate(onwards.kind, reason);
    }
}

std::vector<Color> Scene::brightestColors(int max_recursion) const {
    Color ambient(0), lit(0), shadow(1);
    for (const Light& light : lights) {
        ambient += abs(light.color_ambient);
        lit += abs(light.color);
    }
    for (const Material& material : materials)
        if (material.refractive) shadow = glm::max(shadow, abs(material.color_refract));
    std::vector<Color> brightest;
    for (Color onwards(0); static_cast<int>(brightest.size()) <= max_recursion; onwards = brightest.back()) {
        Color most(0);
        for (const Material& m : materials) {
            Color color = abs(m.color_ambient) * ambient +
                          (abs(m.color_diffuse) + abs(m.color_specular)) * lit * shadow;
            if (m.reflective) color += abs(m.color_reflect) * onwards;
            if (m.refractive) color += abs(m.color_refract) * onwards;
            most = glm::max(most, color);
        }
        brightest.push_back(withinBrightest(most));
    }
    return brightest;
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
