#include "raytracer/tracer/scene.h"

#include <algorithm>

#include "raytracer/tracer/cutoff.h"
#include "raytracer/tracer/packet_tracer.h"

namespace raytracer {
inline namespace RAYTRACER_PRECISION_NAMESPACE {

void Scene::index(const BuildOptions& options) {
    tree_ = ShapeTree(shapes, options);
    if (options.accelerator == Accelerator::Bvh) packets_ = packetKernel(options.instructionSet);
    hasRefractiveShape_ = std::any_of(shapes.begin(), shapes.end(),
                                      [](const auto& shape) { return shape->material().refractive; });
}

void Scene::traverse(const Ray& ray, HitQuery& query, RenderContext& context) const {
    tree_.intersect(ray, query);
    context.counts.tests += query.tests;
}

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
    if (context.observer) context.observer->enter(ray, path);
    HitQuery query;
    const Hit hit = closestHit(ray, query, context);
    const Color color = hit.shape ? hitColor(ray, hit, path, context) : Color(0);
    if (context.observer) context.observer->leave(color);
    return color;
}

Color Scene::hitColor(const Ray& ray, const Hit& hit, const RayPath& path, RenderContext& context) const {
    const Intersection intersection = hit.shape->surfaceAt(ray, hit);
    const ShadingPoint point(ray, intersection, context.options->bilinear);
    if (context.observer) context.observer->meet(point);
    Color color = lightColor(point, context);
    if (intersection.material->reflective) color += reflectedColor(point, path, context);
    if (intersection.material->refractive) color += refractedColor(point, path, context);
    return color;
}

Color Scene::lightColor(const ShadingPoint& point, RenderContext& context) const {
    Color color(0);
    for (const Light& light : lights) {
        const DirectLight direct = directLight(point, light);
        Color sum = direct.ambient;
        Shadow shadow;
        const bool asked = context.options->shadows && !isBlack(direct.lit());
        if (asked) shadow = castShadow(point, direct.toLight, light, context);
        sum += direct.lit() * shadow.factor;
        if (context.observer) context.observer->light(direct, asked ? &shadow : nullptr, sum);
        color += sum;
    }
    return color;
}

// S_L: only the closest hit before the light counts; where none is refractive, any will do, but for who asks
// which.
Shadow Scene::castShadow(const ShadingPoint& point, const Vec3& toLight, const Light& light,
                         RenderContext& context) const {
    ++context.counts.shadow;
    const Ray ray = point.leave(toLight, ShadingPoint::Side::Near);
    const RayEnd end{light.position};
    HitQuery query(end, !hasRefractiveShape_ && !(context.observer && context.observer->asksWhatShadows()));
    const Hit hit = closestHit(ray, query, context);
    if (!hit.shape) return {};
    const Material& material = hit.shape->material();
    return {material.refractive ? material.color_refract : Color(0), hit.shape};
}

Color Scene::reflectedColor(const ShadingPoint& point, const RayPath& path, RenderContext& context) const {
    const Material& material = *point.hit->material;
    const RayPath onwards{path.weight * material.color_reflect, path.max_recursion - 1, RayKind::Reflection};
    if (const NotCast reason = whyNotReflected(material, onwards, context); reason != NotCast::Nothing)
        return notCast(onwards, reason, context);
    ++context.counts.reflection;
    const Ray reflected = point.leave(reflectedDirection(point), ShadingPoint::Side::Near);
    return material.color_reflect * rayColor(reflected, onwards, context);
}

Color Scene::refractedColor(const ShadingPoint& point, const RayPath& path, RenderContext& context) const {
    if (!context.options->refraction) return Color(0);
    const Material& material = *point.hit->material;
    const RayPath onwards{path.weight * material.color_refract, path.max_recursion - 1, RayKind::Refraction};
    NotCast reason = whyNotRefracted(material, onwards, context);
    Vec3 direction;
    if ((reason == NotCast::Nothing || reason == NotCast::Cutoff) && !refractedDirection(point, direction))
        reason = NotCast::TotalInternalReflection;
    if (reason != NotCast::Nothing) return notCast(onwards, reason, context);
    ++context.counts.refraction;
    const Ray refracted = point.leave(direction, ShadingPoint::Side::Far);
    return material.color_refract * rayColor(refracted, onwards, context);
}

Color Scene::notCast(const RayPath& path, NotCast reason, RenderContext& context) const {
    if (reason == NotCast::Cutoff) context.dropped += mostChange(path, context);
    if (context.observer) context.observer->notCast(path.kind, reason);
    return Color(0);
}

NotCast Scene::whyNotReflected(const Material& material, const RayPath& onwards,
                               const RenderContext& context) const {
    if (onwards.max_recursion < 0) return NotCast::MaxRecursion;
    if (isBlack(material.color_reflect)) return NotCast::Black;
    return isWorthCasting(onwards, context) ? NotCast::Nothing : NotCast::Cutoff;
}

NotCast Scene::whyNotRefracted(const Material& material, const RayPath& onwards,
                               const RenderContext& context) const {
    if (onwards.max_recursion < 0) return NotCast::MaxRecursion;
    if (isBlack(material.color_refract)) return NotCast::Black;
    return isWorthCasting(onwards, context) ? NotCast::Nothing : NotCast::Cutoff;
}

double Scene::mostChange(const RayPath& path, const RenderContext& context) const {
    return throughputBound(path.weight, context.brightest[path.max_recursion]);
}

bool Scene::isWorthCasting(const RayPath& path, const RenderContext& context) const {
    return !context.brightest || mostChange(path, context) >= context.options->cutoff;
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
        brightest.push_back(most);
    }
    return brightest;
}

}  // namespace RAYTRACER_PRECISION_NAMESPACE
}  // namespace raytracer
