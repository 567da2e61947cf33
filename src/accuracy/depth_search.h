// How deep rays must go for an error: what --target-error knows of depths.
//
// What rays leave out that are not followed may sit in one pixel of a thousand (of mirror_corridor at 12
// deep, an RMSE of 0.002) and costs no more to look at than one sample a pixel: so a dear picture's depth is
// judged by many pixels.
#pragma once

#include <optional>

#include "depth_pilot.h"

namespace raytracer {

class DepthSearch {
  public:
    DepthSearch(const Renderer& renderer, const RenderOptions& options, double target);

    // Looks again, by as many pixels as a small part of the picture's rays (so many for each pixel) pays for.
    // False if those would not be many more.
    bool widen(double raysOfPixel);

    // Puts one half way between a setting's depth and the next one that is clearly cheaper. False if there is
    // none.
    bool halve(const Setting& setting);

    // Those worth having.
    const std::vector<DepthChoice>& choices() const { return choices_; }
    const DepthChoice& fine() const {
        return fine(enough);
    }                                        // the cheapest that seems deep enough not to matter
    const DepthChoice& deeper(double part);  // the cheapest that leaves so much of the target
    const DepthChoice& coarsest() const;     // whose error is below the target

    DepthChoice of(const Setting& setting) { return pilot_->measured(setting.max_recursion, setting.cutoff); }
    double distance(const DepthChoice& a, const DepthChoice& b) {
        return pilot_->distance(a, b);
    }  // RMSE between them
    double raysSpent() const { return spent_; }

    static constexpr double enough =
        0.2;  // of the target: a depth that costs no more than this of it is deep enough

  private:
    void look(double pixels);
    std::vector<DepthChoice> front(double part);  // as deep as leaves no more than so much of the target
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
