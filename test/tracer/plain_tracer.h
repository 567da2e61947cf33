// The light model (README.md) once more, as plainly as it can be written: every ray tries every triangle of
// every shape, in double, with no tree, no packets and no error bounds. It is there to disagree with the
// tracer, so it shares nothing with it: only the description of the scene and its textures.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "raytracer/pictures/image.h"
#include "raytracer/pictures/texture.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/scene/scene_description.h"

namespace raytracer::plain {

using glm::dmat3, glm::dmat4, glm::dvec2, glm::dvec3, glm::dvec4;

struct Ray {
    dvec3 origin, direction;  // not normalised
    dvec3 at(double t) const { return origin + t * direction; }
};

struct Hit {
    double t = std::numeric_limits<double>::infinity();
    dvec3 normal{0};  // to the exterior; of unit length once it is in the world
    dvec2 texCoord{0};
    const MaterialDescription* material = nullptr;

    // Equal distances leave what came first. A NaN is never closer.
    bool closer(double candidate) const { return candidate >= 0 && candidate < t; }
};

// The solutions of a t^2 + b t + c = 0, NaN or infinite where there are none. Adds b to the root of its own
// sign: nothing cancels.
inline std::array<double, 2> roots(double a, double b, double c) {
    const double q = -(b + std::copysign(std::sqrt(b * b - 4 * a * c), b)) / 2;
    return {q / a, c / q};
}

// How far round the z axis, from 0 to 1.
inline double around(const dvec3& p) {
    const double turns = std::atan2(p.y, p.x) / glm::two_pi<double>();
    return turns < 0 ? turns + 1 : turns;
}

inline void meetSphere(const Ray& ray, Hit& hit) {
    const dvec3 &o = ray.origin, &d = ray.direction;
    for (const double t : roots(dot(d, d), 2 * dot(o, d), dot(o, o) - 1)) {
        const dvec3 p = ray.at(t);
        const double fromPole = std::acos(std::clamp(p.z, -1.0, 1.0));
        if (hit.closer(t)) hit = {t, p, {around(p), 1 - fromPole / glm::pi<double>()}};
    }
}

inline void meetPlane(const Ray& ray, Hit& hit) {
    const double t = -ray.origin.z / ray.direction.z;
    const dvec2 uv = (dvec2(ray.at(t)) + 1.0) / 2.0;
    if (hit.closer(t)) hit = {t, {0, 0, 1}, uv - floor(uv)};
}

inline void meetCap(const Ray& ray, double z, double normal, Hit& hit) {
    const double t = (z - ray.origin.z) / ray.direction.z;
    const dvec2 p(ray.at(t));
    if (hit.closer(t) && dot(p, p) < 1) hit = {t, {0, 0, normal}, (p + 1.0) / 2.0};
}

inline void meetCylinder(const Ray& ray, Hit& hit) {
    const dvec2 o(ray.origin), d(ray.direction);
    for (const double t : roots(dot(d, d), 2 * dot(o, d), dot(o, o) - 1)) {
        const dvec3 p = ray.at(t);
        if (hit.closer(t) && 0 < p.z && p.z < 1) hit = {t, {p.x, p.y, 0}, {around(p), p.z}};
    }
    meetCap(ray, 1, 1, hit);
    meetCap(ray, 0, -1, hit);
}

// x^2 + y^2 - (1 - z)^2 = 0, with the height measured down from the apex.
inline void meetCone(const Ray& ray, Hit& hit) {
    const dvec3 o(ray.origin.x, ray.origin.y, 1 - ray.origin.z);
    const dvec3 d(ray.direction.x, ray.direction.y, -ray.direction.z), minus(1, 1, -1);
    for (const double t : roots(dot(minus * d, d), 2 * dot(minus * o, d), dot(minus * o, o))) {
        const dvec3 p = ray.at(t);
        if (hit.closer(t) && 0 < p.z && p.z <= 1) hit = {t, {p.x, p.y, 1 - p.z}, {around(p), p.z}};
    }
    meetCap(ray, 0, -1, hit);
}

inline void meetCube(const Ray& ray, Hit& hit) {
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            const double t = (side - ray.origin[axis]) / ray.direction[axis];
            const dvec3 p = ray.at(t);
            const dvec2 across(axis == 0 ? p.y : p.x, axis == 2 ? p.y : p.z);
            dvec3 normal(0);
            normal[axis] = side;
            if (hit.closer(t) && std::max(std::abs(across.x), std::abs(across.y)) <= 1)
                hit = {t, normal, (across + 1.0) / 2.0};
        }
}

