#include "raytracer/scene.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

void Scene::traverse(const Ray& ray, HitQuery& query, RenderContext& context) const {
    for (const auto& shape : shapes) {
        shape->intersect(ray, query);
        if (query.done()) break;
    }
    context.counts.tests += query.tests;
}

// The query's nearest hit; where another one is within rounding of it, the first listed of those that go through the
// same point.
Hit Scene::closestHit(const Ray& ray, HitQuery& query, RenderContext& context) const {
    traverse(ray, query, context);
    if (!query.found() || !query.contended() || query.done()) return query.nearest();
    const Intersection nearest = query.nearest().shape->surfaceAt(ray, query.nearest());
    HitQuery coincident(query.nearest(), nearest.position, nearest.positionError);
    traverse(ray, coincident, context);
    return coincident.nearest();
}

Intersection Scene::closestIntersection(const Ray& ray, RenderContext& context) const {
    HitQuery query;
    const Hit hit = closestHit(ray, query, context);
    return hit.shape ? hit.shape->surfaceAt(ray, hit) : Intersection{};
}

Color Scene::rayColor(const Ray& ray, int max_recursion, RenderContext& context) const {
    const Intersection hit = closestIntersection(ray, context);
    if (!hit.valid) return Color(0);
    const ShadingPoint point(ray, hit);
    Color color = lightColor(point, context);
    if (max_recursion > 0) {
        color += reflectedColor(point, max_recursion, context);
        color += refractedColor(point, max_recursion, context);
    }
    return color;
}

Color Scene::lightColor(const ShadingPoint& point, RenderContext& context) const {
    Color color(0);
    for (const Light& light : lights) {
        const DirectLight direct = directLight(point, light);
        color += direct.ambient;
        if (isBlack(direct.lit)) continue;
        color += context.options->shadows ? direct.lit * shadowFactor(point, direct.toLight, light, context) : direct.lit;
    }
    return color;
}

// S_L: only the closest hit before the light counts.
Color Scene::shadowFactor(const ShadingPoint& point, const Vec3& toLight, const Light& light,
                          RenderContext& context) const {
    ++context.counts.shadow;
    const Ray ray = point.leave(toLight, ShadingPoint::Side::Near);
    const RayEnd end{light.position};
    HitQuery query(end, false);
    const Hit hit = closestHit(ray, query, context);
    if (!hit.shape) return Color(1);
    const Material& material = hit.shape->material();
    return material.refractive ? material.color_refract : Color(0);
}

Color Scene::reflectedColor(const ShadingPoint& point, int max_recursion, RenderContext& context) const {
    const Material& material = *point.hit->material;
    if (!material.reflective || isBlack(material.color_reflect)) return Color(0);
    ++context.counts.reflection;
    const Ray reflected = point.leave(reflectedDirection(point), ShadingPoint::Side::Near);
    return material.color_reflect * rayColor(reflected, max_recursion - 1, context);
}

Color Scene::refractedColor(const ShadingPoint& point, int max_recursion, RenderContext& context) const {
    const Material& material = *point.hit->material;
    Vec3 direction;
    if (!context.options->refraction || !material.refractive || isBlack(material.color_refract) ||
        !refractedDirection(point, direction))
        return Color(0);
    ++context.counts.refraction;
    const Ray refracted = point.leave(direction, ShadingPoint::Side::Far);
    return material.color_refract * rayColor(refracted, max_recursion - 1, context);
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
