// A mistake that programs are known to make, as a recipe for the picture that it leads to.
//
// The tracer knows nothing of mistakes. A recipe changes its input (the scene's
// description, the options) or its output (colours, bytes), or recomputes the
// sums of the light model from the ray tree that `explain` records.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

// One light's term at a hit, with its factors, in world space.
struct LightTerm {
    glm::dvec3 ambient{0};                // K_A I_AL
    glm::dvec3 K_D{0}, K_S{0}, color{0};  // color: I_L
    double shininess = 0;
    glm::dvec3 N{0}, L{0}, V{0};  // of unit length
    glm::dvec3 S_L{1};
    bool allShadowed = false, ambientShadowed = false, halfVector = false, clampsParts = false;
    bool shinesFromBehind = false;  // whether a negative N.L counts too
};

// The hit and the light of a term.
struct LitPoint {
    const SceneDescription* scene;
    const RayExplanation* ray;  // it has hit something
    std::size_t light;
};

// Casts another ray in the same scene. `origin` must not lie on a surface.
using CastRay =
    std::function<RayExplanation(const glm::dvec3& origin, const glm::dvec3& direction, int max_recursion)>;

// How the sums are recomputed, with other rays if the mistake turns them.
struct Formula {
    std::vector<std::function<void(const LitPoint&, const CastRay&, LightTerm&)>> changes;
    bool clampsLights = false, clampsRays = false;
    std::function<glm::dvec3(const SceneDescription&, const RayExplanation&)> normal;  // to the exterior
    bool losesGlass = false;  // whether refracted rays cannot be predicted
};

// The colour of the ray's tree by this formula; empty if it cannot be predicted.
std::optional<glm::dvec3> colorAnew(const SceneDescription& scene, const RayExplanation& ray,
                                    const Formula& formula, const CastRay& cast);

using Rgb = std::array<std::uint8_t, 3>;

// Converts a channel's value to a byte.
using ToByte = std::uint8_t (*)(double channel);

using Edit = std::function<void(SceneDescription&, RenderOptions&)>;

// The largest max_recursion that is tried. With more, few scenes look different.
inline constexpr int mostRecursionTried = 8;

struct Mistake {
    std::string what, hint;  // as in NamedMistake
    std::string kind = {};   // no program makes two mistakes of one kind; empty: none
    Edit edit = {};
    std::function<void(Formula&)> formula = {};
    std::function<glm::dvec3(const glm::dvec3&)> color = {};
    ToByte toByte = nullptr;
    bool alone = false;                    // whether it is not looked for together with another
    bool moves = false;                    // whether it moves shapes, perhaps onto others or the eye
    std::vector<glm::dvec2> samples = {};  // places in the pixel to average, 0 to 1; empty: its centre
};

struct Mistakes : std::vector<Mistake> {
    void add(const std::string& what, const std::string& hint, const std::string& kind, const Edit& edit) {
        push_back({what, hint, kind, edit});
    }
};

// The mistakes that could be made with this scene, if the right picture shows these terms of it.
Mistakes knownMistakes(const SceneDescription& scene, const RenderOptions& options, const Terms& terms);

void addSceneMistakes(Mistakes& mistakes, const SceneDescription& scene, const RenderOptions& options);
void addTransformMistakes(Mistakes& mistakes);
void addCameraMistakes(Mistakes& mistakes, const SceneDescription& scene, const RenderOptions& options);
void addFormulaMistakes(Mistakes& mistakes, const SceneDescription& scene);
void addByteMistakes(Mistakes& mistakes);
void addStageMistakes(Mistakes& mistakes, const SceneDescription& whole, const RenderOptions& options,
                      const Terms& terms);

}  // namespace raytracer