// Beyond 0 and 1 the image repeats.
inline dvec2 repeated(const dvec2& uv) {
    const auto beyond = [](double u) { return u < 0 || u > 1; };
    return {beyond(uv.x) ? uv.x - std::floor(uv.x) : uv.x, beyond(uv.y) ? uv.y - std::floor(uv.y) : uv.y};
}

inline dvec2 texCoordOf(const MeshData& mesh, std::size_t corner) {
    const std::uint32_t i = mesh.texCoordIndex.empty() ? MeshData::noTexCoord : mesh.texCoordIndex[corner];
    return i == MeshData::noTexCoord ? dvec2(0) : mesh.texCoords[i];
}

// The place on a triangle in barycentric coordinates, by Cramer's rule (Moeller and Trumbore 1997).
inline void meetMesh(const MeshData& mesh, const Ray& ray, Hit& hit) {
    for (std::size_t i = 0; i < mesh.positionIndex.size(); i += 3) {
        const auto corner = [&](std::size_t k) {
            return std::ldexp(1.0, mesh.exponent) * mesh.positions[mesh.positionIndex[i + k]];
        };
        const dvec3 ab = corner(1) - corner(0), ac = corner(2) - corner(0), ao = ray.origin - corner(0);
        const dvec3 alongB = cross(ray.direction, ac), alongC = cross(ao, ab);
        const double volume = dot(ab, alongB), t = dot(ac, alongC) / volume;
        const double b = dot(ao, alongB) / volume, c = dot(ray.direction, alongC) / volume, a = 1 - b - c;
        if (!hit.closer(t) || !(a >= 0 && b >= 0 && c >= 0)) continue;
        const dvec2 uv = a * texCoordOf(mesh, i) + b * texCoordOf(mesh, i + 1) + c * texCoordOf(mesh, i + 2);
        hit = {t, cross(ab, ac), repeated(uv)};
    }
}

inline void meet(const ShapeDescription& shape, const Ray& rayObject, Hit& hit) {
    switch (shape.type) {
        case ShapeType::Sphere: return meetSphere(rayObject, hit);
        case ShapeType::Plane: return meetPlane(rayObject, hit);
        case ShapeType::Cylinder: return meetCylinder(rayObject, hit);
        case ShapeType::Cone: return meetCone(rayObject, hit);
        case ShapeType::Cube: return meetCube(rayObject, hit);
        case ShapeType::Mesh: return meetMesh(*shape.mesh, rayObject, hit);
    }
}

inline dmat4 worldFromObject(const TransformDescription& transform) {
    dmat4 m(1);
    if (transform.translate) m = glm::translate(m, *transform.translate);
    if (transform.rotate) m = glm::rotate(m, glm::radians(transform.rotate->degrees), transform.rotate->axis);
    if (transform.scale) m = glm::scale(m, *transform.scale);
    return transform.matrix ? m * *transform.matrix : m;
}

// The nearest texel, from 0 to 1.
inline dvec3 texel(const Texture& texture, const dvec2& uv) {
    const int column = std::min(static_cast<int>(uv.x * texture.width), texture.width - 1);
    const int row = std::min(static_cast<int>((1 - uv.y) * texture.height), texture.height - 1);
    const std::uint8_t* rgb = &texture.texels[3 * (static_cast<std::size_t>(row) * texture.width + column)];
    return dvec3(rgb[0], rgb[1], rgb[2]) / 255.0;
}

// A secondary ray starts a little ahead, that it may not meet again the surface that it leaves: by a share of
// how far from the world's origin it and its parent start, for scenes of any size.
inline Ray leaving(const Ray& parent, const dvec3& p, const dvec3& unit) {
    return {p + 1e-9 * (length(p) + length(parent.origin)) * unit, unit};
}

// Keeps a reference to the scene.
class Tracer {
  public:
    explicit Tracer(const SceneDescription& scene) : scene_(scene) {
        for (const ShapeDescription& shape : scene.shapes)
            objectFromWorld_.push_back(inverse(worldFromObject(scene.transforms[shape.transform])));
    }

