// Mistakes on the way from a colour to its bytes.
#include <algorithm>
#include <cmath>

#include "mistake.h"
#include "raytracer/pictures/image.h"

namespace raytracer {

namespace {

glm::dvec3 channelwise(const glm::dvec3& color, double (*f)(double)) {
    const glm::dvec3 c = glm::clamp(color, 0.0, 1.0);
    return {f(c.x), f(c.y), f(c.z)};
}

// IEC 61966-2-1.
double toSrgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
double toGamma(double linear) { return std::pow(linear, 1 / 2.2); }
double fromGamma(double value) { return std::pow(value, 2.2); }
double squareRoot(double linear) { return std::sqrt(linear); }

// What is far above any byte wraps anywhere.
int whole(double value) { return static_cast<int>(std::clamp(value, 0.0, 1e9)); }

std::uint8_t wrapped(double channel) { return static_cast<std::uint8_t>(whole(255 * channel + 0.5) & 255); }
std::uint8_t wrappedAndCut(double channel) { return static_cast<std::uint8_t>(whole(255 * channel) & 255); }
std::uint8_t cut(double channel) { return static_cast<std::uint8_t>(whole(255 * std::min(channel, 1.0))); }
std::uint8_t of256(double channel) {
    return static_cast<std::uint8_t>(std::min(255, whole(256 * std::min(channel, 1.0))));
}

}  // namespace

void addByteMistakes(std::vector<Mistake>& mistakes) {
    const auto tone = [&](const char* what, const char* hint, double (*f)(double)) {
        mistakes.push_back(
            {.what = what, .hint = hint, .kind = "tone", .color = [f](const glm::dvec3& color) {
                 return channelwise(color, f);
             }});
    };
    const auto bytes = [&](const char* what, const char* hint, ToByte toByte) {
        mistakes.push_back({.what = what, .hint = hint, .kind = "bytes", .toByte = toByte});
    };
    const char* const linear = "The byte is 255 times the colour, without a gamma curve.";
    tone("with the gamma curve of sRGB applied", linear, toSrgb);
    tone("with a gamma of 2.2 applied", linear, toGamma);
    tone("with a gamma of 1 / 2.2 applied", linear, fromGamma);
    tone("with square roots of the colours", linear, squareRoot);
    mistakes.push_back({.what = "with red and blue exchanged",
                        .hint = "The bytes of a pixel are red, green, blue.",
                        .kind = "channels",
                        .color = [](const glm::dvec3& c) { return glm::dvec3(c.z, c.y, c.x); }});
    const char* const clamp = "Is the colour clamped to 1 before it becomes a byte?";
    bytes("without the clamp: bytes wrap", clamp, wrapped);
    bytes("without the clamp: bytes wrap, and are cut instead of rounded", clamp, wrappedAndCut);
    bytes("whose bytes are cut instead of rounded", "The byte is lround(255 c).", cut);
    bytes("whose bytes are 256 times the colour", "The byte is lround(255 c).", of256);
}

}  // namespace raytracer
