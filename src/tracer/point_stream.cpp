#include "point_stream.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

namespace {

Color pointColor(const Scene& scene, Real x, Real y, const RenderContext& context) {
    const RenderOptions& options = *context.options;
    const Camera& camera = scene.camera;
    const Ray ray = camera.getRay(camera.getPixelUV(x, y, options.size.width, options.size.height));
    ++context.counts->primary;
    if (options.pass == Pass::Color) return scene.rayColor(ray, {Color(1), options.max_recursion}, context);
    const Intersection hit = scene.closestIntersection(ray, context);
    if (options.pass == Pass::Raycast) return hit.valid ? hit.material->color_diffuse : Color(0);
    return hit.valid ? (hit.normal + Real(1)) / Real(2) : Color(Real(54) / 255);
}

}  // namespace

void traceAll(const Scene& scene, PointPacket& points, const RenderContext& context) {
    if (scene.tracePacket && context.options->pass == Pass::Color && points.count >= int{fewestRays})
        return scene.tracePacket(scene, points, context);
    for (int i = 0; i < points.count; ++i) {
        const RenderContext alone = context.ofSamples(&points.samples[i]);
        const Color color = withinDouble(pointColor(scene, points.x[i], points.y[i], alone));
        for (int channel = 0; channel < 3; ++channel) points.color[channel][i] = color[channel];
    }
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
