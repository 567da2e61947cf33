// A pixel's colour from its samples so far, and an estimate of its error, which tells when to stop.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "raytracer/tracer/contrast.h"
#include "raytracer/tracer/render_options.h"

namespace raytracer {

// The next number of samples at which a pixel may stop: 1, 4, 8, 16 ... up to the limit.
inline int nextLevel(int samples, int limit) { return std::min(limit, samples == 1 ? 4 : 2 * samples); }

class PixelEstimate {
  public:
    // The estimated error of one sample, relative to the contrast.
    static constexpr double errorOfOneSample = 0.25;

    // Linear, unclamped.
    void add(const glm::dvec3& color) {
        constexpr double enough = mostSamples;  // one such sample makes any pixel white
        const glm::dvec3 bounded = glm::clamp(color, -enough, enough);
        if (count_++ == 0) first_ = bounded;
        sum_ += color;
        const glm::dvec3 difference = bounded - first_;
        glm::dvec3 power(1);
        for (glm::dvec3& sum : powers_) sum += power *= difference;
    }

    glm::dvec3 color() const { return sum_ / static_cast<double>(count_); }
    int samples() const { return count_; }

    // A weighted estimate of the error of the colour, as it is shown: clamped to [0, 1]. While it is too
    // large, the pixel takes more samples. n samples are spread evenly: a part of the pixel that should have
    // k of them has about k^1/4 too many or too few, next to its edge (Mitchell 1996). With m the fourth root
    // of the samples' fourth central moment, that is m / n^3/4. But n samples that agree may still miss about
    // 1/n of the pixel, and that part may differ by as much as the neighbourhood does: `contrast` is that of
    // the 3 x 3 centres around the pixel. `least` is the contrast that any neighbourhood may hide
    // (leastContrast). It counts in white pixels, too, which may hide something dark: it is not clamped.
    double error(double contrast, double least) const {
        const auto n = static_cast<double>(count_);
        // As bright as contrasts count: so one bright sample beside black ones is not sure to be white.
        const glm::dvec3 bounded = glm::clamp(color(), -brightestInContrast, brightestInContrast);
        const glm::dvec3 spread = glm::sqrt(glm::sqrt(fourthMoment())) * std::sqrt(std::sqrt(n)) / n;
        return weight(n) * std::max({missed(least, n), shown(bounded, glm::dvec3(missed(contrast, n))),
                                     shown(color(), spread)});
    }

  private:
    // (16 / n)^1/4 from the second sample on. It lets a pixel of many samples keep more error, since there a
    // further sample lowers the picture's squared error, e^2, by only 1.5 e^2 / n.
    static double weight(double n) { return n == 1 ? 1 : 2 / std::sqrt(std::sqrt(n)); }
    static double missed(double contrast, double n) { return contrast * errorOfOneSample / n; }

    glm::dvec3 fourthMoment() const {
        const auto n = static_cast<double>(count_);
        const glm::dvec3 mean = powers_[0] / n, square = mean * mean;
        const glm::dvec3 sum =
            powers_[3] - 4.0 * mean * powers_[2] + 6.0 * square * powers_[1] - 3 * n * square * square;
        return glm::max(sum, 0.0) / std::max(1.0, n - 1);
    }

    // The root mean square, over the channels, of an estimated error of the unclamped colour, as far as it
    // shows. The true error may be several times the estimate, so only where four times the estimate shows
    // nothing, since all is white, this error is 0.
    static double shown(const glm::dvec3& mean, const glm::dvec3& error) {
        const auto clamped = [](const glm::dvec3& unclamped) { return glm::clamp(unclamped, 0.0, 1.0); };
        const glm::dvec3 here = clamped(mean), most = error / errorOfOneSample;
        const glm::dvec3 visible = glm::max(here - clamped(mean - most), clamped(mean + most) - here);
        const glm::dvec3 off = glm::min(error, visible);
        return std::sqrt(glm::dot(off, off) / 3);
    }

    glm::dvec3 sum_{0};
    glm::dvec3 first_{0};     // the first sample, bounded
    glm::dvec3 powers_[4]{};  // the sums of the differences from it, of their squares, cubes, fourth powers
    int count_ = 0;
};

}  // namespace raytracer
