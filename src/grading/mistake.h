// A mistake that programs are known to make, as a recipe for the picture that it leads to.
//
// The tracer knows nothing of mistakes. What it computes is changed before it (the scene's description, the
// options), behind it (colours, bytes), or beside it: the sums of the light model, made anew from the ray
// tree that explain records.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raytracer/scene/scene_description.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

// One light's term at a hit, with what it is made of; world space.
struct LightTerm {
    glm::dvec3 ambient{0};                // K_A I_AL
    glm::dvec3 K_D{0}, K_S{0}, color{0};  // color: I_L
    double shininess = 0;
    glm::dvec3 N{0}, L{0}, V{0};  // of unit length
    glm::dvec3 S_L{1};
    bool allShadowed = false, ambientShadowed = false, halfVector = false, clampsParts = false;
    bool shinesFromBehind = false;  // N.L below 0 counts
};

// Where a light's term is summed.
struct LitPoint {
    const SceneDescription* scene;
    const RayExplanation* ray;  // which hit something
    std::size_t light;
};

// Another ray of the same scene, from `origin`, which lies on no surface.
using CastRay =
    std::function<RayExplanation(const glm::dvec3& origin, const glm::dvec3& direction, int max_recursion)>;

// How the sums are made anew, with other rays where the mistake turns them.
struct Formula {
    std::vector<std::function<void(const LitPoint&, const CastRay&, LightTerm&)>> changes;
    bool clampsLights = false, clampsRays = false;
    std::function<glm::dvec3(const SceneDescription&, const RayExplanation&)> normal;  // to the exterior
    bool losesGlass = false;  // what becomes of refracted rays is not known
};

// The colour of the ray's tree by this formula; nothing where that is not known.
std::optional<glm::dvec3> colorAnew(const SceneDescription& scene, const RayExplanation& ray,
                                    const Formula& formula, const CastRay& cast);

using Rgb = std::array<std::uint8_t, 3>;

// How a channel's value becomes a byte.
using ToByte = std::uint8_t (*)(double channel);

using Edit = std::function<void(SceneDescription&, RenderOptions&)>;

struct Mistake {
    std::string what, hint;  // as in NamedMistake
    std::string kind = {};   // no program makes two mistakes of one kind; empty: of no kind
    Edit edit = {};
    std::function<void(Formula&)> formula = {};
    std::function<glm::dvec3(const glm::dvec3&)> color = {};
    ToByte toByte = nullptr;
    bool alone = false;                    // not looked for together with another
    bool moves = false;                    // shapes: onto others, or onto the eye
    std::vector<glm::dvec2> samples = {};  // whose mean a pixel is: how far into it; empty: its centre
};

struct Mistakes : std::vector<Mistake> {
    void add(const std::string& what, const std::string& hint, const std::string& kind, const Edit& edit) {
        push_back({what, hint, kind, edit});
    }
};

// Those that could be made with this scene, where the right picture shows these terms of it.
Mistakes knownMistakes(const SceneDescription& scene, const RenderOptions& options, const Terms& terms);

void addSceneMistakes(Mistakes& mistakes, const SceneDescription& scene, const RenderOptions& options);
void addTransformMistakes(Mistakes& mistakes);
void addCameraMistakes(Mistakes& mistakes, const SceneDescription& scene, const RenderOptions& options);
void addFormulaMistakes(Mistakes& mistakes, const SceneDescription& scene);
void addByteMistakes(Mistakes& mistakes);
void addStageMistakes(Mistakes& mistakes, const SceneDescription& whole, const RenderOptions& options,
                      const Terms& terms);

}  // namespace raytracer
