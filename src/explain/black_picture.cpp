#include "raytracer/explain/black_picture.h"

#include <algorithm>
#include <optional>
#include <set>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "raytracer/explain/scene_advice.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

bool isBlack(const glm::dvec3& color) { return color == glm::dvec3(0); }

double brightest(const glm::dvec3& color) { return std::max({color.x, color.y, color.z}); }

// Counts why the lights do not reach the explained points: once for each point and light.
struct Tally {
    std::size_t behind = 0, shadowed = 0, black = 0;
    std::set<std::size_t> shadowedBy;
    double brightest = 0;               // the largest channel of all pixels
    std::size_t material = 0;           // that of the first pixel's shape
    std::optional<std::size_t> around;  // the shape whose inner side all pixels show, if there is one

    void add(const LightExplanation& light) {
        if (!(light.N_L > 0)) {
            ++behind;
        } else if (!light.shadowRayCast) {
            ++black;
        } else if (isBlack(light.S_L) && light.shadowedBy) {
            ++shadowed;
            shadowedBy.insert(*light.shadowedBy);
        }
    }

    void add(const RayExplanation& ray) {
        for (const LightExplanation& light : ray.lights) add(light);
        for (const RayExplanation& next : ray.rays) add(next);
    }
};

// Finds the reason, and what to change.
class Reason {
  public:
    Reason(const Tally& tally, const SceneDescription& scene) : tally_(tally), scene_(scene) {}

    std::string inWords() const {
        if (tally_.brightest > 0)
            return formatted("it is too dark: the largest channel is %.3g of 1: brighten a light",
                             tally_.brightest);
        if (std::ranges::all_of(scene_.lights, isBlackLight))
            return "what is seen has only black lights: set /lights/0/color" +
                   (isLitBlack(material())
                        ? " and " + pointer("materials", tally_.material) + "/color_diffuse"
                        : "");
        if (const auto light = std::ranges::find_if(scene_.lights, takesLightAway);
            light != scene_.lights.end())
            return pointer("lights", static_cast<std::size_t>(light - scene_.lights.begin())) +
                   "/color is negative, which takes light away: write 0 or more";
        if (const auto around = shapeAround())
            return "the camera is inside of " + pointer("shapes", *around) + ", a " +
                   typeName(scene_.shapes[*around].type) + ": move it out, or a light in";
        if (areLightsHidden(scene_)) return "its lights are inside of opaque shapes: move one out";
        if (tally_.behind + tally_.shadowed == 0)
            return "what is seen is black: set " + pointer("materials", tally_.material) + "/color_diffuse";
        return unlit() + ", or set " + ambientColor();
    }

  private:
    static bool isBlackLight(const LightDescription& light) { return isBlack(light.color); }
    static bool takesLightAway(const LightDescription& light) {
        return glm::any(glm::lessThan(light.color, glm::dvec3(0)));
    }

    static bool isLitBlack(const MaterialDescription& material) {
        return isBlack(material.color_diffuse) && isBlack(material.color_specular);
    }
    const MaterialDescription& material() const { return scene_.materials[tally_.material]; }

    static std::string pointer(const char* list, std::size_t index) {
        return std::string("/") + list + "/" + std::to_string(index);
    }

    std::optional<std::size_t> shapeAround() const {
        if (const auto around = darkShapeAroundCamera(scene_)) return around;
        const bool isMesh = tally_.around && scene_.shapes[*tally_.around].type == ShapeType::Mesh;
        return isMesh ? tally_.around : std::nullopt;
    }

    std::string unlit() const {
        if (tally_.shadowed + tally_.black == 0) return "what is seen faces no light: move one";
        if (tally_.behind + tally_.black > 0) return "no light reaches what is seen: move one";
        if (tally_.shadowedBy.size() > 1) return "what is seen is in shadow: move a light";
        return pointer("shapes", *tally_.shadowedBy.begin()) + " shadows what is seen: move it";
    }

