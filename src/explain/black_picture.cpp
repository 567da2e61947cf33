#include "raytracer/explain/black_picture.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "raytracer/util/text.h"

namespace raytracer {

namespace {

bool isBlack(const glm::dvec3& color) { return color == glm::dvec3(0); }

double brightest(const glm::dvec3& color) { return std::max({color.x, color.y, color.z}); }

// Takes a Pass::Normals picture and keeps, of each cell of a grid, the first pixel in reading order that hit
// something: the same pixels with any number of threads.
class HitFinder final : public PixelSink {
  public:
    explicit HitFinder(const ImageSize& size) : size_(size) {}

    void write(int x, int y, std::span<const glm::dvec3> colors) override {
        const std::lock_guard lock(mutex_);
        for (std::size_t i = 0; i < colors.size(); ++i)
            if (!isMiss(colors[i])) keep({x + static_cast<int>(i), y});
    }

    std::vector<PixelPlace> found() const {
        std::vector<PixelPlace> pixels;
        for (const auto& pixel : cells_)
            if (pixel) pixels.push_back(*pixel);
        return pixels;
    }

  private:
    static constexpr int cellsAcross = 24;  // 576 explanations take milliseconds

    // Pass::Normals has 54/255 for a miss, in the core's precision. The unit normal with three equal
    // components is 4e-4 away from it.
    static bool isMiss(const glm::dvec3& color) {
        return glm::all(glm::lessThan(glm::abs(color - 54.0 / 255), glm::dvec3(1e-4)));
    }

    void keep(const PixelPlace& pixel) {
        const auto cell = [](int place, int count) {
            return static_cast<std::size_t>(std::int64_t{place} * cellsAcross / count);
        };
        auto& kept = cells_[cell(pixel.y, size_.height) * cellsAcross + cell(pixel.x, size_.width)];
        if (!kept || std::pair(pixel.y, pixel.x) < std::pair(kept->y, kept->x)) kept = pixel;
    }

    ImageSize size_;
    std::mutex mutex_;
    std::array<std::optional<PixelPlace>, cellsAcross * cellsAcross> cells_;
};

// Why the lights do not reach the explained points: one count for each point and light.
struct Tally {
    std::size_t behind = 0, shadowed = 0, black = 0;
    std::set<std::size_t> shadowedBy;
    double brightest = 0;               // of the pixels
    std::optional<std::size_t> around;  // the one shape whose inner side all pixels see

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

std::string inShadow(const Tally& tally) {
    if (tally.shadowedBy.size() != 1) return "what is seen is in shadow";
    return "/shapes/" + std::to_string(*tally.shadowedBy.begin()) + " shadows what is seen";
}

std::string unlit(const Tally& tally, const SceneDescription& scene) {
    const bool noLight =
        std::ranges::all_of(scene.lights, [](const LightDescription& light) { return isBlack(light.color); });
    if (noLight) return "what is seen has only black lights";
    if (tally.behind + tally.shadowed == 0) return "what is seen has black materials";
    if (tally.behind + tally.black == 0) return inShadow(tally);
    if (tally.shadowed + tally.black == 0) return "the lights are behind what is seen";
    return "no light reaches what is seen";
}

std::string withoutAmbient(const SceneDescription& scene) {
    const bool noLight = std::ranges::all_of(
        scene.lights, [](const LightDescription& light) { return isBlack(light.color_ambient); });
    return noLight ? "; no light has color_ambient" : "; its color_ambient is black";
}

std::string reason(const Tally& tally, const SceneDescription& scene) {
    if (tally.around)
        return "the eye is inside of /shapes/" + std::to_string(*tally.around) + ", a " +
               typeName(scene.shapes[*tally.around].type);
    if (tally.brightest <= 0) return unlit(tally, scene) + withoutAmbient(scene);
    return formatted("it is too dark: the largest channel is %.3g of 1", tally.brightest);
}

std::vector<PixelPlace> pixelsThatHit(const Renderer& renderer, RenderOptions options) {
    options.pass = Pass::Normals;
    HitFinder hits(options.size);
    renderer.render(options, hits);
    return hits.found();
}

}  // namespace

bool isAllBlack(const ByteImage& image) {
    return std::ranges::all_of(image.pixels, [](std::uint8_t byte) { return byte == 0; });
}

bool isAllBlack(const FloatImage& image) {
    return std::ranges::all_of(image.pixels, [](float value) { return value <= 0; });
}

std::string whyBlack(const SceneDescription& scene, const Renderer& renderer, const RenderOptions& options) {
    const std::string black = "the picture is all black: ";
    if (scene.shapes.empty()) return black + "the scene has no shapes";
    if (scene.lights.empty()) return black + "the scene has no lights";
    RenderOptions centres = options;
    centres.samples = 1;
    centres.adaptive = 0;
    const std::vector<PixelPlace> pixels = pixelsThatHit(renderer, centres);
    if (pixels.empty()) return black + "no ray through a pixel's centre hits a shape";
    Tally tally;
    for (const PixelPlace& pixel : pixels) {
        const RayExplanation explanation = renderer.explain(centres, pixel.x, pixel.y);
        if (&pixel == &pixels.front() && scene.shapes[explanation.shape].type != ShapeType::Plane)
            tally.around = explanation.shape;
        if (explanation.entering || explanation.shape != tally.around) tally.around.reset();
        tally.add(explanation);
        tally.brightest = std::max(tally.brightest, brightest(explanation.color));
    }
    return black + reason(tally, scene);
}

}  // namespace raytracer
