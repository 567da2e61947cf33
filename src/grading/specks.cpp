#include "mistake_search.h"

#include <algorithm>
#include <cstdlib>

namespace raytracer {

namespace {

// These limits were measured at 160 px with the programs of test/grading/students.py:
// with acne on our 16 scenes; on four of them with mistakes that have no name (light
// that fades, more contrast, wider highlights, another camera).
//
// The least share of specks among all pixels. Acne: 0.9 to 12 %. The others: 0 to 0.03 %, except another
// camera, 0.6 to 3.5 %.
constexpr double leastSpecks = 0.003;
// The least share of wrong pixels that shadows and mirrors explain. Acne: 97 % or more (on textures 89 %,
// which is not named). Light that fades: up to 81 %. Another camera: 2 %.
constexpr double leastOfSpecks = 0.9;
// The least share of wrong pixels that are known. A pixel that shows glass is known only if shadows explain
// it: if few are known, all of them would be explained. Acne: 73 % or more in six scenes with glass, 24 % in
// one that shows little else.
constexpr double leastKnown = 0.25;

int offBy(const ByteImage& a, std::size_t pixelA, const ByteImage& b, std::size_t pixelB) {
    return largestDifference(&a.pixels[3 * pixelA], &b.pixels[3 * pixelB]);
}

// A speck is a wrong pixel where the right picture is smooth, with an error like that of at most three
// neighbours. At a straight border between a wrong area and a right one, five neighbours are alike.
bool isSpeck(const ByteImage& picture, const ByteImage& right, std::size_t pixel) {
    constexpr int similar = 8;  // as for speckleCount (compare.h)
    const int off = offBy(picture, pixel, right, pixel);
    const int x = static_cast<int>(pixel) % right.width, y = static_cast<int>(pixel) / right.width;
    int alike = 0, steepest = 0;
    for (int ny = std::max(0, y - 1); ny <= std::min(right.height - 1, y + 1); ++ny)
        for (int nx = std::max(0, x - 1); nx <= std::min(right.width - 1, x + 1); ++nx) {
            const std::size_t neighbour =
                static_cast<std::size_t>(ny) * static_cast<std::size_t>(right.width) +
                static_cast<std::size_t>(nx);
            if (neighbour == pixel) continue;
            alike += std::abs(offBy(picture, neighbour, right, neighbour) - off) <= similar;
            steepest = std::max(steepest, offBy(right, pixel, right, neighbour));
        }
    return off > similar && steepest <= similar && alike <= 3;
}

// A camera ray, its reflection, the reflection's reflection and so on, up to glass or the last ray.
std::vector<const RayExplanation*> mirrorsOf(const SceneDescription& scene, const RayExplanation& tree) {
    std::vector<const RayExplanation*> mirrors;
    const RayExplanation* ray = &tree;
    for (; ray->hit && !materialOf(scene, ray->shape).refractive && !ray->rays.empty();
         ray = &ray->rays.front())
        mirrors.push_back(ray);
    return mirrors;
}

using Colors = std::vector<glm::dvec3>;

// Collects what shadows could take away from the pixel: the
// lights' shares that are not black, the largest first.
void collectLit(const RayExplanation& ray, const RayExplanation* end, Colors& lit) {
    constexpr std::size_t most = 6;  // 2^6 = 64 ways to shadow them
    for (const LightExplanation& light : ray.lights) {
        const glm::dvec3 share = ray.weight * (light.diffuse + light.specular) * light.S_L;
        if (share != glm::dvec3(0)) lit.push_back(share);
    }
    if (&ray != end)
        for (const RayExplanation& next : ray.rays) collectLit(next, end, lit);
    std::ranges::sort(lit, std::greater(),
                      [](const glm::dvec3& share) { return share.x + share.y + share.z; });
    if (lit.size() > most) lit.resize(most);
}

// A pixel, compared with the colours that it has if secondary rays hit the surface that they leave.
class AcnePixel {
  public:
    AcnePixel(const SceneDescription& scene, const RayExplanation& tree, const std::uint8_t* bytes)
        : scene_(scene), tree_(tree), bytes_(bytes) {}

