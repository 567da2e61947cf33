// The rays behind some pixels' centres, kept with what each brings: what the pixels would be, had they been
// followed less deep.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace raytracer {

struct FollowedRay {
    glm::dvec3 light{0};        // what the lights alone give it, as it reaches the pixel
    glm::dvec3 weight{1};       // what its colour is multiplied by on its way to the pixel
    std::uint16_t depth = 0;    // reflections and refractions on the way to it
    std::uint16_t shadows = 0;  // shadow rays from where it hits
};

// As they are followed with one max_recursion and cutoff.
struct FollowedRays {
    std::vector<FollowedRay> rays;  // pixel by pixel, each one's own first
    std::vector<std::size_t> ends;  // of each pixel's
    std::vector<glm::dvec3>
        brightest;  // the most that a ray's colour can be, by the max_recursion that it has left

    std::size_t pixelCount() const { return ends.size(); }
    std::span<const FollowedRay> of(std::size_t pixel) const;
};

// The least max_recursion that a ray is followed with at a cutoff; neverFollowed where none is enough.
int followedFrom(const FollowedRays& followed, const FollowedRay& ray, double cutoff);
inline constexpr int neverFollowed = std::numeric_limits<int>::max();

// A pixel's colour (linear, unclamped), and rays of every kind.
struct PixelAndRays {
    glm::dvec3 color{0};
    double rays = 0;
};

// Had they been followed with no more than this max_recursion, and no less than this cutoff: what a render
// has, but for rounding.
PixelAndRays shallower(const FollowedRays& followed, std::size_t pixel, int max_recursion, double cutoff);

}  // namespace raytracer
