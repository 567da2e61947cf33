// The converged picture that errors are measured against.
#include "raytracer/accuracy/tradeoff.h"

#include "picture_points.h"

namespace raytracer {

namespace {

// The reference has a cutoff only if it would cast more than tooManyRays times as many rays without. In glass
// both the reflected and the refracted ray go on: rays double with each bounce long after they stop
// mattering. The report states the bound on the resulting error.
constexpr double glassCutoff = 1e-5, tooManyRays = 4;

// The depth is converged if doubling it changes the picture by at most this RMSE. It is a tenth of the
// smallest error that the grid reaches; since squares add up, it changes that error by 0.5 %.
constexpr double deepEnough = 1e-4;

// The colours of some points at a depth, and the rays that they cast.
struct Pilot {
    std::vector<glm::dvec3> colors;
    double rays = 0;
};

Pilot pilotAt(const Renderer& renderer, const RenderOptions& options, const Setting& depth) {
    const std::vector<glm::dvec2> points = picturePoints(options.size, 2000, PointsFor::depth);
    Pilot pilot{std::vector<glm::dvec3>(points.size())};
    pilot.rays =
        static_cast<double>(renderer.renderPoints(withSetting(options, depth), points, pilot.colors).all());
    return pilot;
}

// One sample a pixel, converged in depth.
Setting deepSetting(const Renderer& renderer, const RenderOptions& options) {
    const auto at = [](int depth, double cutoff) {
        return Setting{.max_recursion = depth, .cutoff = cutoff};
    };
    const auto pilot = [&](int depth, double cutoff) {
        return pilotAt(renderer, options, at(depth, cutoff));
    };
    int deep = 4;
    try {
        while (deep < 64 &&
               pictureError(pilot(deep, glassCutoff).colors, pilot(2 * deep, glassCutoff).colors).rmse >
                   deepEnough)
            deep *= 2;
        // The cheapest depth first, so as to stop before a very expensive one: twice the depth at most
        // squares the number of rays.
        for (int depth = 4; depth <= deep; depth *= 2)
            if (pilot(depth, 0).rays > tooManyRays * pilot(depth, glassCutoff).rays)
                return at(deep, glassCutoff);
    } catch (const TooManyRays&) {
        return at(deep, glassCutoff);
    }
    return at(deep, 0);
}

}  // namespace

Reference makeReference(const Renderer& renderer, const RenderOptions& options, int samples) {
    Reference reference;
    reference.setting = reference.half = deepSetting(renderer, options);
    reference.setting.samples = 4 * samples;
    reference.half.samples = 2 * samples;
    RenderOptions whole = withSetting(options, reference.setting),
                  half = withSetting(options, reference.half);
    whole.sequence = 1;
    half.sequence = 2;
    RenderedColors picture = rendered(renderer, whole);
    reference.colors = std::move(picture.colors);
    reference.cutoffBound = picture.counts.cutoffBound;
    reference.doublingError = pictureError(rendered(renderer, half).colors, reference.colors).rmse;
    return reference;
}

}  // namespace raytracer
