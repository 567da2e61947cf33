// A scene as one or two mistakes have it, and its pixels.
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
    // Any ray: the one through the only pixel of a camera that stands there. Builds the scene anew.
    RayExplanation cast(const glm::dvec3& origin, const glm::dvec3& direction, int max_recursion);

  private:
    SceneDescription scene_;
    RenderOptions options_;
    std::unique_ptr<Renderer> renderer_;
    std::optional<SceneDescription> castScene_;  // scene_, of which the camera moves
};

using Pixels = std::vector<PixelPlace>;
using Trees = std::vector<RayExplanation>;

class Variant {
  public:
    // `right` is the scene without a mistake.
    Variant(std::vector<const Mistake*> mistakes, std::shared_ptr<RenderedScene> right);
    Variant(Variant& a, Variant& b);  // both mistakes

    std::span<const Mistake* const> mistakes() const { return mistakes_; }
    bool edits() const;      // the scene, which is then built anew
    bool isOfTrees() const;  // made anew from ray trees, at a hundred times the cost
    bool isPicture() const;  // made at the cost of a picture

    // The pixels' bytes; nothing where a ray tree does not tell, or where the rays are too many. `rightTrees`
    // are those of the scene without a mistake, made here where they are empty and needed.
    std::vector<std::optional<Rgb>> bytes(const Pixels& pixels, Trees& rightTrees);

    ByteImage picture();  // isPicture

    // isPicture: the same mistakes where rounding decides otherwise which of two surfaces in one place is
    // nearer, and whether an eye sees the surface that it lies on.
    std::vector<Variant>& otherRoundings();

  private:
    const std::shared_ptr<RenderedScene>& madeScene();
    std::vector<glm::dvec3> colorsOf(const Pixels& pixels);  // none where the rays are too many
    std::span<const glm::dvec2> samples() const;
    Rgb toBytes(glm::dvec3 color) const;

    std::vector<const Mistake*> mistakes_;
    std::shared_ptr<RenderedScene> right_, made_;
    Formula formula_;
    std::vector<Variant> otherRoundings_;
};

}  // namespace raytracer
