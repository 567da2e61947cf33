#include "raytracer/accuracy/ray_growth.h"

#include <algorithm>
#include <cmath>

#include "picture_points.h"

namespace raytracer {

namespace {

constexpr std::size_t pilots = 64;  // points of the picture

// Reflected and refracted rays per sample at a depth; empty if they are too many.
std::optional<double> raysOf(const Renderer& renderer, RenderOptions options, int max_recursion) {
    options.max_recursion = max_recursion;
    std::vector<glm::dvec3> colors(pilots);
    try {
        const RenderCounts counts =
            renderer.renderPoints(options, picturePoints(options.size, pilots, PointsFor::rayGrowth), colors);
        return static_cast<double>(counts.onwards()) / pilots;
    } catch (const TooManyRays&) {
        return std::nullopt;
    }
}

}  // namespace

std::optional<double> excessiveRays(const SceneDescription& scene, const Renderer& renderer,
                                    const RenderOptions& options) {
    const bool doubles =
        std::ranges::any_of(scene.materials, [](const auto& m) { return m.reflective && m.refractive; });
    if (!doubles || raysOf(renderer, options, options.max_recursion)) return std::nullopt;
    int depth = 1;
    double before = 0, rays = 0;
    while (const auto deeper = raysOf(renderer, options, depth)) {
        before = rays;
        rays = *deeper;
        ++depth;
    }
    const double growth = rays / before;
    return rays * std::pow(growth, options.max_recursion - (depth - 1));
}

}  // namespace raytracer