    // One ray through the centre of each pixel.
    ByteImage render(int longEdge) const {
        const CameraDescription& camera = scene_.camera;
        const double width = camera.film_right - camera.film_left;
        const double height = camera.film_top - camera.film_bottom, longer = std::max(width, height);
        const auto pixels = [&](double side) {
            return std::max(1, static_cast<int>(std::lround(longEdge * side / longer)));
        };
        ByteImage image{{pixels(width), pixels(height)}, {}};
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Ray ray = cameraRay((x + 0.5) / image.width, (y + 0.5) / image.height);
                const dvec3 color = clamp(rayColor(ray, 3), 0.0, 1.0);
                for (int i = 0; i < 3; ++i)
                    image.pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * color[i])));
            }
        return image;
    }

    // From (0, 0) at the picture's top left to (1, 1).
    dvec3 colorAt(const dvec2& point) const { return rayColor(cameraRay(point.x, point.y), 3); }

  private:
    Ray cameraRay(double x, double y) const {
        const CameraDescription& camera = scene_.camera;
        const dvec3 v = camera.up, w = -camera.look, u = cross(v, w);
        const dvec3 film = (camera.film_left + (camera.film_right - camera.film_left) * x) * u +
                           (camera.film_bottom + (camera.film_top - camera.film_bottom) * (1 - y)) * v;
        if (camera.type == CameraDescription::Type::Orthographic) return {camera.eye + film, -w};
        return {camera.eye, film - camera.focal_length * w};
    }

    Hit closestIntersection(const Ray& ray) const {
        Hit hit;
        for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
            const dmat4& m = objectFromWorld_[i];
            const double before = hit.t;
            meet(scene_.shapes[i], {dvec3(m * dvec4(ray.origin, 1)), dmat3(m) * ray.direction}, hit);
            if (hit.t == before) continue;
            hit.normal = normalize(transpose(dmat3(m)) * hit.normal);
            hit.material = &scene_.materials[scene_.shapes[i].material];
        }
        return hit;
    }

    dvec3 rayColor(const Ray& ray, int max_recursion) const {
        const Hit hit = closestIntersection(ray);
        if (!hit.material) return dvec3(0);
        const MaterialDescription& m = *hit.material;
        const dvec3 p = ray.at(hit.t), d = normalize(ray.direction);
        const bool entering = dot(hit.normal, d) < 0;
        const dvec3 n = entering ? hit.normal : -hit.normal;
        dvec3 color(0);
        for (const LightDescription& light : scene_.lights)
            color += m.color_ambient * light.color_ambient + direct(ray, hit, n, light);
        if (max_recursion == 0) return color;
        if (m.reflective)
            color += m.color_reflect * rayColor(leaving(ray, p, d - 2 * dot(d, n) * n), max_recursion - 1);
        const double ratio = entering ? 1 / m.index_of_refraction : m.index_of_refraction;
        const double cosine = -dot(d, n), squared = 1 - ratio * ratio * (1 - cosine * cosine);
        if (!m.refractive || squared < 0) return color;
        const dvec3 refracted = ratio * d + (ratio * cosine - std::sqrt(squared)) * n;
        return color + m.color_refract * rayColor(leaving(ray, p, refracted), max_recursion - 1);
    }

    // [K_D I_L (N.L) + K_S I_L (V.R)^n] S_L
    dvec3 direct(const Ray& ray, const Hit& hit, const dvec3& n, const LightDescription& light) const {
        const MaterialDescription& m = *hit.material;
        const dvec3 p = ray.at(hit.t), v = -normalize(ray.direction), l = normalize(light.position - p);
        const double nl = dot(n, l), vr = dot(v, 2 * nl * n - l);
        if (nl <= 0) return dvec3(0);
        const dvec3 specular = vr > 0 ? m.color_specular * std::pow(vr, m.shininess) : dvec3(0);
        return (diffuse(m, hit.texCoord) * nl + specular) * light.color * shadow(leaving(ray, p, l), light);
    }

    dvec3 diffuse(const MaterialDescription& m, const dvec2& uv) const {
        if (m.use_diffuse_texture)
            for (const TextureDescription& texture : scene_.textures)
                if (texture.name == m.diffuse_texture) return m.color_diffuse * texel(*texture.texture, uv);
        return m.color_diffuse;
    }

    // The closest hit alone counts.
    dvec3 shadow(const Ray& toLight, const LightDescription& light) const {
        const Hit hit = closestIntersection(toLight);
        if (!hit.material || hit.t >= distance(toLight.origin, light.position)) return dvec3(1);
        return hit.material->refractive ? hit.material->color_refract : dvec3(0);
    }

    const SceneDescription& scene_;
    std::vector<dmat4> objectFromWorld_;
};

}  // namespace raytracer::plain
