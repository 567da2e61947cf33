// A pixel's samples and when it has enough of them, as plainly as they can be written, beside a plain tracer.
#pragma once

#include <numeric>
#include <vector>

#include "plain_tracer.h"
#include "raytracer/tracer/renderer.h"
#include "raytracer/tracer/sample_sequence.h"

namespace raytracer::plain {

// What a pixel's samples make of it, as README.md tells it.
class Pixels {
  public:
    Pixels(const SceneDescription& scene, int longEdge)
        : tracer_(scene), size_(imageSize(scene.camera, longEdge)) {
        for (int y = 0; y < size_.height; ++y)
            for (int x = 0; x < size_.width; ++x) centres_.push_back(colorsOf(x, y, 1).front());
    }

    ByteImage render(int samples) const {
        return bytes([&](int x, int y) { return mean(colorsOf(x, y, samples)); });
    }

    // `extra`: points where something small may be.
    ByteImage renderAdaptive(int samples, double adaptive, const std::vector<glm::dvec2>& extra) const {
        return bytes([&](int x, int y) {
            int n = 1;
            const double around = contrast(x, y, extra);
            while (n < samples && error(colorsOf(x, y, n), around) > adaptive)
                n = std::min(samples, n == 1 ? 4 : 2 * n);
            return mean(colorsOf(x, y, n));
        });
    }

  private:
    using Colors = std::vector<glm::dvec3>;

    Colors colorsOf(int x, int y, int samples) const {
        Colors colors;
        for (int i = 0; i < samples; ++i) {
            const glm::dvec2 point = glm::dvec2(x, y) + SampleSequence()[static_cast<std::uint32_t>(i)];
            colors.push_back(colorAt(point));
        }
        return colors;
    }

    glm::dvec3 colorAt(const glm::dvec2& point) const {
        return tracer_.colorAt(point / glm::dvec2(size_.width, size_.height));
    }

    static glm::dvec3 mean(const Colors& colors) {
        return std::accumulate(colors.begin(), colors.end(), glm::dvec3(0)) /
               static_cast<double>(colors.size());
    }

    double error(const Colors& colors, double contrast) const {
        const double n = static_cast<double>(colors.size()), weight = n == 1 ? 1 : std::pow(16 / n, 0.25);
        double ofSamples = 0, ofContrast = 0;
        for (int c = 0; c < 3; ++c) {
            const double middle = mean(colors)[c];
            double powers = 0;
            for (const glm::dvec3& color : colors) powers += std::pow(color[c] - middle, 4);
            const double deviation = n > 1 ? std::pow(powers / (n - 1), 0.25) : 0;
            ofSamples += std::pow(weight * shown(middle, deviation / std::pow(n, 0.75)), 2) / 3;
            ofContrast +=
                std::pow(weight * shown(std::clamp(middle, -16.0, 16.0), contrast / (4 * n)), 2) / 3;
        }
        const double hidden = std::min(1.0, 16 / std::sqrt(static_cast<double>(centres_.size())));
        return std::max(std::sqrt(std::max(ofSamples, ofContrast)), weight * hidden / (4 * n));
    }

    // The error as far as four times as much would show, once the value is clamped.
    static double shown(double value, double error) {
        const auto clamped = [](double x) { return std::clamp(x, 0.0, 1.0); };
        const double below = clamped(value) - clamped(value - 4 * error);
        const double above = clamped(value + 4 * error) - clamped(value);
        return std::min(error, std::max(below, above));
    }

    double contrast(int x, int y, const std::vector<glm::dvec2>& extra) const {
        glm::dvec3 least(16), most(-16);
        const auto see = [&](const glm::dvec3& color) {
            least = min(least, clamp(color, -16.0, 16.0));
            most = max(most, clamp(color, -16.0, 16.0));
        };
        for (int v = std::max(0, y - 1); v <= std::min(size_.height - 1, y + 1); ++v)
            for (int u = std::max(0, x - 1); u <= std::min(size_.width - 1, x + 1); ++u)
                see(centres_[static_cast<std::size_t>(v * size_.width + u)]);
        for (const glm::dvec2& point : extra)
            if (std::abs(std::floor(point.x) - x) <= 1 && std::abs(std::floor(point.y) - y) <= 1)
                see(colorAt(point));
        const glm::dvec3 range = most - least;
        return std::max({range.r, range.g, range.b});
    }

    template <class Color>
    ByteImage bytes(Color color) const {
        ByteImage image{size_, {}};
        for (int y = 0; y < size_.height; ++y)
            for (int x = 0; x < size_.width; ++x) {
                const glm::dvec3 shown = clamp(color(x, y), 0.0, 1.0);
                for (int i = 0; i < 3; ++i)
                    image.pixels.push_back(static_cast<std::uint8_t>(std::lround(255 * shown[i])));
            }
        return image;
    }

    Tracer tracer_;
    ImageSize size_;
    Colors centres_;
};

}  // namespace raytracer::plain
