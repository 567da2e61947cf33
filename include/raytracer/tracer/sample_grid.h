// The n x n samples of a pixel. The corners are taken first; where they agree to within `adaptive`, they
// stand for all.
#pragma once

#include <algorithm>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace raytracer {

struct SampleGrid {
    int n;

    int count() const { return n * n; }
    int cornerCount() const { return n == 1 ? 1 : 4; }

    // Calls take(i, j) for each corner, in reading order.
    template <class Take>
    void forEachCorner(Take take) const {
        const int step = std::max(1, n - 1);
        for (int j = 0; j < n; j += step)
            for (int i = 0; i < n; i += step) take(i, j);
    }

    // Calls take(i, j) for each of the others, in reading order.
    template <class Take>
    void forEachOther(Take take) const {
        const auto isOuter = [&](int k) { return k == 0 || k == n - 1; };
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                if (!(isOuter(i) && isOuter(j))) take(i, j);
    }

    // How far sample (i, j) lies into its pixel, in pixels: to the right for i, down for j.
    template <class Number>
    Number offset(int i) const {
        return (static_cast<Number>(i) + Number(0.5)) * (1 / static_cast<Number>(n));
    }
};

// How far colours are apart, as a picture shows them: what `adaptive` is compared with.
template <class Number>
class ColorSpread {
  public:
    using Color = glm::vec<3, Number, glm::defaultp>;

    void add(const Color& color) {
        const Color shown = glm::clamp(color, Number(0), Number(1));
        low_ = glm::min(low_, shown);
        high_ = glm::max(high_, shown);
    }

    // Of the channel in which it is largest. At least one colour was added.
    Number largest() const {
        const Color spread = high_ - low_;
        return std::max({spread.x, spread.y, spread.z});
    }

  private:
    Color low_{1}, high_{0};
};

}  // namespace raytracer
