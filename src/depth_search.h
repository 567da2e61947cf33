// How deep rays must go for an error: what --target-error knows of depths.
//
// What rays leave out that are not followed may sit in one pixel of a thousand (of mirror_corridor at 12 deep, an RMSE of 0.002)
// and costs no more to look at than one sample a pixel: so a dear picture's depth is judged by many pixels.
#pragma once

#include "raytracer/pilot.h"

namespace raytracer {

class DepthSearch {
  public:
    DepthSearch(const Renderer& renderer, const RenderOptions& options, double target);

    // Looks again, by as many pixels as a small part of the picture's rays (so many for each pixel) pays for, and deeper where
    // that shows more than was seen. False if those would not be many more.
    bool widen(double raysOfPixel);

    // Puts one half way between a setting's depth and the next cheaper one. False if there is none, or hardly any difference.
    bool halve(const Setting& setting);

    // An infinite error: too shallow, not looked at again.
    const std::vector<DepthChoice>& choices() const { return choices_; }
    const DepthChoice& of(const Setting& setting) const;
    const DepthChoice& fine() const { return fine(enough); }     // the cheapest that seems deep enough not to matter
    const DepthChoice& deeper(double part);                      // the cheapest that leaves so much of the target; sought, if need be
    const DepthChoice& coarsest() const;                         // whose error is below the target
    double distance(const DepthChoice& a, const DepthChoice& b);  // RMSE between them
    double raysSpent() const { return spent_ + pilot_->raysSpent(); }

    static constexpr double enough = 0.2;  // of the target: a depth that costs no more than this of it is deep enough

  private:
    const DepthChoice& fine(double part) const;
    void goDeeper(double part);  // until one leaves no more than that of the target
    DepthChoice add(int depth, double cutoff);
    double measured(int depth, double cutoff);
    Setting setting(int depth, double cutoff) const;

    const Renderer& renderer_;
    const RenderOptions& options_;
    double target_;
    Setting deepest_;
    std::unique_ptr<Pilot> pilot_;
    std::vector<DepthChoice> choices_;
    double spent_ = 0;  // rays, by pilots that are gone
};

}  // namespace raytracer
