#include "raytracer/explain/scene_advice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include <glm/geometric.hpp>

#include "advice_lines.h"
#include "raytracer/json/json_pointer.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

using Color = glm::dvec3;

std::string shown(double number) { return formatted("%.6g", number); }

std::string shown(const Color& color) { return formatted("%.6g %.6g %.6g", color.x, color.y, color.z); }

double most(const Color& color) { return std::max({color.x, color.y, color.z}); }

bool isNegative(const Color& color) { return std::min({color.x, color.y, color.z}) < 0; }

// What a color that is too bright should be divided by: 255 or 65535 if it seems to be written in bytes or in
// 16 bits, else its largest channel; 0 if it is not too bright. A color in bytes has a largest channel of at
// least `least` times 255, and at most twice 255, to allow for colors that are brighter than white.
double divisorOf(const Color& color, double least) {
    if (isNegative(color) || most(color) < least * 255) return 0;
    for (const double white : {255, 65535})
        if (most(color) >= least * white && most(color) <= 2 * white) return white;
    return most(color);
}

// A real camera's film is 36 mm wide, and a lens of 18 mm is a wide-angle lens. Written in mm for a film of
// width 2, 18 is 9 times the film's width. No usual lens is that long.
constexpr double filmInMm = 36, leastTele = 9;

// In white light, a surface with a color of 10 is overexposed wherever the light comes from at most 84
// degrees beside the normal, so that its shape cannot be seen. As a byte, 10 is nearly black.
constexpr double leastOfSurface = 10.0 / 255;
// A light may well be ten times as bright as white, for dark surfaces or grazing light; twice that leaves a
// margin. One that is written in bytes may be dim: an ambient light of a fifth of white is 51.
constexpr double leastOfLight = 20.0 / 255;

class SlipFinder {
  public:
    explicit SlipFinder(const SceneDescription& scene) : scene_(scene) {}

