// A random sample of a picture's pixels, rendered with many settings, estimates the cost and the error of the
// whole picture with each. A pixel rendered alone is the pixel of the picture.
#pragma once

#include <functional>
#include <memory>

#include "raytracer/accuracy/picture_error.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

// About `count` pixels, one at a pseudo-random place in each cell of a square lattice; every pixel if the
// crop has no more than `count`. Another seed gives other places.
std::vector<PixelPlace> scatteredPixels(const PixelRectangle& crop, std::size_t count, std::uint32_t seed);

class Pilot {
  public:
    // Renders with `options`, except for what a setting sets. Keeps references to renderer and options.
    Pilot(const Renderer& renderer, const RenderOptions& options, std::vector<PixelPlace> pixels);
    ~Pilot();

    // Rendered once for each setting, in the renderer's precision, whatever the setting's is. Settings that
    // differ only in `adaptive` share their samples.
    const std::vector<glm::dvec3>& colors(const Setting& setting);

    // Rays per pixel. With `adaptive` an estimate that renders only the corners and assumes that all samples
    // of a pixel cost the same.
    double rays(const Setting& setting);

    // Of a setting, with another one as the truth.
    PictureError error(const Setting& setting, const Setting& truth);
    MeanSquare squaredError(const Setting& setting, const Setting& truth);

    // Estimates the truth of each pixel twice, with a setting's depth: the mean of at least n x n samples,
    // each at a random place in its cell of the pixel (jittered sampling; Cook 1986).
    void sampleTruth(const Setting& depth, int n);
    // The errors against that truth.
    std::vector<double> squaredErrors(std::span<const glm::dvec3> colors) const;
    MeanSquare squaredError(const Setting& setting);
    // Of a setting that differs from `deep` by a smaller depth: 2 x 2 samples estimate the truncation error.
    MeanSquare squaredErrorOfShallow(const Setting& setting, const Setting& deep);
    // The part of pixels whose corners stand for all samples, as if the other pixels had no error.
    MeanSquare squaredErrorOfFlat(const Setting& setting);

    std::span<const PixelPlace> pixels() const { return pixels_; }
    std::size_t pixelCount() const { return pixels_.size(); }
    double raysSpent() const { return spent_; }

  private:
    struct Grid;  // samples of each pixel
    struct Picture {
        Setting setting;
        std::vector<glm::dvec3> colors;
    };
    Grid& gridOf(Setting setting);  // a new one has all samples, or with `adaptive` only the corners
    void addSamples(Grid& grid, std::span<const std::size_t> pixels, bool corners, bool others);
    std::vector<glm::dvec3> samples(Setting setting, int scale, std::span<const PixelPlace> places);

    const Renderer& renderer_;
    const RenderOptions& options_;
    std::vector<PixelPlace> pixels_;
    std::vector<std::unique_ptr<Grid>> grids_;
    std::vector<std::unique_ptr<const Picture>> pictures_;
    std::vector<glm::dvec3> truths_[2];
    int truthSamples_ = 0;  // of each pixel, in each of the two
    double spent_ = 0;
};

// The depth of the recursion, by the two parameters that limit it: its cost and its truncation error.
struct DepthChoice {
    int max_recursion = 0;
    double cutoff = 0;
    double rays = 0;           // per pixel, at one sample a pixel
    double error = 0;          // the truncation error: RMSE against the deepest, with the same samples
    double standardError = 0;  // of the truncation error
};

// Measures the grid's depths up to `deepest` with each cutoff, until the error is at most `enough`. Returns
// the Pareto front of cost and error, the cheapest first.
using MeasureDepth = std::function<DepthChoice(int max_recursion, double cutoff)>;
std::vector<DepthChoice> depthFront(const MeasureDepth& measure, int deepest, std::span<const double> cutoffs,
                                    double enough);

}  // namespace raytracer
