// Real is long double here (CMakeLists.txt): products of up to four numbers of the file neither overflow nor
// underflow, whatever the unit of length.
#include "raytracer/explain/scene_advice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "advice_lines.h"
#include "raytracer/geometry/shapes.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

using Vec = Vec3;
using Type = ShapeType;

// If a unit vector is written with three decimals, its length has an error of at most sqrt(3) * 0.0005. The
// cosine between two such vectors has an error of at most twice that.
constexpr Real lengthTolerance = 1e-3L, cosineTolerance = 2e-3L;

// Relative to the numbers that are added: far above the rounding errors, far below what is visible.
constexpr Real margin = 1e-9L;

std::string number(Real value) { return formatted("%.4Lg", value); }

// A bounding plane of the view: points p of the view, relative to the eye, have normal . p >= least.
struct Bound {
    Vec normal;
    Real least;
    const char* beyond;  // where a shape on the other side is, in words
};

// The region that the camera's rays may reach: the points p + s d, s >= 0, relative to the eye, for all p in
// the convex hull of `starts` and all d in that of `directions`. It is convex.
struct View {
    Vec eye;
    std::array<Vec, 4> starts, directions;
    std::array<Bound, 5> bounds;
};

// The plane through the film's edge at `edge` along `axis`, parallel to `other`.
Bound sideOf(bool perspective, const Vec& axis, const Vec& other, const Vec& forward, Real edge,
             Real opposite, const char* beyond) {
    Vec normal = glm::cross(other, perspective ? edge * axis + forward : forward);
    if (glm::dot(normal, axis) * (opposite - edge) < 0) normal = -normal;
    return {normal, perspective ? 0 : glm::dot(normal, edge * axis), beyond};
}

View viewOf(const CameraDescription& camera) {
    const bool perspective = camera.type == CameraDescription::Type::Perspective;
    const Vec v = camera.up, look = camera.look, u = glm::cross(v, -look);
    const Vec forward = perspective ? static_cast<Real>(camera.focal_length) * look : look;
    const Real left = camera.film_left, right = camera.film_right, bottom = camera.film_bottom,
               top = camera.film_top;
    View view{camera.eye, {}, {}, {}};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec corner = (i % 2 ? right : left) * u + (i / 2 ? top : bottom) * v;
        view.starts[i] = perspective ? Vec(0) : corner;
        view.directions[i] = perspective ? corner + forward : forward;
    }
    Vec ahead = glm::cross(u, v);  // perpendicular to the film
    if (glm::dot(ahead, look) < 0) ahead = -ahead;
    view.bounds = {Bound{ahead, 0, "behind the camera"},
                   sideOf(perspective, u, v, forward, left, right, "to the left of the view"),
                   sideOf(perspective, u, v, forward, right, left, "to the right of the view"),
                   sideOf(perspective, v, u, forward, bottom, top, "below the view"),
                   sideOf(perspective, v, u, forward, top, bottom, "above the view")};
    return view;
}

// A shape in world space, relative to the eye.
struct PlacedShape {
    const ShapeDescription* shape;
    Affine affine;
    Vec center;      // object space's origin
    Real magnitude;  // the largest coordinate that `center` was computed from
};

Real largest(const Vec& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

PlacedShape placed(const SceneDescription& scene, const ShapeDescription& shape) {
    const Affine affine = worldFromObject(scene, shape);
    const Vec eye = scene.camera.eye;
    return {&shape, affine, affine.translation - eye, std::max(largest(affine.translation), largest(eye))};
}

const char* whereBeyond(const PlacedShape& placed, const View& view) {
    for (const Bound& bound : view.bounds) {
        const Vec& n = bound.normal;
        const Real radius = support(placed.shape->type, placed.shape->mesh.get(), placed.affine.linear * n);
        const Real error =
            margin * (glm::length(n) * placed.magnitude + std::abs(radius) + std::abs(bound.least));
        if (glm::dot(n, placed.center) + radius < bound.least - error) return bound.beyond;
    }
    return nullptr;
}

// Whether all rays of the view start on one side of the plane and none approaches it.
bool isBehind(const PlacedShape& plane, const View& view) {
    const Vec normal = (*inverseLinear(plane.affine))[2];
    Real away = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Real height = glm::dot(normal, view.starts[i] - plane.center),
                   climb = glm::dot(normal, view.directions[i]);
        const Real error = margin * glm::length(normal) * (largest(view.starts[i]) + plane.magnitude);
        if (std::abs(height) <= error || height * climb < 0 || height * away < 0) return false;
        if (std::abs(climb) > margin * glm::length(normal) * largest(view.directions[i])) away = climb;
    }
    return away != 0;
}

// The place of the shape, in words, if no ray of the view hits it; null if one may.
const char* whereUnseen(const PlacedShape& placed, const View& view) {
    if (placed.shape->type != Type::Plane) return whereBeyond(placed, view);
    return isBehind(placed, view) ? "behind the camera" : nullptr;
}

// Whether this material may show shapes that are outside of the view.
bool showsOthers(const MaterialDescription& material) { return material.reflective || material.refractive; }

bool anyShowsOthers(const SceneDescription& scene, const View& view) {
    return std::ranges::any_of(scene.shapes, [&](const ShapeDescription& shape) {
        return showsOthers(scene.materials[shape.material]) && !whereUnseen(placed(scene, shape), view);
    });
}

// Whether the point, in object space, is inside the solid
// by more than rounding errors. False for other shapes.
bool isDeepInside(Type type, const Vec& p) {
    return visit(type, [&](auto kind) {
        if constexpr (requires { kind.offsets(p); }) return std::ranges::max(kind.offsets(p)) < -margin;
        else return false;
    });
}

