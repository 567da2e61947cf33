#include "foreign_keys.h"

#include <algorithm>

#include "raytracer/util/text.h"

namespace raytracer {
namespace {

constexpr ForeignKey foreignKeys[] = {
    {"rotation", "rotate", "write rotate, with degrees and an axis"},
    {"scaling", "scale"},
    {"size", "scale"},
    {"position", "translate"},
    {"location", "translate"},
    {"move", "translate"},
    {"offset", "translate"},
    {"degrees", "rotate", "it stands in rotate, beside an axis"},
    {"angle", "rotate", "it stands in rotate, as degrees"},
    {"axis", "rotate", "it stands in rotate, beside degrees"},
    {"angle", "degrees"},
    {"radians", "degrees", "degrees are radians times 180 / pi"},
    {"position", "eye"},
    {"location", "eye"},
    {"look_at", "look", "look is the direction, the target minus the eye"},
    {"lookat", "look", "look is the direction, the target minus the eye"},
    {"target", "look", "look is the direction, the target minus the eye"},
    {"direction", "look"},
    {"fov", "focal_length", "focal_length and film_left to film_top give the angle"},
    {"id", "name"},
    {"texture", "diffuse_texture"},
    {"use_texture", "use_diffuse_texture"},
    {"color", "color_diffuse"},
    {"diffuse_color", "color_diffuse"},
    {"specular_color", "color_specular"},
    {"ambient_color", "color_ambient"},
    {"kd", "color_diffuse"},
    {"ks", "color_specular"},
    {"ka", "color_ambient"},
    {"specular_exponent", "shininess"},
    {"ior", "index_of_refraction"},
    {"reflectivity", "color_reflect"},
    {"reflectance", "color_reflect"},
    {"reflection", "color_reflect"},
    {"mirror", "color_reflect", "reflective and color_reflect make a mirror"},
    {"glass", "color_refract", "refractive and color_refract make glass"},
    {"opacity", "color_refract", "refractive and color_refract let light through"},
    {"alpha", "color_refract", "refractive and color_refract let light through"},
    {"transparency", "color_refract", "refractive and color_refract let light through"},
    {"intensity", "color", "multiply its color by it"},
    {"brightness", "color", "multiply its color by it"},
    {"location", "position"},
    {"radius", "transform", "scale in its transform gives the size"},
    {"size", "transform", "scale in its transform gives the size"},
    {"scale", "transform", "it stands in its transform"},
    {"rotate", "transform", "it stands in its transform"},
    {"translate", "transform", "it stands in its transform"},
    {"center", "transform", "translate in its transform gives the place"},
    {"position", "transform", "translate in its transform gives the place"},
    {"color", "transform", "its material has the colors"},
    {"path", "transform", "only a mesh has one; delete it"},
    {"objects", "shapes"},
    {"max_recursion", "shapes", "it is the option --max-recursion"},
    {"max_depth", "shapes", "it is the option --max-recursion"},
    {"recursion_depth", "shapes", "it is the option --max-recursion"},
    {"samples", "shapes", "it is the option --samples"},
    {"resolution", "shapes", "LONG_EDGE_PIXELS of the command line gives it"},
    {"width", "shapes", "LONG_EDGE_PIXELS of the command line gives it"},
    {"height", "shapes", "LONG_EDGE_PIXELS of the command line gives it"},
};

}  // namespace

const ForeignKey* foreignKey(std::string_view key, std::span<const std::string_view> known) {
    const std::string lower = inLowerCase(key);
    const auto isMeant = [&](const ForeignKey& other) {
        return other.key == lower && std::ranges::find(known, other.beside) != known.end();
    };
    const auto found = std::ranges::find_if(foreignKeys, isMeant);
    return found == std::end(foreignKeys) ? nullptr : found;
}

}  // namespace raytracer
