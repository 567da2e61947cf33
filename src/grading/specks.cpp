#include "specks.h"

#include <algorithm>
#include <cstdlib>

namespace raytracer {

namespace {

// Of all pixels. Right programs differ at edges, which is no smooth place, and wrong areas have few corners.
constexpr double leastSpecks = 0.005;
constexpr double leastOfSpecks = 0.9;  // of the wrong pixels

int offBy(const ByteImage& a, std::size_t pixelA, const ByteImage& b, std::size_t pixelB) {
    return largestDifference(&a.pixels[3 * pixelA], &b.pixels[3 * pixelB]);
}

std::size_t indexIn(const ByteImage& image, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
}

// Calls visit(number) for the up to eight neighbours.
template <class Visit>
void forEachNeighbour(const ByteImage& image, std::size_t pixel, Visit visit) {
    const int x = static_cast<int>(pixel) % image.width, y = static_cast<int>(pixel) / image.width;
    for (int ny = std::max(0, y - 1); ny <= std::min(image.height - 1, y + 1); ++ny)
        for (int nx = std::max(0, x - 1); nx <= std::min(image.width - 1, x + 1); ++nx)
            if (nx != x || ny != y) visit(indexIn(image, nx, ny));
}

// A wrong pixel where the right picture is smooth, whose error is like that of three neighbours at most: at a
// straight border between a wrong area and a right one five are alike.
bool isSpeck(const ByteImage& picture, const ByteImage& right, std::size_t pixel) {
    constexpr int similar = 8;  // as for speckleCount (compare.h)
    const int off = offBy(picture, pixel, right, pixel);
    int alike = 0, steepest = 0;
    forEachNeighbour(right, pixel, [&](std::size_t neighbour) {
        alike += std::abs(offBy(picture, neighbour, right, neighbour) - off) <= similar;
        steepest = std::max(steepest, offBy(right, pixel, right, neighbour));
    });
    return off > similar && steepest <= similar && alike <= 3;
}

// What shadows could take away from the pixel: each light's share that is not black, the largest first.
void collectLit(const RayExplanation& ray, std::vector<glm::dvec3>& lit) {
    for (const LightExplanation& light : ray.lights) {
        const glm::dvec3 share = ray.weight * (light.diffuse + light.specular) * light.S_L;
        if (share != glm::dvec3(0)) lit.push_back(share);
    }
    for (const RayExplanation& next : ray.rays) collectLit(next, lit);
}

bool isInShadow(const ByteImage& picture, std::size_t pixel, const RayExplanation& tree) {
    constexpr std::size_t most = 6;  // 64 ways to shadow them
    std::vector<glm::dvec3> lit;
    collectLit(tree, lit);
    std::ranges::sort(lit, std::greater(),
                      [](const glm::dvec3& share) { return share.x + share.y + share.z; });
    if (lit.size() > most) lit.resize(most);
    for (unsigned shadowed = 1; shadowed < 1u << lit.size(); ++shadowed) {
        glm::dvec3 color = tree.color;
        for (std::size_t i = 0; i < lit.size(); ++i)
            if (shadowed >> i & 1) color -= lit[i];
        const std::uint8_t bytes[] = {toByte(color.x), toByte(color.y), toByte(color.z)};
        if (largestDifference(bytes, &picture.pixels[3 * pixel]) <= 1) return true;
    }
    return false;
}

bool sendsRays(const RayExplanation& ray) { return !ray.rays.empty(); }

constexpr const char* offset =
    "Is the secondary ray's origin moved by epsilon along its direction, so that it does not meet again the "
    "surface "
    "that it leaves?";

}  // namespace

std::optional<NamedMistake> specksIn(const ByteImage& picture, const ByteImage& right,
                                     std::span<const std::size_t> wrong, const SpeckSample& sample) {
    const auto specks =
        std::ranges::count_if(wrong, [&](std::size_t i) { return isSpeck(picture, right, i); });
    if (static_cast<double>(specks) < leastSpecks * static_cast<double>(picture.pixels.size()) / 3)
        return std::nullopt;
    std::size_t shadows = 0, mirrors = 0;
    for (std::size_t i = 0; i < sample.pixels.size(); ++i) {
        const std::size_t pixel = indexIn(picture, sample.pixels[i].x, sample.pixels[i].y);
        if (isInShadow(picture, pixel, sample.trees[i])) ++shadows;
        else mirrors += sendsRays(sample.trees[i]);
    }
    const auto all = static_cast<double>(sample.pixels.size());
    const double inShadow = static_cast<double>(shadows) / all,
                 onMirrors = static_cast<double>(mirrors) / all;
    const auto named = [&](const char* what, double explained) {
        return NamedMistake{what, offset, explained, sample.pixels.size()};
    };
    if (inShadow >= leastOfSpecks) return named("with specks on lit surfaces (shadow acne)", inShadow);
    if (onMirrors >= leastOfSpecks)
        return named("with specks on mirrors and glass (reflection acne)", onMirrors);
    if (inShadow + onMirrors < leastOfSpecks) return std::nullopt;
    return named("with specks on lit surfaces and on mirrors (shadow and reflection acne)",
                 inShadow + onMirrors);
}

}  // namespace raytracer
