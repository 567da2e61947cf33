// Why a pixel has its colour: the tree of rays behind it, in the symbols of the assignment and in the file's
// own units. All colours are clamped so that products of four of them are finite.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace raytracer {

enum class RayKind { Primary, Reflection, Refraction };

// One light's term: K_A I_AL + [K_D I_L (N.L) + K_S I_L (V.R)^n] S_L.
struct LightExplanation {
    glm::dvec3 ambient{0};       // K_A I_AL
    double N_L = 0, V_R = 0;     // 0 where the light is behind the surface, or mirrored away from the viewer
    glm::dvec3 diffuse{0};       // K_D I_L (N.L), before the shadow
    glm::dvec3 specular{0};      // K_S I_L (V.R)^n, before the shadow
    bool shadowRayCast = false;  // there was light to take away
    std::optional<std::size_t> shadowedBy;  // the shape that it hit first
    glm::dvec3 S_L{1};
    glm::dvec3 sum{0};  // the whole term
};

// Why a reflective or refractive surface casts no ray.
enum class TerminationReason { None, MaxRecursion, Black, Cutoff, TotalInternalReflection };

struct RayExplanation {
    RayKind kind = RayKind::Primary;
    glm::dvec3 origin{0}, direction{0};
    glm::dvec3 weight{1};  // what its colour is multiplied by on the way to the pixel
    int max_recursion = 0;

    bool hit = false;  // what follows describes the hit
    std::size_t shape = 0;
    std::size_t primitive = 0;  // face in the order of the assignment, or triangle
    bool entering = true;       // the ray meets the exterior side of the normal
    double t = 0;
    glm::dvec3 position{0}, normal{0};  // the normal as the shape has it, towards its exterior
    std::optional<glm::dvec2> texCoord;
    glm::dvec3 K_D{0};  // color_diffuse times the texture's colour

    std::vector<LightExplanation> lights;
    std::vector<RayExplanation> rays;  // reflection, then refraction, where cast
    TerminationReason reflection = TerminationReason::None, refraction = TerminationReason::None;
    glm::dvec3 color{0};    // of the whole ray
    glm::dvec3 brought{0};  // K_R I_R or K_T I_T: its term in the colour of the ray that it comes from
};

}  // namespace raytracer
