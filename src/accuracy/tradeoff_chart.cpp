// The charts: RMSE over processor seconds, both logarithmic.
#include <algorithm>
#include <cmath>
#include <limits>

#include "page.h"
#include "raytracer/accuracy/tradeoff_report.h"
#include "raytracer/util/html.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

// In SVG units.
constexpr double width = 420, height = 300, left = 46, right = 12, top = 12, bottom = 40;

// Maps positive numbers to a logarithmic axis of whole decades.
class LogAxis {
  public:
    LogAxis(double least, double most, double from, double to)
        : first_(static_cast<int>(std::floor(std::log10(least) + 0.02))),
          last_(std::max(first_ + 1, static_cast<int>(std::ceil(std::log10(most) - 0.02)))),
          from_(from),
          to_(to) {}

    int first() const { return first_; }
    int last() const { return last_; }
    double at(double value) const {
        return from_ + (to_ - from_) * std::clamp((std::log10(value) - first_) / (last_ - first_), 0.0, 1.0);
    }

  private:
    int first_, last_;  // exponents of ten
    double from_, to_;
};

struct Axes {
    LogAxis x, y;
};

// A range for a logarithmic axis. Zeros do not count; LogAxis::at puts them at the axis's lower end.
struct PositiveRange {
    double least = std::numeric_limits<double>::infinity(), most = 0;

