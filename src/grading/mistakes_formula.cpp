// Mistakes inside the light model: its sums are recomputed from the rays that `explain` records.
//
// This is a second light model and a second recursion, on purpose. The tracer knows nothing of mistakes: its
// recursion would need a switch for each of them. Here a mistake costs only sums, and other rays only if it
// turns a normal or needs other shadows. Programs that make the mistakes serve as tests (bench/mistakes.py).
#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "mistake.h"
#include "raytracer/scene/affine.h"

namespace raytracer {

namespace {

LightTerm recordedTerm(const LitPoint& point) {
    const RayExplanation& ray = *point.ray;
    const LightDescription& light = point.scene->lights[point.light];
    const MaterialDescription& material = materialOf(*point.scene, ray.shape);
    LightTerm term;
    term.ambient = ray.lights[point.light].ambient;
    term.K_D = ray.K_D;
    term.K_S = material.color_specular;
    term.color = light.color;
    term.shininess = material.shininess;
    term.N = ray.entering ? ray.normal : -ray.normal;
    term.L = glm::normalize(light.position - ray.position);
    term.V = -glm::normalize(ray.direction);
    term.S_L = ray.lights[point.light].S_L;
    return term;
}

// A starting point a little ahead of a surface, by a share of the coordinates, as in the plain tracer
// (test/tracer/plain_tracer.h).
glm::dvec3 ahead(const glm::dvec3& position, const glm::dvec3& cameFrom, const glm::dvec3& unit) {
    return position + 1e-9 * (glm::length(position) + glm::length(cameFrom)) * unit;
}

// The shapes that are hit on the way to the light, the nearest first, up to the first opaque one.
std::vector<std::size_t> shapesBefore(const LitPoint& point, const CastRay& cast) {
    constexpr std::size_t most = 16;  // panes of glass
    const glm::dvec3 light = point.scene->lights[point.light].position;
    const glm::dvec3 L = glm::normalize(light - point.ray->position);
    glm::dvec3 from = point.ray->position, before = point.ray->origin;
    std::vector<std::size_t> shapes;
    while (shapes.size() < most) {
        const RayExplanation hit = cast(ahead(from, before, L), L, 0);
        if (!hit.hit || glm::dot(light - hit.position, L) <= 0) break;
        shapes.push_back(hit.shape);
        if (!materialOf(*point.scene, hit.shape).refractive) break;
        before = std::exchange(from, hit.position);
    }
    return shapes;
}

glm::dvec3 shadowOf(const SceneDescription& scene, std::size_t shape) {
    const MaterialDescription& material = materialOf(scene, shape);
    return material.refractive ? material.color_refract : glm::dvec3(0);
}

// S_L where no shadow ray was cast, since the light is behind the surface.
glm::dvec3 shadowBehind(const LitPoint& point, const CastRay& cast) {
    const auto shapes = shapesBefore(point, cast);
    return shapes.empty() ? glm::dvec3(1) : shadowOf(*point.scene, shapes.front());
}

glm::dvec3 clamped(const glm::dvec3& color) { return glm::clamp(color, 0.0, 1.0); }

glm::dvec3 sumOf(const LitPoint& point, const CastRay& cast, LightTerm term) {
    const LightExplanation& recorded = point.ray->lights[point.light];
    const double N_L = glm::dot(term.N, term.L);
    glm::dvec3 diffuse(0), specular(0);
    if (N_L > 0 || term.shinesFromBehind) {
        const double V_R = term.halfVector ? glm::dot(term.N, glm::normalize(term.L + term.V))
                                           : glm::dot(term.V, 2 * N_L * term.N - term.L);
        diffuse = term.K_D * term.color * N_L;
        if (V_R > 0) specular = term.K_S * term.color * std::pow(V_R, term.shininess);
    }
    if (recorded.N_L <= 0 && diffuse + specular != glm::dvec3(0) && !term.allShadowed)
        term.S_L = shadowBehind(point, cast);
    diffuse *= term.S_L;
    specular *= term.S_L;
    if (term.ambientShadowed) term.ambient *= recorded.N_L > 0 ? term.S_L : glm::dvec3(0);
    if (term.clampsParts) return clamped(term.ambient) + clamped(diffuse) + clamped(specular);
    return term.ambient + diffuse + specular;
}

glm::dvec3 lightAnew(const SceneDescription& scene, const RayExplanation& ray, const Formula& formula,
                     const CastRay& cast) {
    glm::dvec3 color(0);
    for (std::size_t i = 0; i < ray.lights.size(); ++i) {
        const LitPoint point{&scene, &ray, i};
        LightTerm term = recordedTerm(point);
        for (const auto& change : formula.changes) change(point, cast, term);
        const glm::dvec3 sum = sumOf(point, cast, term);
        color += formula.clampsLights ? clamped(sum) : sum;
    }
    return color;
}

// The normal that the hit has if it is transformed by the matrix. The recorded one was transformed by the
// inverse transpose, which the transpose undoes.
glm::dvec3 normalByMatrix(const SceneDescription& scene, const RayExplanation& ray) {
    const glm::dmat3 transpose(worldFromObject(scene, scene.shapes[ray.shape]).linear);
    return glm::normalize(glm::transpose(transpose) * (transpose * ray.normal));
}

bool differs(const glm::dvec3& a, const glm::dvec3& b) {
    constexpr double rounding = 1e-9;  // in products of three matrices, with a wide margin
    return glm::dot(a - b, a - b) > rounding * rounding;
}

void takeNormalByMatrix(const LitPoint& point, const CastRay&, LightTerm& term) {
    const glm::dvec3 N = normalByMatrix(*point.scene, *point.ray);
    if (differs(N, point.ray->normal)) term.N = glm::dot(N, term.V) < 0 ? -N : N;
}

void takeExteriorNormal(const LitPoint& point, const CastRay&, LightTerm& term) {
    term.N = point.ray->normal;
}

void takeInteriorNormal(const LitPoint& point, const CastRay&, LightTerm& term) {
    term.N = -point.ray->normal;
}

bool isShadowedByGlass(const LitPoint& point) {
    const auto& by = point.ray->lights[point.light].shadowedBy;
    return by && materialOf(*point.scene, *by).refractive;
}

void makeGlassOpaque(const LitPoint& point, const CastRay&, LightTerm& term) {
    if (isShadowedByGlass(point)) term.S_L = glm::dvec3(0);
}

void makeGlassClear(const LitPoint& point, const CastRay& cast, LightTerm& term) {
    if (!isShadowedByGlass(point)) return;
    const auto shapes = shapesBefore(point, cast);
    term.S_L = glm::dvec3(shapes.empty() || materialOf(*point.scene, shapes.back()).refractive ? 1 : 0);
}

// Makes S_L the product over all hits, or over all shapes that are hit.
void multiplyShadows(const LitPoint& point, const CastRay& cast, LightTerm& term, bool isEachHit) {
    if (!isShadowedByGlass(point)) return;
    std::vector<std::size_t> shapes = shapesBefore(point, cast);
    std::ranges::sort(shapes);
    if (!isEachHit) shapes.erase(std::unique(shapes.begin(), shapes.end()), shapes.end());
    term.S_L = glm::dvec3(1);
    for (const std::size_t shape : shapes) term.S_L *= shadowOf(*point.scene, shape);
}

// The directions of the reflected and the refracted ray
// at another normal. Empty for total internal reflection.
glm::dvec3 reflectedAnew(const glm::dvec3& d, const glm::dvec3& N) { return d - 2 * glm::dot(d, N) * N; }

std::optional<glm::dvec3> refractedAnew(const glm::dvec3& d, const glm::dvec3& exterior, double index) {
    const bool entering = glm::dot(exterior, d) < 0;
    const glm::dvec3 N = entering ? exterior : -exterior;
    const double ratio = entering ? 1 / index : index, cosine = -glm::dot(d, N);
    const double squared = 1 - ratio * ratio * (1 - cosine * cosine);
    if (squared < 0) return std::nullopt;
    return ratio * d + (ratio * cosine - std::sqrt(squared)) * N;
}

// The rays that leave the hit if its normal is this one.
std::vector<RayExplanation> raysAnew(const SceneDescription& scene, const RayExplanation& ray,
                                     const glm::dvec3& normal, const CastRay& cast) {
    const MaterialDescription& material = materialOf(scene, ray.shape);
    const glm::dvec3 d = glm::normalize(ray.direction);
    std::vector<RayExplanation> rays;
    const auto add = [&](RayKind kind, const glm::dvec3& direction) {
        rays.push_back(cast(ahead(ray.position, ray.origin, direction), direction, ray.max_recursion - 1));
        rays.back().kind = kind;
    };
    if (material.reflective) add(RayKind::Reflection, reflectedAnew(d, normal));
    if (!material.refractive) return rays;
    const auto refracted = refractedAnew(d, normal, material.index_of_refraction);
    if (refracted) add(RayKind::Refraction, *refracted);
    return rays;
}

std::vector<RayExplanation> raysOf(const SceneDescription& scene, const RayExplanation& ray,
                                   const Formula& formula, const CastRay& cast) {
    if (!formula.normal || ray.max_recursion == 0) return ray.rays;
    const glm::dvec3 normal = formula.normal(scene, ray);
    return differs(normal, ray.normal) ? raysAnew(scene, ray, normal, cast) : ray.rays;
}

}  // namespace

std::optional<glm::dvec3> colorAnew(const SceneDescription& scene, const RayExplanation& ray,
                                    const Formula& formula, const CastRay& cast) {
    if (!ray.hit) return glm::dvec3(0);
    const MaterialDescription& material = materialOf(scene, ray.shape);
    if (formula.losesGlass && material.refractive && ray.max_recursion > 0) return std::nullopt;
    glm::dvec3 color = lightAnew(scene, ray, formula, cast);
    for (const RayExplanation& next : raysOf(scene, ray, formula, cast)) {
        const auto incoming = colorAnew(scene, next, formula, cast);
        if (!incoming) return std::nullopt;
        color +=
            (next.kind == RayKind::Reflection ? material.color_reflect : material.color_refract) * *incoming;
    }
    return formula.clampsRays ? clamped(color) : color;
}

void addFormulaMistakes(Mistakes& mistakes, const SceneDescription& scene) {
    const auto add = [&](const char* what, const char* hint, const char* kind,
                         std::function<void(Formula&)> formula) {
        mistakes.push_back({.what = what, .hint = hint, .kind = kind, .formula = std::move(formula)});
    };
    const auto change = [](auto rule) {
        return [rule](Formula& formula) { formula.changes.emplace_back(rule); };
    };
    add("whose normals go to the world by the matrix, not its inverse transpose",
        "Normals go by transpose(inverse(mat3(M))).", "normals", [](Formula& formula) {
            formula.changes.emplace_back(takeNormalByMatrix);
            formula.normal = normalByMatrix;
        });
    add("whose normals point inwards", "Is the normal turned to the side that the ray comes from?", "normals",
        [](Formula& formula) {
            formula.changes.emplace_back(takeInteriorNormal);
            formula.losesGlass = true;
        });
    add("whose normals are not turned to the ray where it comes from inside",
        "If dot(N, ray.direction) > 0, N is -N.", "normals", [](Formula& formula) {
            formula.changes.emplace_back(takeExteriorNormal);
            formula.losesGlass = true;
        });
    add("in which all that could be lit is in shadow",
        "Does a shadow ray start a little ahead of the surface, and do only hits before the light count?",
        "shadows", change([](const LitPoint&, const CastRay&, LightTerm& term) {
            term.S_L = glm::dvec3(0);
            term.allShadowed = true;
        }));
    add("whose shadows take the ambient light away too", "S_L multiplies diffuse and specular light only.",
        "shadows",
        change([](const LitPoint&, const CastRay&, LightTerm& term) { term.ambientShadowed = true; }));
    add("in which light from behind a surface counts, too", "Light with N.L below 0 adds nothing.", "",
        change([](const LitPoint&, const CastRay&, LightTerm& term) { term.shinesFromBehind = true; }));
    mistakes.back().alone = true;  // saves time: pairs of recomputed sums take the most
    add("with Blinn's half vector for specular light",
        "The specular term is (V.R)^n, with R = 2 (N.L) N - L.", "specular",
        change([](const LitPoint&, const CastRay&, LightTerm& term) { term.halfVector = true; }));
    const char* const late = "Only the pixel's colour is clamped, at the very end.";
    add("with each term clamped by itself", late, "clamp",
        change([](const LitPoint&, const CastRay&, LightTerm& term) { term.clampsParts = true; }));
    add("with each light's sum clamped by itself", late, "clamp",
        [](Formula& formula) { formula.clampsLights = true; });
    add("with the colour of each reflected and refracted ray clamped", late, "clamp",
        [](Formula& formula) { formula.clampsRays = true; });
    if (std::ranges::none_of(scene.materials, &MaterialDescription::refractive)) return;
    const char* const closest =
        "The closest hit before the light alone counts: a refractive one gives color_refract.";
    add("whose glass casts opaque shadows", closest, "shadows", change(makeGlassOpaque));
    add("whose glass casts no shadow", closest, "shadows", change(makeGlassClear));
    for (const bool isEachHit : {false, true})
        add("whose shadows are the product over all hits", closest, "shadows",
            change([=](const LitPoint& point, const CastRay& cast, LightTerm& term) {
                multiplyShadows(point, cast, term, isEachHit);
            }));
}

Mistakes knownMistakes(const SceneDescription& scene, const RenderOptions& options, const Terms& terms) {
    Mistakes mistakes;
    addTransformMistakes(mistakes);
    addCameraMistakes(mistakes, scene, options);
    addByteMistakes(mistakes);
    addStageMistakes(mistakes, scene, options, terms);
    if (options.pass != Pass::Color) return mistakes;
    addSceneMistakes(mistakes, scene, options);
    addFormulaMistakes(mistakes, scene);
    return mistakes;
}

}  // namespace raytracer
