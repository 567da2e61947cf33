#include "raytracer/explain/scene_slips.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/geometric.hpp>

#include "advice_lines.h"
#include "raytracer/json/json_pointer.h"
#include "raytracer/scene/mesh_file.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

using Color = glm::dvec3;

std::string shown(const Color& color) { return formatted("%.4g %.4g %.4g", color.x, color.y, color.z); }

// One number is larger than a color of 0 to 1 is in any scene: our own have 1.6. Twice as much as white is as
// far as such a color is overdone; more has another unit.
bool isOfBytes(const Color& color, double least) {
    constexpr double white = 255;
    const double most = std::max({color.x, color.y, color.z});
    return most >= least && most <= 2 * white && std::min({color.x, color.y, color.z}) >= 0;
}

class SlipFinder {
  public:
    explicit SlipFinder(const SceneDescription& scene) : scene_(scene) {}

    std::vector<std::string> find() {
        lookAtFilm();
        for (std::size_t i = 0; i < scene_.textures.size(); ++i) lookAtTexture(scene_.textures[i]);
        for (std::size_t i = 0; i < scene_.materials.size(); ++i) lookAtMaterial(i);
        for (std::size_t i = 0; i < scene_.lights.size(); ++i) lookAtLight(i);
        for (std::size_t i = 0; i < scene_.shapes.size(); ++i) lookAtMesh(i);
        return lines_.take();
    }

  private:
    void lookAtFilm() {
        const CameraDescription& camera = scene_.camera;
        if (camera.film_left > camera.film_right)
            lines_.add("/camera/film_left: the picture is mirrored: swap it with film_right");
        if (camera.film_bottom > camera.film_top)
            lines_.add("/camera/film_bottom: the picture is upside down: swap it with film_top");
    }

    void lookAtTexture(const TextureDescription& texture) {
        const auto names = [&](const MaterialDescription& material) {
            return material.diffuse_texture == texture.name;
        };
        if (std::ranges::none_of(scene_.materials, names))
            lines_.add("/textures" + pointerStep(texture.name) +
                       ": no material uses it: name it in a diffuse_texture, or delete it");
    }

    void lookAtColor(const std::string& place, const Color& color, double least) {
        if (isOfBytes(color, least))
            lines_.add(place + ": colors end at 1: divide " + shown(color) + " by 255");
    }

    void lookAtMaterial(std::size_t i) {
        constexpr double least = 11;
        const MaterialDescription& material = scene_.materials[i];
        const std::string place = "/materials/" + std::to_string(i);
        lookAtColor(place + "/color_ambient", material.color_ambient, least);
        lookAtColor(place + "/color_diffuse", material.color_diffuse, least);
        lookAtColor(place + "/color_specular", material.color_specular, least);
        lookAtColor(place + "/color_reflect", material.color_reflect, least);
        lookAtColor(place + "/color_refract", material.color_refract, least);
        if (!material.diffuse_texture.empty() && !material.use_diffuse_texture)
            lines_.add(place + "/diffuse_texture: not shown without \"use_diffuse_texture\": true");
    }

    // A light may well be brighter than 1.
    void lookAtLight(std::size_t i) {
        constexpr double least = 32;
        const std::string place = "/lights/" + std::to_string(i);
        lookAtColor(place + "/color", scene_.lights[i].color, least);
        lookAtColor(place + "/color_ambient", scene_.lights[i].color_ambient, least);
    }

    // The areas of a closed surface, as vectors, add up to nothing; then a sixth of the sum of the triple
    // products is its volume, negative where the triangles are clockwise seen from outside.
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
        const MeshData* const mesh = scene_.shapes[i].mesh.get();
        if (mesh && seen_.insert(mesh).second && isInsideOut(*mesh))
            lines_.add("/shapes/" + std::to_string(i) +
                       "/path: the mesh is inside out: turn its clockwise triangles round");
    }

    const SceneDescription& scene_;
    AdviceLines lines_;
    std::set<const MeshData*> seen_;
};

}  // namespace

std::vector<std::string> sceneSlips(const SceneDescription& scene) { return SlipFinder(scene).find(); }

std::vector<std::string> colorsWithoutEffect(const SceneDescription& scene) {
    AdviceLines lines;
    const auto look = [&](std::size_t i, const char* color, const char* flag) {
        lines.add("/materials/" + std::to_string(i) + "/" + color + ": it has no effect without \"" + flag +
                  "\": true");
    };
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const MaterialDescription& material = scene.materials[i];
        const auto isSet = [](const Color& color) { return color != Color(0) && color != Color(1); };
        if (!material.reflective && isSet(material.color_reflect)) look(i, "color_reflect", "reflective");
        if (!material.refractive && isSet(material.color_refract)) look(i, "color_refract", "refractive");
    }
    return lines.take();
}

}  // namespace raytracer