    // Whether some shadow rays do.
    bool hasShadows() const { return isLike(tree_.color, litUpTo(nullptr)); }

    // Whether a reflected ray does, and perhaps some shadow rays. Seen from inside, the surface has only
    // ambient light. It reflects the ray on inside the body, whose far side is the same again.
    bool isReflectedHere(bool shadows) const {
        for (const RayExplanation* mirror : mirrorsOf(scene_, tree_)) {
            const Colors lit = shadows ? litUpTo(mirror) : Colors();
            const glm::dvec3 factor = materialOf(scene_, mirror->shape).color_reflect;
            glm::dvec3 ambient(0), weight = mirror->weight * factor;
            for (const LightExplanation& light : mirror->lights) ambient += light.ambient;
            glm::dvec3 color = tree_.color - weight * mirror->rays.front().color;
            for (int inside = mirror->max_recursion; inside > 0; --inside, weight *= factor) {
                color += weight * ambient;
                if (isLike(color, lit)) return true;
            }
        }
        return false;
    }

  private:
    Colors litUpTo(const RayExplanation* end) const {
        Colors lit;
        collectLit(tree_, end, lit);
        return lit;
    }

    // Whether the bytes are those of the colour, or of the colour without some of the lit shares.
    bool isLike(const glm::dvec3& whole, const Colors& lit) const {
        for (unsigned shadowed = 0; shadowed < 1u << lit.size(); ++shadowed) {
            glm::dvec3 color = whole;
            for (std::size_t i = 0; i < lit.size(); ++i)
                if (shadowed >> i & 1) color -= lit[i];
            const std::uint8_t made[] = {toByte(color.x), toByte(color.y), toByte(color.z)};
            if (largestDifference(made, bytes_) <= 1) return true;
        }
        return false;
    }

    const SceneDescription& scene_;
    const RayExplanation& tree_;
    const std::uint8_t* bytes_;
};

bool showsGlass(const SceneDescription& scene, const RayExplanation& ray) {
    if (ray.hit && materialOf(scene, ray.shape).refractive) return true;
    return std::ranges::any_of(ray.rays, [&](const RayExplanation& next) { return showsGlass(scene, next); });
}

constexpr const char* offset =
    "Is the secondary ray's origin moved by epsilon along its direction, so that it does not meet again the "
    "surface that it leaves?";

}  // namespace

std::optional<NamedMistake> specksIn(const ByteImage& picture, const ByteImage& right,
                                     std::span<const std::size_t> wrong, const SceneDescription& scene,
                                     const Sample& sample) {
    const auto specks =
        std::ranges::count_if(wrong, [&](std::size_t i) { return isSpeck(picture, right, i); });
    if (static_cast<double>(specks) < leastSpecks * static_cast<double>(picture.pixels.size()) / 3)
        return std::nullopt;
    std::size_t known = 0, shadows = 0, mirrors = 0, both = 0;
    for (std::size_t i = 0; i < sample.pixels.size(); ++i) {
        const AcnePixel pixel(scene, sample.trees[i], &picture.pixels[3 * sample.numbers[i]]);
        const bool isShadowed = pixel.hasShadows();
        if (!isShadowed && showsGlass(scene, sample.trees[i])) continue;
        const bool isReflected = pixel.isReflectedHere(false);
        ++known;
        shadows += isShadowed;
        mirrors += isReflected;
        both += isShadowed || isReflected || pixel.isReflectedHere(true);
    }
    const auto all = static_cast<double>(known);
    const auto named = [&](const char* what, std::size_t explained) {
        const Fit fit{.explained = static_cast<double>(explained) / all,
                      .sampled = known,
                      .unknown = sample.pixels.size() - known};
        return NamedMistake{fit, what, offset};
    };
    if (all < leastKnown * static_cast<double>(sample.pixels.size()) ||
        static_cast<double>(both) < leastOfSpecks * all)
        return std::nullopt;
    if (shadows == both) return named("with specks on lit surfaces (shadow acne)", shadows);
    if (mirrors == both) return named("with specks on mirrors (reflection acne)", mirrors);
    return named("with specks on lit surfaces and on mirrors (shadow and reflection acne)", both);
}

}  // namespace raytracer
