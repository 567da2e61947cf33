#include "variant.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>

#include <glm/geometric.hpp>

#include "raytracer/pictures/picture.h"
#include "raytracer/util/memory.h"

namespace raytracer {

namespace {

void moveEye(CameraDescription& camera, double way) {
    constexpr double littleMore = 1e-9;  // than rounding; if the eye is in free space, hardly a byte changes
    const double size = glm::length(camera.eye) + std::abs(camera.focal_length);
    camera.eye += way * littleMore * size * glm::dvec3(1);
}

void otherNearest(SceneDescription& scene, RenderOptions&) {
    std::ranges::reverse(scene.shapes);
    moveEye(scene.camera, 1);
}

void otherSide(SceneDescription& scene, RenderOptions&) { moveEye(scene.camera, -1); }

// The edits of Variant::otherRoundings.
const Mistake roundings[] = {{.what = "", .hint = "", .edit = otherNearest},
                             {.what = "", .hint = "", .edit = otherSide}};

// What `make` returns; empty if it throws, for any reason but a lack of memory, which is no mistake's fault.
template <class Make>
auto ifPossible(const Make& make) -> std::optional<decltype(make())> {
    try {
        return make();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const OutOfMemory&) {
        throw;
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

}  // namespace

RenderedScene::RenderedScene(SceneDescription scene, const RenderOptions& options, Precision precision)
    : scene_(std::move(scene)),
      options_(options),
      renderer_(makeRenderer(scene_, precision, {.threads = 1})) {
    options_.threads = 1;
}

RayExplanation RenderedScene::explain(const PixelPlace& pixel) const {
    return renderer_->explain(options_, pixel.x, pixel.y);
}

RayExplanation RenderedScene::cast(const glm::dvec3& origin, const glm::dvec3& direction, int max_recursion) {
    if (!castScene_) castScene_ = copyOf(scene_);
    const glm::dvec3 apart = std::abs(direction.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    castScene_->camera = {
        .eye = origin, .look = direction, .up = glm::normalize(glm::cross(direction, apart))};
    RenderOptions options = options_;
    options.max_recursion = max_recursion;
    options.size = {1, 1};
    options.crop = {0, 0, 1, 1};
    return makeRenderer(*castScene_, renderer_->precision(), {.threads = 1})->explain(options, 0, 0);
}

Variant::Variant(std::vector<const Mistake*> mistakes, std::shared_ptr<RenderedScene> right)
    : mistakes_(std::move(mistakes)), right_(std::move(right)) {
    for (const Mistake* mistake : mistakes_)
        if (mistake->formula) mistake->formula(formula_);
}

Variant::Variant(Variant& a, Variant& b) : Variant({a.mistakes_[0], b.mistakes_[0]}, a.right_) {
    if (!(a.edits() && b.edits())) made_ = a.edits() ? a.made_ : b.made_;
}

bool Variant::edits() const {
    return std::ranges::any_of(mistakes_, [](const Mistake* mistake) { return bool(mistake->edit); });
}

bool Variant::isOfTrees() const {
    return std::ranges::any_of(mistakes_, [](const Mistake* mistake) { return bool(mistake->formula); });
}

std::span<const glm::dvec2> Variant::samples() const {
    static constexpr glm::dvec2 centre[] = {{0.5, 0.5}};
    for (const Mistake* mistake : mistakes_)
        if (!mistake->samples.empty()) return mistake->samples;
    return centre;
}

bool Variant::isPicture() const { return !isOfTrees() && samples().size() == 1; }

const std::shared_ptr<RenderedScene>& Variant::madeScene() {
    if (made_) return made_;
    if (!edits()) return made_ = right_;
    SceneDescription scene = copyOf(right_->scene());
    RenderOptions options = right_->options();
    for (const Mistake* mistake : mistakes_)
        if (mistake->edit) mistake->edit(scene, options);
    return made_ = std::make_shared<RenderedScene>(std::move(scene), options, right_->renderer().precision());
}

Rgb Variant::toBytes(glm::dvec3 color) const {
    ToByte toByte = raytracer::toByte;
    for (const Mistake* mistake : mistakes_) {
        if (mistake->color) color = mistake->color(color);
        if (mistake->toByte) toByte = mistake->toByte;
    }
    return {toByte(color.x), toByte(color.y), toByte(color.z)};
}

std::vector<glm::dvec3> Variant::colorsOf(const Pixels& pixels) {
    const auto places = samples();
    std::vector<glm::dvec2> points;
    for (const PixelPlace& pixel : pixels)
        for (const glm::dvec2& place : places) points.push_back(glm::dvec2(pixel.x, pixel.y) + place);
    std::vector<glm::dvec3> colors(points.size()), means(pixels.size(), glm::dvec3(0));
    const RenderedScene& scene = *madeScene();
    scene.renderer().renderPoints(scene.options(), points, colors);
    for (std::size_t i = 0; i < colors.size(); ++i)
        means[i / places.size()] += colors[i] / static_cast<double>(places.size());
    return means;
}

std::vector<std::optional<Rgb>> Variant::bytes(const Pixels& pixels, Trees& rightTrees) {
    const auto bytes = ifPossible([&] { return madeBytes(pixels, rightTrees); });
    return bytes.value_or(std::vector<std::optional<Rgb>>(pixels.size()));
}

std::vector<std::optional<Rgb>> Variant::madeBytes(const Pixels& pixels, Trees& rightTrees) {
    RenderedScene& scene = *madeScene();
    std::vector<std::optional<Rgb>> result(pixels.size());
    if (!isOfTrees()) {
        const std::vector<glm::dvec3> colors = colorsOf(pixels);
        for (std::size_t i = 0; i < colors.size(); ++i) result[i] = toBytes(colors[i]);
        return result;
    }
    Trees own;
    Trees& trees = made_ == right_ ? rightTrees : own;
    if (trees.empty()) {
        colorsOf(pixels);  // throws if the rays are too many: their trees would fill the memory
        Trees made;
        for (const PixelPlace& pixel : pixels) made.push_back(scene.explain(pixel));
        trees = std::move(made);
    }
    const CastRay cast = [&](const glm::dvec3& origin, const glm::dvec3& direction, int max_recursion) {
        return scene.cast(origin, direction, max_recursion);
    };
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto color = colorAnew(scene.scene(), trees[i], formula_, cast);
        if (color) result[i] = toBytes(*color);
    }
    return result;
}

// Makes bytes of each run of pixels at once: the colours of a whole picture are eight times as large.
class Variant::Sink final : public PixelSink {
  public:
    Sink(const Variant& variant, const ImageSize& size)
        : image(unsetImage<ByteImage>(size)), variant_(variant) {}
    void write(int x, int y, std::span<const glm::dvec3> colors) override {
        std::uint8_t* out = image.at(x, y);
        for (const glm::dvec3& color : colors) out = std::ranges::copy(variant_.toBytes(color), out).out;
    }
    ByteImage image;

  private:
    const Variant& variant_;
};

ByteImage Variant::picture() {
    const RenderedScene& scene = *madeScene();
    Sink sink(*this, scene.options().size);
    scene.renderer().render(scene.options(), sink);
    return std::move(sink.image);
}

std::optional<ByteImage> Variant::pictureIfAny() {
    return ifPossible([&] { return picture(); });
}

std::vector<Variant>& Variant::otherRoundings() {
    if (otherRoundings_.empty())
        for (const Mistake& rounding : roundings) {
            std::vector<const Mistake*> both = mistakes_;
            both.push_back(&rounding);
            otherRoundings_.emplace_back(std::move(both), right_);
        }
    return otherRoundings_;
}

}  // namespace raytracer