// Whether the point, relative to the eye, is inside the solid. The solid's box in world space is tested
// first: most points are outside, and that test needs no inverse matrix.
bool isInside(const PlacedShape& solid, const Vec& point) {
    const Vec from = point - solid.center;
    for (int i = 0; i < 3; ++i) {
        const Vec row = glm::abs(solid.affine.linear[i]);
        if (std::abs(from[i]) >= row.x + row.y + row.z) return false;
    }
    return isDeepInside(solid.shape->type, from * *inverseLinear(solid.affine));
}

void adviseOnCamera(const CameraDescription& camera, AdviceLines& lines) {
    const Vec look = camera.look, up = camera.up;
    const Real lookLength = glm::length(look), upLength = glm::length(up),
               cosine = glm::dot(look, up) / lookLength / upLength;
    if (std::abs(lookLength - 1) <= lengthTolerance && std::abs(upLength - 1) <= lengthTolerance &&
        std::abs(cosine) <= cosineTolerance)
        return;
    const Real degrees =
        std::atan2(glm::length(glm::cross(look, up)), glm::dot(look, up)) * 180 / std::numbers::pi_v<Real>;
    lines.add("/camera: look and up distort: lengths " + number(lookLength) + ", " + number(upLength) +
              " at " + number(degrees) + "\u00b0, not 1, 1 at 90\u00b0");
}

std::string pointer(const char* list, std::size_t index) { return list + std::to_string(index); }

bool isOpaqueAround(const SceneDescription& scene, const PlacedShape& solid, const Vec& point) {
    return !scene.materials[solid.shape->material].refractive && isInside(solid, point);
}

bool isBlack(const LightDescription& light) { return light.color == glm::dvec3(0); }

// Whether the light is inside the solid, and the solid is opaque and does not contain the camera too.
bool isHidden(const LightDescription& light, const PlacedShape& solid, const SceneDescription& scene,
              const View& view) {
    return !isBlack(light) && isOpaqueAround(scene, solid, Vec(light.position) - view.eye) &&
           std::ranges::none_of(view.starts, [&](const Vec& start) { return isInside(solid, start); });
}

void adviseOnLights(const SceneDescription& scene, const PlacedShape& solid, std::size_t index,
                    const View& view, AdviceLines& lines) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (isHidden(scene.lights[i], solid, scene, view))
            lines.add(pointer("/lights/", i) + ": hidden inside of " + pointer("/shapes/", index) +
                      ", an opaque " + typeName(solid.shape->type) + ": move the light out");
}

}  // namespace

std::vector<std::string> sceneAdvice(const SceneDescription& scene) {
    AdviceLines lines;
    adviseOnCamera(scene.camera, lines);
    const View view = viewOf(scene.camera);
    const bool mirrored = anyShowsOthers(scene, view);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const PlacedShape shape = placed(scene, scene.shapes[i]);
        const char* where = mirrored ? nullptr : whereUnseen(shape, view);
        if (hasNoArea(scene.shapes[i]))
            lines.add(pointer("/shapes/", i) +
                      "/path: the mesh has no area: move corners of its triangles off their line");
        else if (where)
            lines.add(pointer("/shapes/", i) + ": the " + typeName(shape.shape->type) + " is " + where +
                      ", so unseen but for its shadow: move it");
        adviseOnLights(scene, shape, i, view, lines);
    }
    return lines.take();
}

bool mayShowShapes(const SceneDescription& scene) {
    const View view = viewOf(scene.camera);
    return std::ranges::any_of(scene.shapes, [&](const ShapeDescription& shape) {
        return !whereUnseen(placed(scene, shape), view);
    });
}

bool hasNoArea(const ShapeDescription& shape) {
    if (!shape.mesh) return false;
    const MeshData& mesh = *shape.mesh;
    for (std::size_t i = 0; i < mesh.positionIndex.size(); i += 3) {
        const auto corner = [&](std::size_t j) { return Vec(mesh.positions[mesh.positionIndex[i + j]]); };
        const Vec a = corner(0), b = corner(1) - a, c = corner(2) - a;
        // Each coordinate is as far off as its number is rounded.
        const Vec error =
            2 * writtenRoundoff * glm::max(glm::abs(a), glm::max(glm::abs(corner(1)), glm::abs(corner(2))));
        const Vec sizes = glm::abs(b) + glm::abs(c), area = glm::abs(glm::cross(b, c));
        for (int x = 0; x < 3; ++x) {
            const int y = (x + 1) % 3, z = (x + 2) % 3;
            if (area[x] > error[y] * sizes[z] + error[z] * sizes[y]) return false;
        }
    }
    return true;
}

std::optional<std::size_t> darkShapeAroundCamera(const SceneDescription& scene) {
    const View view = viewOf(scene.camera);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const PlacedShape shape = placed(scene, scene.shapes[i]);
        const auto isAround = [&](const Vec& point) { return isOpaqueAround(scene, shape, point); };
        const auto shines = [&](const LightDescription& light) {
            return !isBlack(light) && isAround(Vec(light.position) - view.eye);
        };
        if (std::ranges::all_of(view.starts, isAround) && std::ranges::none_of(scene.lights, shines))
            return i;
    }
    return std::nullopt;
}

bool areLightsHidden(const SceneDescription& scene) {
    const View view = viewOf(scene.camera);
    return std::ranges::all_of(scene.lights, [&](const LightDescription& light) {
        return isBlack(light) || std::ranges::any_of(scene.shapes, [&](const ShapeDescription& shape) {
                   return isHidden(light, placed(scene, shape), scene, view);
               });
    });
}

}  // namespace raytracer
