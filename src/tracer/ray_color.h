// The recursion, by the assignment's formula:
//
//   K_R I_R + K_T I_T + sum over lights (K_A I_AL + [K_D I_L (N.L) + K_S I_L (V.R)^n] S_L)
//
// T is Real for one ray, Lanes for a packet: a lane's colour has the bits that its ray has alone. The rays of
// a packet go on together while at least three of them hit the same face of the same shape from the same side
// (on a mesh, any triangle). The others go on alone. scene.cpp compiles this for Real, and has what is not a
// template; packet_tracer.cpp compiles it for Lanes.
#pragma once

#include "raytracer/tracer/scene.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Calls tell(observer, lane) for the active lanes, if there are observers.
template <class T, class Tell>
void observe(LaneBits active, const RenderContext& context, Tell tell) {
    if (context.samples->observer)
        forEach<T>(active, [&](int lane) { tell(*context.samples[lane].observer, lane); });
}

template <class T>
ColorT<T> Scene::rayColor(const RayT<T>& ray, LaneBits active, const RayPath& path,
                          const RenderContext& context) const {
    observe<T>(active, context, [&](Observer& o, int lane) { o.enter(laneOf(ray, lane), path); });
    HitQueryT<T> query(active);
    closestHits(ray, query, path.kind == RayKind::Primary ? &fromEye : nullptr, context);
    ColorT<T> color(T(0));  // of a miss
    for (LaneBits left = query.found(); left != 0;) {
        const LaneBits coherent = query.coherent(left);
        left &= ~coherent;
        color = select(maskOf<T>(coherent), coherentColor(ray, query, coherent, path, context), color);
    }
    observe<T>(active, context, [&](Observer& o, int lane) { o.leave(laneOf(color, lane)); });
    return color;
}

// Finds the nearest hit of each active lane; where other hits are within rounding of it, the first listed of
// those at the same point.
template <class T>
void Scene::closestHits(const RayT<T>& ray, HitQueryT<T>& query, const DirectionBuffer* buffer,
                        const RenderContext& context) const {
    if (buffer && !buffer->empty()) buffer->meet(ray, query);
    else tree.meet(ray, query);
    context.counts->tests += query.tests;
    forEach<T>(query.contended(), [&](int lane) {
        query.set(lane, firstOfCoincident(laneOf(ray, lane), query.nearest(lane), context));
    });
}

template <class T>
ColorT<T> Scene::coherentColor(const RayT<T>& ray, const HitQueryT<T>& query, LaneBits coherent,
                               const RayPath& path, const RenderContext& context) const {
    if constexpr (laneCountOf<T> == 1) {
        return hitColor(ray, query.nearest(), coherent, path, context);
    } else {
        if (countLanes<T>(coherent) >= fewestRays) {
            RayT<T> some;
            if (coherent != allLanesOf<T>) some = filled(ray, coherent);
            const RayT<T>& together = coherent == allLanesOf<T> ? ray : some;
            const HitT<T> hit = query.hits(coherent);
            if (hit.shape->areCoherent(together, coherent))
                return hitColor(together, hit, coherent, path, context);
        }
        ColorT<T> color(T(0));
        forEach<T>(coherent, [&](int lane) {
            const RenderContext alone = context.ofSamples(context.samples + lane);
            setLane(color, lane, hitColor(laneOf(ray, lane), query.nearest(lane), path, alone));
        });
        return color;
    }
}

template <class T>
ColorT<T> Scene::hitColor(const RayT<T>& ray, const HitT<T>& hit, LaneBits active, const RayPath& path,
                          const RenderContext& context) const {
    const IntersectionT<T> intersection = hit.shape->surface(ray, hit);
    const ShadingPointT<T> point(ray, intersection, context.options->bilinear);
    observe<T>(active, context,
               [&](Observer& o, int lane) { o.meet(laneOf(intersection, lane), laneOf(point.K_D, lane)); });
    ColorT<T> color = lightColor(point, active, context);
    if (intersection.material->reflective) color += reflectedColor(point, active, path, context);
    if (intersection.material->refractive) color += refractedColor(point, active, path, context);
    return color;
}