    std::vector<std::string> find() {
        lookAtFilm();
        for (std::size_t i = 0; i < scene_.textures.size(); ++i) lookAtTexture(scene_.textures[i]);
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) lookAtMaterial(i);
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) lookAtLight(i);
        for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
            lookAtMesh(i);
            lookAtTexturedMesh(i);
        }
        return lines_.take();
    }

  private:
    void lookAtFilm() {
        const CameraDescription& camera = scene_.camera;
        if (camera.film_left > camera.film_right)
            lines_.add("/camera/film_left: the picture is mirrored: swap it with film_right");
        if (camera.film_bottom > camera.film_top)
            lines_.add("/camera/film_bottom: the picture is upside down: swap it with film_top");
        const double side = std::max(std::abs(camera.film_right - camera.film_left),
                                     std::abs(camera.film_top - camera.film_bottom));
        if (camera.type == CameraDescription::Type::Perspective) lookAtFocalLength(camera.focal_length, side);
    }

    // Says nothing of a length that would be too long for a film of filmInMm, too.
    void lookAtFocalLength(double length, double side) {
        const auto isLong = [=](double focalLength) { return focalLength >= leastTele * side; };
        const std::string remedy = formatted("%.4g", length / filmInMm * side);
        if (isLong(length) && !isLong(std::strtod(remedy.c_str(), nullptr)))
            lines_.add("/camera/focal_length: " + formatted("%.4g is long for a film of %.4g", length, side) +
                       ": if in mm, write " + remedy);
    }

    void lookAtTexture(const TextureDescription& texture) {
        const auto names = [&](const MaterialDescription& material) {
            return material.diffuse_texture == texture.name;
        };
        if (std::ranges::none_of(scene_.materials, names))
            lines_.add("/textures" + shownStep(texture.name) +
                       ": no diffuse_texture names it: name it, or delete it");
    }

    void lookAtSign(const std::string& place, const Color& color) {
        if (isNegative(color)) lines_.add(place + ": a negative color takes light away: write 0 or more");
    }

    void lookAtSurface(const std::string& place, const Color& color) {
        lookAtSign(place, color);
        if (const double divisor = divisorOf(color, leastOfSurface); divisor > 0)
            lines_.add(place + ": colors end at 1: divide " + shown(color) + " by " + shown(divisor));
    }

    void lookAtLamp(const std::string& place, const Color& color) {
        lookAtSign(place, color);
        const double divisor = divisorOf(color, leastOfLight);
        if (divisor == 255 || divisor == 65535)
            lines_.add(place + ": white is 1 1 1: if this is in " + (divisor == 255 ? "bytes" : "16 bits") +
                       ", divide it by " + shown(divisor));
        else if (divisor > 0)
            lines_.add(place + ": white is 1 1 1, since no distance dims light: divide " + shown(color) +
                       " by " + shown(divisor));
    }

    void lookAtMaterial(std::size_t i) {
        const MaterialDescription& material = scene_.materials[i];
        const std::string place = "/materials/" + std::to_string(i);
        lookAtSurface(place + "/color_ambient", material.color_ambient);
        lookAtSurface(place + "/color_diffuse", material.color_diffuse);
        lookAtSurface(place + "/color_specular", material.color_specular);
        lookAtSurface(place + "/color_reflect", material.color_reflect);
        lookAtSurface(place + "/color_refract", material.color_refract);
        if (!material.diffuse_texture.empty() && !material.use_diffuse_texture)
            lines_.add(place + "/diffuse_texture: not shown without \"use_diffuse_texture\": true");
    }

    void lookAtLight(std::size_t i) {
        const std::string place = "/lights/" + std::to_string(i);
        lookAtLamp(place + "/color", scene_.lights[i].color);
        lookAtLamp(place + "/color_ambient", scene_.lights[i].color_ambient);
    }

    // The area vectors of a closed surface add up to zero. Its volume is then a sixth of the sum of the
    // triple products; it is negative if the triangles are clockwise as seen from outside.
    static bool isInsideOut(const MeshData& mesh) {
        constexpr double open = 1e-6;  // far above rounding errors, far below the area of a hole
        const glm::dvec3 middle = 0.5 * (mesh.low + mesh.high);
        glm::dvec3 sum(0);
        double area = 0, volume = 0;
        for (std::size_t i = 0; i < mesh.positionIndex.size(); i += 3) {
            const auto corner = [&](std::size_t j) {
                return mesh.positions[mesh.positionIndex[i + j]] - middle;
            };
            const glm::dvec3 a = corner(0), b = corner(1), c = corner(2), twice = glm::cross(b - a, c - a);
            sum += twice;
            area += glm::length(twice);
            volume += glm::dot(a, glm::cross(b, c));
        }
        return glm::length(sum) <= open * area && volume < -open * area * glm::length(mesh.high - mesh.low);
    }

    void lookAtMesh(std::size_t i) {
        const ShapeDescription& shape = scene_.shapes[i];
        if (!shape.mesh || !seen_.insert(shape.mesh.get()).second) return;
        const std::string place = "/shapes/" + std::to_string(i) + "/path: ";
        if (isInsideOut(*shape.mesh))
            lines_.add(place + "the mesh is inside out: turn its clockwise triangles round");
    }

    void lookAtTexturedMesh(std::size_t i) {
        const ShapeDescription& shape = scene_.shapes[i];
        if (shape.mesh && shape.mesh->texCoordIndex.empty() && materialOf(scene_, i).use_diffuse_texture)
            lines_.add("/shapes/" + std::to_string(i) +
                       "/path: the mesh has no vt, so shows one texel: save it with texture coordinates");
    }

    const SceneDescription& scene_;
    AdviceLines lines_;
    std::set<const MeshData*> seen_;
};

}  // namespace

std::vector<std::string> sceneSlips(const SceneDescription& scene) { return SlipFinder(scene).find(); }

namespace {

void noteMaterial(const SceneDescription& scene, std::size_t i, AdviceLines& lines) {
    const MaterialDescription& material = scene.materials[i];
    const std::string place = "/materials/" + std::to_string(i);
    const auto isSet = [](const Color& color) { return color != Color(0) && color != Color(1); };
    const char* const none = ": it has no effect without ";
    if (!material.reflective && isSet(material.color_reflect))
        lines.add(place + "/color_reflect" + none + "\"reflective\": true");
    if (!material.refractive && isSet(material.color_refract))
        lines.add(place + "/color_refract" + none + "\"refractive\": true");
    if (material.refractive && material.index_of_refraction == 1)
        lines.add(place + "/index_of_refraction: 1 bends no ray: glass has 1.5");
}

}  // namespace

std::vector<std::string> sceneNotes(const SceneDescription& scene) {
    AdviceLines lines;
    for (std::size_t i = 0; i < scene.materials.size(); ++i) noteMaterial(scene, i, lines);
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].position == glm::dvec3(0))
            lines.add("/lights/" + std::to_string(i) +
                      ": it stands at 0 0 0, as one without a position does: set its position");
    return lines.take();
}

}  // namespace raytracer
