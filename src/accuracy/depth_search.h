// Which depths --target-error considers, by their truncation error.
//
// The truncation error may lie in one pixel of a thousand (in mirror_corridor at depth 12, an RMSE of 0.002),
// and one sample a pixel measures it: so many pixels are measured if the picture is expensive.
#pragma once

#include <optional>

#include "depth_pilot.h"

namespace raytracer {

class DepthSearch {
  public:
    DepthSearch(const Renderer& renderer, const RenderOptions& options, double target);

    // Measures again, with as many pixels as a small part of the picture's rays allows. Returns false if
    // these are not many more than before.
    bool widen(double raysOfPixel);

    // Adds a depth half way between a setting's depth and the next one that is clearly cheaper. Returns false
    // if there is none.
    bool halve(const Setting& setting);

    // The front, and depths added to it.
    const std::vector<DepthChoice>& choices() const { return choices_; }
    const DepthChoice& fine() const { return fine(enough); }  // the cheapest with a negligible error
    const DepthChoice& deeper(double part);  // the cheapest with an error of at most this part of the target
    const DepthChoice& coarsest() const;     // the cheapest with an error below the target

    DepthChoice of(const Setting& setting) { return pilot_->measured(setting.max_recursion, setting.cutoff); }
    // RMSE between their pictures.
    double distance(const DepthChoice& a, const DepthChoice& b) { return pilot_->distance(a, b); }
    double raysSpent() const { return spent_; }

    static constexpr double enough = 0.2;  // a truncation error of this part of the target is negligible

  private:
    void measure(double pixels);
    std::vector<DepthChoice> front(double part);  // up to an error of at most this part of the target
    const DepthChoice& fine(double part) const;
    bool has(int max_recursion, double cutoff) const;

    const Renderer& renderer_;
    const RenderOptions& options_;
    double target_;
    Setting deepest_;
    std::optional<DepthPilot> pilot_;
    std::vector<DepthChoice> choices_;
    double spent_ = 0;  // rays
};

}  // namespace raytracer