template <class T>
ColorT<T> Scene::lightColor(const ShadingPointT<T>& point, LaneBits active,
                            const RenderContext& context) const {
    ColorT<T> color(T(0));
    for (std::size_t light = 0; light < lights.size(); ++light) {
        const DirectLightT<T> direct = directLight(point, lights[light]);
        const ColorT<T> lit = direct.lit();
        ColorT<T> sum = direct.ambient;
        const LaneBits unlit = bits((lit.x == T(0)) & (lit.y == T(0)) & (lit.z == T(0)));
        const LaneBits shadowed = context.options->shadows ? active & ~unlit : 0;
        sum += shadowed != 0 ? lit * shadow(point, direct.toLight, light, shadowed, context) : lit;
        observe<T>(active, context,
                   [&](Observer& o, int lane) { o.light(laneOf(direct, lane), laneOf(sum, lane)); });
        color += sum;
    }
    return color;
}

// S_L, from the closest hit before the light. Where no shape is refractive any hit gives 0, so the search
// stops at the first one found, unless an observer asks which shape it is.
template <class T>
ColorT<T> Scene::shadow(const ShadingPointT<T>& point, const Vec3T<T>& toLight, std::size_t light,
                        LaneBits active, const RenderContext& context) const {
    context.counts->shadow += countLanes<T>(active);
    const Observer* observer = context.samples->observer;
    HitQueryT<T> query(lights[light].position,
                       !hasRefractiveShape && !(observer && observer->asksWhatShadows()), active);
    closestHits(point.leave(toLight, ShadingPointT<T>::Side::Near), query,
                light < toLights.size() ? &toLights[light] : nullptr, context);
    ColorT<T> factor = select(maskOf<T>(query.found()), ColorT<T>(T(0)), ColorT<T>(T(1)));
    if (hasRefractiveShape)
        forEach<T>(query.found(), [&](int lane) {
            const Material& material = query.nearest(lane).shape->material();
            if (material.refractive) setLane(factor, lane, material.color_refract);
        });
    observe<T>(active, context,
               [&](Observer& o, int lane) { o.shadow(query.nearest(lane).shape, laneOf(factor, lane)); });
    return factor;
}

template <class T>
ColorT<T> Scene::reflectedColor(const ShadingPointT<T>& point, LaneBits active, const RayPath& path,
                                const RenderContext& context) const {
    const Material& material = *point.hit->material;
    const RayPath onwards = path.onwards(RayKind::Reflection, material.color_reflect);
    const TerminationReason reason = terminationReason(onwards, material.color_reflect, context);
    if (reason != TerminationReason::None) {
        terminate(active, onwards, reason, context);
        return ColorT<T>(T(0));
    }
    count(context.counts->reflection, countLanes<T>(active), context);
    const RayT<T> reflected = point.leave(reflectedDirection(point), ShadingPointT<T>::Side::Near, true);
    return ColorT<T>(material.color_reflect) * withinBrightest(rayColor(reflected, active, onwards, context));
}

template <class T>
ColorT<T> Scene::refractedColor(const ShadingPointT<T>& point, LaneBits active, const RayPath& path,
                                const RenderContext& context) const {
    if (!context.options->refraction) return ColorT<T>(T(0));
    const Material& material = *point.hit->material;
    const RayPath onwards = path.onwards(RayKind::Refraction, material.color_refract);
    const TerminationReason reason = terminationReason(onwards, material.color_refract, context);
    LaneBits passing = active;
    Vec3T<T> direction;
    if (reason == TerminationReason::None || reason == TerminationReason::Cutoff) {
        passing &= bits(refractedDirection(point, direction));
        const LaneBits inside = active & ~passing;
        if (inside != 0) terminate(inside, onwards, TerminationReason::TotalInternalReflection, context);
    }
    if (reason != TerminationReason::None) terminate(passing, onwards, reason, context);
    if (passing == 0 || reason != TerminationReason::None) return ColorT<T>(T(0));
    count(context.counts->refraction, countLanes<T>(passing), context);
    if (passing != allLanesOf<T>) direction = filled(direction, passing);
    const RayT<T> refracted = point.leave(direction, ShadingPointT<T>::Side::Far, true);
    return select(
        maskOf<T>(passing),
        ColorT<T>(material.color_refract) * withinBrightest(rayColor(refracted, passing, onwards, context)),
        ColorT<T>(T(0)));
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