    // The ambient colours to set: the light's if all lights' are black, the material's if it is black.
    std::string ambientColor() const {
        const bool noLight = std::ranges::all_of(
            scene_.lights, [](const LightDescription& light) { return isBlack(light.color_ambient); });
        const std::string light = pointer("lights", 0), surface = pointer("materials", tally_.material);
        if (noLight && isBlack(material().color_ambient))
            return "color_ambient of " + light + " and " + surface;
        return (noLight ? light : surface) + "/color_ambient";
    }

    const Tally& tally_;
    const SceneDescription& scene_;
};

// Pass::Normals has 54/255 for a miss, in the core's precision. The nearest colour of a hit, of the unit
// normal with three equal components, is 4e-4 away from it.
bool isMiss(const glm::dvec3& color) {
    return glm::all(glm::lessThan(glm::abs(color - 54.0 / 255), glm::dvec3(1e-4)));
}

std::optional<PixelPlace> firstHit(const Renderer& renderer, const RenderOptions& options,
                                   const PixelRectangle& pixels) {
    std::vector<glm::dvec2> centres;
    for (int y = pixels.y0; y < pixels.y1; ++y)
        for (int x = pixels.x0; x < pixels.x1; ++x) centres.emplace_back(x + 0.5, y + 0.5);
    std::vector<glm::dvec3> normals(centres.size());
    renderer.renderPoints(options, centres, normals);
    const auto hit = std::ranges::find_if_not(normals, isMiss);
    if (hit == normals.end()) return std::nullopt;
    const glm::dvec2& centre = centres[static_cast<std::size_t>(hit - normals.begin())];
    return PixelPlace{static_cast<int>(centre.x), static_cast<int>(centre.y)};
}

// For each cell of a grid, the first pixel in reading order whose ray hits something.
std::vector<PixelPlace> pixelsThatHit(const Renderer& renderer, RenderOptions options) {
    constexpr int cells = 24;       // across and down; 576 explanations take milliseconds
    constexpr int rowsAtOnce = 64;  // limits the memory
    const auto begin = [](int cell, int pixels) {
        return static_cast<int>((std::int64_t{cell} * pixels + cells - 1) / cells);
    };
    options.pass = Pass::Normals;
    std::vector<PixelPlace> hits;
    for (int cell = 0; cell < cells * cells; ++cell) {
        const int row = cell / cells, column = cell % cells;
        const PixelRectangle all{begin(column, options.size.width), begin(row, options.size.height),
                                 begin(column + 1, options.size.width), begin(row + 1, options.size.height)};
        std::optional<PixelPlace> hit;
        for (int y = all.y0; y < all.y1 && !hit; y += rowsAtOnce)
            hit = firstHit(renderer, options, {all.x0, y, all.x1, std::min(y + rowsAtOnce, all.y1)});
        if (hit) hits.push_back(*hit);
    }
    return hits;
}

}  // namespace

std::string whyBlack(const SceneDescription& scene, const Renderer& renderer, const RenderOptions& options) {
    const std::string black = "all black: ";
    if (scene.shapes.empty()) return black + "the scene has no shapes: add one to \"shapes\"";
    if (std::ranges::all_of(scene.shapes, hasNoArea))
        return black + "no mesh has an area: move corners of its triangles off their line";
    if (scene.lights.empty()) return black + "the scene has no lights: add one to \"lights\"";
    RenderOptions centres = options;
    centres.samples = 1;
    centres.adaptive = 0;
    const std::vector<PixelPlace> pixels = pixelsThatHit(renderer, centres);
    if (pixels.empty())
        return black + "no ray through a pixel's centre hits a shape: " +
               (mayShowShapes(scene) ? "take more pixels, or " : "") + "turn or move the camera";
    Tally tally;
    for (const PixelPlace& pixel : pixels) {
        const RayExplanation explanation = renderer.explain(centres, pixel.x, pixel.y);
        if (&pixel == &pixels.front()) {
            tally.around = explanation.shape;
            tally.material = scene.shapes[explanation.shape].material;
        }
        if (explanation.entering || explanation.shape != tally.around) tally.around.reset();
        tally.add(explanation);
        tally.brightest = std::max(tally.brightest, brightest(explanation.color));
    }
    return black + Reason(tally, scene).inWords();
}

}  // namespace raytracer
