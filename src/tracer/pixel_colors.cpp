#include "pixel_colors.h"

#include <algorithm>

#include "raytracer/tracer/sample_grid.h"

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

// Fills in the points' colours.
void pointColors(const Scene& scene, PointPacket& points, const RenderContext& context) {
    if (scene.packets && context.options->pass == Pass::Color && points.count >= PointPacket::least)
        return scene.packets->trace(scene, points, context);
    for (int i = 0; i < points.count; ++i) {
        const RenderContext alone = context.ofSamples(&points.samples[i]);
        const Color color = pointColor(scene, points.x[i], points.y[i], alone);
        for (int channel = 0; channel < 3; ++channel) points.color[channel][i] = color[channel];
    }
}

// Pixels of several samples, which share packets whosever they are.
class PixelGroup {
  public:
    PixelGroup(const Scene& scene, std::span<const PixelPlace> pixels, const RenderContext& context)
        : scene_(scene),
          pixels_(pixels),
          context_(context),
          grid_{context.options->samples},
          tolerance_(static_cast<Real>(context.options->adaptive)) {}

    void render(std::span<Color> colors) {
        for (int pixel = 0; pixel < count(); ++pixel)
            grid_.forEachCorner([&](int i, int j) { add(pixel, i, j); });
        take();
        for (int pixel = 0; pixel < count(); ++pixel)
            if (!isFlat(sums_[pixel])) grid_.forEachOther([&](int i, int j) { add(pixel, i, j); });
        take();
        for (int pixel = 0; pixel < count(); ++pixel) {
            const Sum& sum = sums_[pixel];
            colors[static_cast<std::size_t>(pixel)] = sum.color / static_cast<Real>(sum.taken);
            double& bound = context_.counts->cutoffBound;
            bound = std::max(bound, sum.truncationBound / sum.taken);
        }
    }

  private:
    struct Sum {
        Color color{0};
        int taken = 0;
        double truncationBound = 0;
        ColorSpread<Real> spread;  // of the samples; only for `adaptive`
    };

    int count() const { return static_cast<int>(pixels_.size()); }

    void add(int pixel, int i, int j) {
        const PixelPlace& place = pixels_[static_cast<std::size_t>(pixel)];
        owners_[points_.count] = pixel;
        points_.add(static_cast<Real>(place.x) + grid_.offset<Real>(i),
                    static_cast<Real>(place.y) + grid_.offset<Real>(j));
        if (points_.count == PointPacket::most) take();
    }

    void take() {
        if (points_.count == 0) return;
        pointColors(scene_, points_, context_);
        for (int i = 0; i < points_.count; ++i) {
            Sum& sum = sums_[owners_[i]];
            const Color color = points_.colorOf(i);
            if (tolerance_ > 0) sum.spread.add(color);
            sum.color += color;
            sum.truncationBound += points_.samples[i].truncationBound;
            ++sum.taken;
        }
        points_.count = 0;
    }

    bool isFlat(const Sum& sum) const { return tolerance_ > 0 && sum.spread.largest() <= tolerance_; }

    const Scene& scene_;
    std::span<const PixelPlace> pixels_;
    const RenderContext& context_;
    SampleGrid grid_;
    Real tolerance_;
    PointPacket points_;
    int owners_[PointPacket::most];
    Sum sums_[PointPacket::most];
};

}  // namespace

void pixelColors(const Scene& scene, std::span<const PixelPlace> pixels, std::span<Color> colors,
                 const RenderContext& context, std::span<Observer* const> observers) {
    if (context.options->samples > 1) return PixelGroup(scene, pixels, context).render(colors);
    PointPacket points;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        points.add(static_cast<Real>(pixels[i].x) + Real(0.5), static_cast<Real>(pixels[i].y) + Real(0.5),
                   observers.empty() ? nullptr : observers[i]);
    pointColors(scene, points, context);
    double& bound = context.counts->cutoffBound;
    for (int i = 0; i < points.count; ++i) {
        colors[static_cast<std::size_t>(i)] = points.colorOf(i);
        bound = std::max(bound, points.samples[i].truncationBound);
    }
}

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
