// A pixel's colour from its samples so far, and an estimate of its error, which tells when to stop.
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace raytracer {

// The next number of samples at which a pixel may stop: 1, 4, 8, 16 ... up to the limit.
inline int nextLevel(int samples, int limit) { return std::min(limit, samples == 1 ? 4 : 2 * samples); }

class PixelEstimate {
  public:
    // The largest error(contrast) of one sample: no pixel takes a second one for it.
    static constexpr double mostOfOneSample = 0.25;

    // Linear, unclamped.
    void add(const glm::dvec3& color) {
        const glm::dvec3 shown = glm::clamp(color, 0.0, 1.0);
        if (count_++ == 0) first_ = shown;
        sum_ += color;
        difference_ += shown - first_;
        squares_ += glm::dot(shown - first_, shown - first_);
    }

    glm::dvec3 color() const { return sum_ / static_cast<double>(count_); }
    int samples() const { return count_; }

    // A weighted estimate of the colour's error (1 is from black to white): while it is too large, the pixel
    // takes more samples. With n samples of standard deviation s, the error is about s / n^3/4, since they
    // are spread evenly (for edges; Mitchell 1996). But n samples that agree may still miss about 1/n of the
    // pixel, and that part may differ by as much as the neighbourhood does: `contrast` is that of the 3 x 3
    // centres around the pixel. The weight is (16 / n)^1/4 from the second sample on. It lets a pixel of many
    // samples keep more error, since there a further sample lowers the picture's squared error, e^2, by only
    // 1.5 e^2 / n.
    double error(double contrast) const {
        if (count_ == 1) return contrast * mostOfOneSample;
        const auto n = static_cast<double>(count_);
        return std::max(2 * deviation() / n, contrast / (2 * n * std::sqrt(std::sqrt(n))));
    }

  private:
    // The root of the mean of the channels' variances.
    double deviation() const {
        const auto n = static_cast<double>(count_);
        const double squares = squares_ - glm::dot(difference_, difference_) / n;
        return std::sqrt(std::max(0.0, squares) / (3 * std::max(1.0, n - 1)));
    }

    glm::dvec3 sum_{0}, first_{0}, difference_{0};  // difference_: from the first sample, as shown
    double squares_ = 0;
    int count_ = 0;
};

}  // namespace raytracer
