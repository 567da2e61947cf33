// Mistakes that are edits of the scene's description or of the options: terms, lights, materials.
#include <algorithm>
#include <utility>

#include "mistake.h"
#include "raytracer/pictures/texture.h"

namespace raytracer {

namespace {

Edit ofMaterials(const std::function<void(MaterialDescription&)>& change) {
    return [=](SceneDescription& scene, RenderOptions&) {
        std::for_each(scene.materials.begin(), scene.materials.end(), change);
    };
}

Edit ofLights(
    const std::function<void(LightDescription& light, std::size_t index, std::size_t count)>& change) {
    return [=](SceneDescription& scene, RenderOptions&) {
        for (std::size_t i = 0; i < scene.lights.size(); ++i) change(scene.lights[i], i, scene.lights.size());
    };
}

Edit without(bool Terms::*term) {
    return [=](SceneDescription& scene, RenderOptions& options) {
        Terms terms;
        terms.*term = false;
        keepTerms(scene, terms);
        options.shadows = options.shadows && terms.shadows;
        options.refraction = options.refraction && terms.refraction;
    };
}

Edit withRecursion(const std::function<int(int)>& change) {
    return [=](SceneDescription&, RenderOptions& options) {
        options.max_recursion = change(options.max_recursion);
    };
}

void addTerms(Mistakes& mistakes) {
    mistakes.add("without ambient light", "Is K_A I_AL added for every light?", "ambient",
                 without(&Terms::ambient));
    mistakes.add("without diffuse light", "Is K_D I_L (N.L) added?", "", without(&Terms::diffuse));
    mistakes.add("without specular light", "Is K_S I_L (V.R)^n added?", "specular",
                 without(&Terms::specular));
    mistakes.add("without shadows", "Is a ray cast from the surface to the light, and S_L 0 where it hits?",
                 "shadows", without(&Terms::shadows));
    mistakes.add("without reflections", "Is K_R I_R added where reflective is true?", "mirror",
                 without(&Terms::reflections));
    mistakes.add("without refraction", "Is K_T I_T added where refractive is true?", "glass",
                 without(&Terms::refraction));
    mistakes.add("without textures",
                 "Does use_diffuse_texture multiply color_diffuse by the texture's colour?", "texture",
                 without(&Terms::textures));
}

void addDepths(Mistakes& mistakes, int depth) {
    const auto text = [](int bounces) { return " (max_recursion " + std::to_string(bounces) + ")"; };
    const char* const hint =
        "Is max_recursion > 0 checked before each bounce, and max_recursion - 1 passed on?";
    if (depth > 0)
        mistakes.add("with one bounce less" + text(depth - 1), hint, "depth",
                     withRecursion([](int bounces) { return bounces - 1; }));
    mistakes.add("with one bounce more" + text(depth + 1), hint, "depth",
                 withRecursion([](int bounces) { return bounces + 1; }));
    constexpr int most = mostRecursionTried;
    for (int other = 1; other <= most; ++other)
        if (other < depth - 1 || other > depth + 1)
            mistakes.push_back({.what = "with max_recursion " + std::to_string(other) +
                                        (other == most && most > depth ? " or more" : "") + " instead of " +
                                        std::to_string(depth),
                                .hint = hint,
                                .kind = "depth",
                                .edit = withRecursion([other](int) { return other; }),
                                .alone = true});
    if (depth > 1)
        mistakes.add("without any reflected or refracted ray" + text(0), hint, "depth",
                     withRecursion([](int) { return 0; }));
}

void addLightMistakes(Mistakes& mistakes, std::size_t count) {
    const auto ordinal = [&](std::size_t i) {
        return std::to_string(i) + " (of " + std::to_string(count) + ")";
    };
    const char* const loop = "Does the loop visit every light?";
    const auto ambientOf = [](bool last) {
        return ofLights([=](LightDescription& light, std::size_t i, std::size_t n) {
            if (i != (last ? n - 1 : 0)) light.color_ambient = glm::dvec3(0);
        });
    };
    for (std::size_t i = 0; count > 1 && i < std::min<std::size_t>(count, 4); ++i) {
        mistakes.add("without light " + ordinal(i), loop, "lights",
                     [i](SceneDescription& scene, RenderOptions&) {
                         scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(i));
                     });
        if (count > 2)
            mistakes.add("with light " + ordinal(i) + " alone", loop, "lights",
                         [i](SceneDescription& scene, RenderOptions&) { scene.lights = {scene.lights[i]}; });
    }
    if (count > 1) {
        const char* const what = "whose ambient light is added once, not once for each light";
        const char* const hint = "K_A I_AL belongs into the sum over the lights.";
        mistakes.add(what, hint, "ambient", ambientOf(false));
        mistakes.add(what, hint, "ambient", ambientOf(true));
    }
    mistakes.add("whose ambient light has the light's color instead of its color_ambient", "", "ambient",
                 ofLights([](LightDescription& light, std::size_t, std::size_t) {
                     light.color_ambient = light.color;
                 }));
}

void addGlass(Mistakes& mistakes) {
    mistakes.add("whose glass is opaque", "Is refractive read, and a ray sent on through the surface?",
                 "glass", [](SceneDescription& scene, RenderOptions&) { makeOpaque(scene); });
    mistakes.add("whose index of refraction is inverted",
                 "Entering, the ratio is 1 / ior; leaving, it is ior.", "glass",
                 ofMaterials([](MaterialDescription& material) {
                     material.index_of_refraction = 1 / material.index_of_refraction;
                 }));
    mistakes.add("whose rays go straight through glass", "Is index_of_refraction used?", "glass",
                 ofMaterials([](MaterialDescription& material) { material.index_of_refraction = 1; }));
    mistakes.add("without the factor color_refract", "K_T multiplies I_T.", "glass",
                 ofMaterials([](MaterialDescription& material) { material.color_refract = glm::dvec3(1); }));
}

std::shared_ptr<const Texture> upsideDown(const Texture& texture) {
    Texture flipped = texture;
    const auto flip = [&](auto& texels) {
        const std::size_t row = 3 * static_cast<std::size_t>(texture.width);
        for (std::size_t top = 0, bottom = texels.size() - row; top < bottom; top += row, bottom -= row)
            std::swap_ranges(texels.begin() + static_cast<std::ptrdiff_t>(top),
                             texels.begin() + static_cast<std::ptrdiff_t>(top + row),
                             texels.begin() + static_cast<std::ptrdiff_t>(bottom));
    };
    if (!flipped.texels.empty()) flip(flipped.texels);
    if (!flipped.deepTexels.empty()) flip(flipped.deepTexels);
    return std::make_shared<const Texture>(std::move(flipped));
}

void addTextureMistakes(Mistakes& mistakes, bool isBilinear) {
    mistakes.add(isBilinear ? "with the nearest texel alone" : "with bilinear texture look-ups",
                 isBilinear ? "Are the four nearest texels weighted?"
                            : "A texture's colour is that of the nearest texel.",
                 "texture",
                 [](SceneDescription&, RenderOptions& options) { options.bilinear = !options.bilinear; });
    mistakes.add("whose textures are upside down", "Row 0 of the image is at v = 1.", "texture",
                 [](SceneDescription& scene, RenderOptions&) {
                     for (TextureDescription& texture : scene.textures)
                         if (texture.texture) texture.texture = upsideDown(*texture.texture);
                 });
}

void addMaterialMistakes(Mistakes& mistakes) {
    mistakes.add("without the factor color_reflect", "K_R multiplies I_R.", "mirror",
                 ofMaterials([](MaterialDescription& material) { material.color_reflect = glm::dvec3(1); }));
}

}  // namespace

void addSceneMistakes(Mistakes& mistakes, const SceneDescription& scene, const RenderOptions& options) {
    addTerms(mistakes);
    addDepths(mistakes, options.max_recursion);
    addLightMistakes(mistakes, scene.lights.size());
    addMaterialMistakes(mistakes);
    if (!scene.textures.empty()) addTextureMistakes(mistakes, options.bilinear);
    if (std::ranges::any_of(scene.materials, &MaterialDescription::refractive)) addGlass(mistakes);
}

}  // namespace raytracer