    void add(double value) {
        if (value <= 0) return;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    LogAxis axis(double from, double to) const {
        return most > 0 ? LogAxis(least, most, from, to) : LogAxis(1, 1, from, to);
    }
};

Axes axesOf(const SceneTradeoff& scene) {
    PositiveRange errors, seconds;
    for (const Trial& trial : scene.truncation) {
        errors.add(trial.error.rmse);
        seconds.add(trial.seconds());
    }
    return {seconds.axis(left, width - right), errors.axis(height - bottom, top)};
}

// The label of 10^exponent. All labels of an axis have one notation.
std::string decade(int exponent, const LogAxis& axis) {
    if (axis.first() >= -3 && axis.last() <= 5) return formatted("%g", std::pow(10, exponent));
    return formatted("10<tspan dy='-4' font-size='8'>%d</tspan>", exponent);
}

std::string grid(const Axes& axes) {
    std::string svg;
    for (int e = axes.x.first(); e <= axes.x.last(); ++e) {
        const double x = axes.x.at(std::pow(10, e));
        svg += formatted("<path class='grid' d='M%.1f %.1fV%.1f'/>", x, top, height - bottom);
        svg +=
            formatted("<text class='tick' x='%.1f' y='%.1f' text-anchor='middle'>", x, height - bottom + 14) +
            decade(e, axes.x) + "</text>";
    }
    for (int e = axes.y.first(); e <= axes.y.last(); ++e) {
        const double y = axes.y.at(std::pow(10, e));
        svg += formatted("<path class='grid' d='M%.1f %.1fH%.1f'/>", left, y, width - right);
        svg += formatted("<text class='tick' x='%.1f' y='%.1f' text-anchor='end'>", left - 6, y + 4) +
               decade(e, axes.y) + "</text>";
    }
    svg += formatted("<text class='label' x='%.1f' y='%.1f' text-anchor='middle'>processor seconds</text>",
                     (left + width - right) / 2, height - 8);
    svg += formatted(
        "<text class='label' transform='translate(11 %.1f)rotate(-90)' text-anchor='middle'>RMSE</text>",
        (top + height - bottom) / 2);
    return svg + "\n";
}

// A line at the reference's doublingError, an upper bound on its own error.
std::string floorLine(const Axes& axes, const Reference& reference) {
    const double y = axes.y.at(reference.doublingError);
    if (!(reference.doublingError > 0) || y >= height - bottom) return {};
    return formatted(
        "<path class='floor' d='M%.1f %.1fH%.1f'><title>half of the reference's samples: RMSE %.1e "
        "against it</title></path>\n",
        left, y, width - right, reference.doublingError);
}

std::string rateLabel(const std::optional<double>& rate) {
    if (!rate) return {};
    return formatted(
        "<text class='label' x='%.1f' y='%.1f' text-anchor='end'>sampling error: samples"
        "<tspan dy='-4' font-size='8'>-%.2f</tspan></text>\n",
        width - right - 4, top + 14, *rate);
}

std::string point(const Axes& axes, const Trial& trial) {
    const char* kind = trial.setting == Setting{} ? "plain" : trial.onFront ? "front" : "other";
    return formatted("<circle class='%s' cx='%.1f' cy='%.1f' r='%s'><title>", kind,
                     axes.x.at(trial.seconds()), axes.y.at(trial.error.rmse),
                     trial.onFront || kind[0] == 'p' ? "3.5" : "2.2") +
           escaped(commandLine(trial.setting)) +
           formatted(
               "\n%.4g s, RMSE %.3g, maximum %.2g, %.2g%% of the pixels off by more than "
               "1/255</title></circle>\n",
               trial.seconds(), trial.error.rmse, trial.error.maximum, 100 * trial.error.shareOff);
}

std::string frontLine(const Axes& axes, std::span<const Trial> trials) {
    std::string path;
    for (const Trial& trial : trials)
        if (trial.onFront)
            path += formatted("%c%.1f %.1f", path.empty() ? 'M' : 'L', axes.x.at(trial.seconds()),
                              axes.y.at(trial.error.rmse));
    return "<path class='line' d='" + path + "'/>\n";
}

// The letters of the example pictures below the chart.
std::string letters(const Axes& axes, const SceneTradeoff& scene) {
    std::string svg;
    char letter = 'A';
    for (const Exhibit& exhibit : scene.exhibits)
        for (const Trial& trial : scene.truncation)
            if (trial.setting == exhibit.setting)
                svg += formatted("<text class='letter' x='%.1f' y='%.1f'>%c</text>",
                                 axes.x.at(trial.seconds()) + 5, axes.y.at(trial.error.rmse) - 5, letter++);
    return svg;
}

std::string chartBody(const SceneTradeoff& scene) {
    const Axes axes = axesOf(scene);
    std::string others, front;
    for (const Trial& trial : scene.truncation)
        (trial.onFront || trial.setting == Setting{} ? front : others) += point(axes, trial);
    return grid(axes) + rateLabel(scene.sampleRate) + floorLine(axes, scene.reference) + others +
           frontLine(axes, scene.truncation) + front + letters(axes, scene);
}

}  // namespace

std::string tradeoffChart(const SceneTradeoff& scene) {
    return formatted(
               "<svg class='chart' viewBox='0 0 %g %g' role='img' aria-label='RMSE over processor "
               "seconds'>\n",
               width, height) +
           chartBody(scene) + "</svg>\n";
}

std::string tradeoffSvg(std::span<const SceneTradeoff> scenes) {
    constexpr double title = 22;
    const std::size_t columns = std::min<std::size_t>(3, scenes.size()),
                      rows = (scenes.size() + columns - 1) / columns;
    std::string svg =
        formatted("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %g %g'><style>\n",
                  width * static_cast<double>(columns), (height + title) * static_cast<double>(rows)) +
        accuracy_page::colors + "\n" + accuracy_page::chart +
        "</style><rect width='100%' height='100%' fill='var(--card)'/>\n";
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const std::size_t column = i % columns, row = i / columns;
        svg += formatted("<g transform='translate(%g %g)'>", width * static_cast<double>(column),
                         (height + title) * static_cast<double>(row) + title);
        svg += formatted("<text class='title' x='%g' y='2'>", left) + escaped(scenes[i].name) + "</text>\n" +
               chartBody(scenes[i]) + "</g>\n";
    }
    return svg + "</svg>\n";
}

}  // namespace raytracer
