// A few pixels of a picture, scattered over it, rendered under many settings: what a whole picture would
// cost, and how far off it would be. A pixel is the same whether alone or in the picture, so that this is a
// random sample of it.
#pragma once

#include <functional>
#include <memory>

#include "raytracer/accuracy/picture_error.h"
#include "raytracer/accuracy/setting.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

// About `count` pixels, one at a pseudo-random place of each cell of a square lattice; every pixel where the
// crop has no more than `count`. Other seeds, other places.
std::vector<PixelPlace> scatteredPixels(const PixelRectangle& crop, std::size_t count, std::uint32_t seed);

class Pilot {
  public:
    // Renders with `options`, but for the knobs. All are kept by reference, but for the pixels.
    Pilot(const Renderer& renderer, const RenderOptions& options, std::vector<PixelPlace> pixels);
    ~Pilot();

    // Rendered once for each setting. Its precision is the renderer's, whatever the setting says. Samples are
    // shared: of one number the corners, and what lies between them where a tolerance of `adaptive` asks for
    // it, are taken once for all.
    const std::vector<glm::dvec3>& colors(const Setting& setting);

    // For each pixel. With `adaptive` an estimate, as if all samples of the pixels that take them cost the
    // same; takes no more than the corners itself.
    double rays(const Setting& setting);

    // Of a setting, taking another one for the truth.
    PictureError error(const Setting& setting, const Setting& truth);
    MeanSquare squaredError(const Setting& setting, const Setting& truth);

    // Estimates the truth of each pixel twice, as deep as a setting: by means of at least n x n samples, each
    // at a random place of its cell of the pixel (jittered sampling; Cook 1986).
    void sampleTruth(const Setting& depth, int n);
    std::vector<double> squaredErrors(
        std::span<const glm::dvec3> colors) const;  // of each pixel, against that truth
    MeanSquare squaredError(const Setting& setting);
    // Of a setting that is less deep than `deep`, which is it otherwise: by what 2 x 2 samples say that the
    // depth changes.
    MeanSquare squaredErrorOfShallow(const Setting& setting, const Setting& deep);
    MeanSquare squaredErrorOfFlat(
        const Setting& setting);  // as if the pixels that adaptive takes all samples of were right

    std::span<const PixelPlace> pixels() const { return pixels_; }
    std::size_t pixelCount() const { return pixels_.size(); }
    double raysSpent() const { return spent_; }  // in all

  private:
    struct Grid;  // samples of each pixel
    struct Picture {
        Setting setting;
        std::vector<glm::dvec3> colors;
    };
    Grid& gridOf(Setting setting);  // all samples, but with adaptive only the corners, if it was not there
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

// How deep rays go: both knobs that decide it, what that costs, and what it leaves out.
struct DepthChoice {
    int max_recursion = 0;
    double cutoff = 0;
    double rays = 0;           // for each pixel of one sample
    double error = 0;          // RMSE against the deepest, with the same samples
    double standardError = 0;  // of that
};

// Tries the grid's depths up to `deepest` with each of these cutoffs, until the error is no more than
// `enough`. Returns those that are on the front of cost and error, from the cheapest on.
using MeasureDepth = std::function<DepthChoice(int max_recursion, double cutoff)>;
std::vector<DepthChoice> depthFront(const MeasureDepth& measure, int deepest, std::span<const double> cutoffs,
                                    double enough);

}  // namespace raytracer
