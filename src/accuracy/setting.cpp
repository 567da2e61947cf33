#include "raytracer/accuracy/setting.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "raytracer/pictures/color_sink.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer {

RenderOptions withSetting(RenderOptions options, const Setting& setting) {
    static_cast<Setting&>(options) = setting;
    return options;
}

RenderedColors rendered(const Renderer& renderer, const RenderOptions& options) {
    ColorSink sink(options.crop);
    const RenderCounts counts = renderer.render(options, sink);
    return {std::move(sink).colors(), counts};
}

std::string shortNumber(double value) { return formatted("%.3g", value); }

double rounded(double value) { return numberOf<double>(shortNumber(value)).value(); }

std::string commandLine(const Setting& setting, Precision precision) {
    const Setting usual;
    std::string text;
    const auto add = [&](bool isUsual, const char* option, const std::string& value) {
        if (!isUsual) text += std::string(text.empty() ? "" : " ") + option + " " + value;
    };
    add(precision == Precision::Double, "--precision", precisionName(precision));
    add(setting.samples == usualSamples(setting.adaptive), "--samples", std::to_string(setting.samples));
    add(setting.adaptive == usual.adaptive, "--adaptive", shortNumber(setting.adaptive));
    add(setting.max_recursion == usual.max_recursion, "--max-recursion",
        std::to_string(setting.max_recursion));
    add(setting.cutoff == usual.cutoff, "--cutoff", shortNumber(setting.cutoff));
    add(setting.bilinear == usual.bilinear, "--texture-filter", "bilinear");
    return text.empty() ? "the defaults" : text;
}

std::vector<std::size_t> paretoFront(std::span<const CostAndError> points) {
    std::vector<std::size_t> order(points.size()), front;
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost
                                                : points[a].error < points[b].error;
    });
    double best = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (!(points[i].error < best)) continue;
        best = points[i].error;
        front.push_back(i);
    }
    return front;
}

}  // namespace raytracer
