// A scene as one or two mistakes change it, and its pixels.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mistake.h"
#include "raytracer/pictures/image.h"
#include "raytracer/tracer/renderer.h"

namespace raytracer {

// A scene with its renderer.
class RenderedScene {
  public:
    RenderedScene(SceneDescription scene, const RenderOptions& options, Precision precision);

    const SceneDescription& scene() const { return scene_; }
    const RenderOptions& options() const { return options_; }
    const Renderer& renderer() const { return *renderer_; }

    RayExplanation explain(const PixelPlace& pixel) const;
    // Casts any ray, as that through the only pixel of a camera placed at `origin`. Builds the scene anew.
    RayExplanation cast(const glm::dvec3& origin, const glm::dvec3& direction, int max_recursion);

  private:
    SceneDescription scene_;
    RenderOptions options_;
    std::unique_ptr<Renderer> renderer_;
    std::optional<SceneDescription> castScene_;  // scene_ with the camera of cast()
};

using Pixels = std::vector<PixelPlace>;
using Trees = std::vector<RayExplanation>;

class Variant {
  public:
    // `right` is the scene without a mistake.
    Variant(std::vector<const Mistake*> mistakes, std::shared_ptr<RenderedScene> right);
    Variant(Variant& a, Variant& b);  // both mistakes

    std::span<const Mistake* const> mistakes() const { return mistakes_; }
    bool edits() const;      // whether it edits the scene, which is then built anew
    bool isOfTrees() const;  // whether it is recomputed from ray trees, at a hundred times the cost
    bool isPicture() const;  // whether it costs no more than an ordinary picture

    // The pixels' bytes; empty where a ray tree does not determine them, and where no picture can be made: an
    // edit can leave a transform without an inverse, or double the rays with each bounce. `rightTrees` are
    // those of the scene without a mistake; they are made here if they are empty and needed.
    std::vector<std::optional<Rgb>> bytes(const Pixels& pixels, Trees& rightTrees);

    // Only if isPicture(). pictureIfAny is empty where no picture can be made, where picture throws.
    ByteImage picture();
    std::optional<ByteImage> pictureIfAny();

    // Only if isPicture(): the same mistakes, but rounding decides otherwise which of two surfaces in one
    // place is nearer, and whether an eye that lies on a surface sees it.
    std::vector<Variant>& otherRoundings();

  private:
    class Sink;

    const std::shared_ptr<RenderedScene>& madeScene();
    std::vector<std::optional<Rgb>> madeBytes(const Pixels& pixels, Trees& rightTrees);
    std::vector<glm::dvec3> colorsOf(const Pixels& pixels);
    std::span<const glm::dvec2> samples() const;
    Rgb toBytes(glm::dvec3 color) const;

    std::vector<const Mistake*> mistakes_;
    std::shared_ptr<RenderedScene> right_, made_;
    Formula formula_;
    std::vector<Variant> otherRoundings_;
};

}  // namespace raytracer
