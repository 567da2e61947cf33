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

Color Scene::rayColor(const Ray& ray, const RayPath& path, RenderContext& context) const {
    const Intersection hit = closestIntersection(ray, context);
    if (!hit.valid) return Color(0);
    const ShadingPoint point(ray, hit, context.options->bilinear);
    Color color = lightColor(point, context);
    if (path.max_recursion > 0) {
        color += reflectedColor(point, path, context);
        color += refractedColor(point, path, context);
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

Color Scene::reflectedColor(const ShadingPoint& point, const RayPath& path, RenderContext& context) const {
    const Material& material = *point.hit->material;
    if (!material.reflective || isBlack(material.color_reflect)) return Color(0);
    const RayPath onwards{path.weight * material.color_reflect, path.max_recursion - 1};
    if (!isWorthCasting(onwards, context)) return Color(0);
    ++context.counts.reflection;
    const Ray reflected = point.leave(reflectedDirection(point), ShadingPoint::Side::Near);
    return material.color_reflect * rayColor(reflected, onwards, context);
}

Color Scene::refractedColor(const ShadingPoint& point, const RayPath& path, RenderContext& context) const {
    const Material& material = *point.hit->material;
    Vec3 direction;
    if (!context.options->refraction || !material.refractive || isBlack(material.color_refract) ||
        !refractedDirection(point, direction))
        return Color(0);
    const RayPath onwards{path.weight * material.color_refract, path.max_recursion - 1};
    if (!isWorthCasting(onwards, context)) return Color(0);
    ++context.counts.refraction;
    const Ray refracted = point.leave(direction, ShadingPoint::Side::Far);
    return material.color_refract * rayColor(refracted, onwards, context);
}

bool Scene::isWorthCasting(const RayPath& path, RenderContext& context) const {
    if (!context.brightest) return true;
    const Color most = abs(path.weight) * context.brightest[path.max_recursion];
    const auto change = static_cast<double>(maxComponent(most));
    if (change >= context.options->cutoff) return true;
    context.dropped += change;
    return false;
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
            Color color = abs(m.color_ambient) * ambient + (abs(m.color_diffuse) + abs(m.color_specular)) * lit * shadow;
            if (m.reflective) color += abs(m.color_reflect) * onwards;
            if (m.refractive) color += abs(m.color_refract) * onwards;
            most = glm::max(most, color);
        }
        brightest.push_back(most);
    }
    return brightest;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
