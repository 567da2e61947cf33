// The page: every scene's chart, front, pictures and arithmetic.
#include "page.h"
#include "raytracer/accuracy/tradeoff_report.h"
#include "raytracer/util/html.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

// Lines may break between options, never within one.
std::string optionsOf(const Setting& setting, Precision precision = Precision::Double) {
    return "<code>" + replaced(escaped(commandLine(setting, precision)), " --", "</code> <code>--") +
           "</code>";
}

std::string tableRow(const Trial& trial, double plain) {
    return formatted("<tr><td>%.4f</td><td>%.2f</td><td>%.2e</td><td>%.1f</td><td>%.2e</td><td>%.2f</td><td>",
                     trial.seconds(), trial.seconds() / plain, trial.error.rmse, trial.error.psnr,
                     trial.error.maximum, 100 * trial.error.shareOff) +
           optionsOf(trial.setting, trial.precision) + "</td></tr>\n";
}

template <class Wanted>
std::string table(const SceneTradeoff& scene, std::span<const Trial> trials, Wanted wanted) {
    std::string html = accuracy_page::table;
    for (const Trial& trial : trials)
        if (wanted(trial)) html += tableRow(trial, defaultSeconds(scene));
    return html + "</tbody></table></div>\n";
}

std::string image(const char* kind, const std::string& alt, const ByteImage& picture) {
    return std::string("<img class=\"") + kind + "\" alt=\"" + alt + "\" src=\"" +
           pngUri(encodePng(picture)) + "\">";
}

std::string figure(char letter, const Exhibit& exhibit) {
    return "<figure><div>" + image("swap", "the picture", exhibit.picture) +
           image("difference", "its difference from the reference, magnified", exhibit.difference) +
           formatted("</div><figcaption><b>%c</b> RMSE %.1e, %.3g%% off: ", letter, exhibit.error.rmse,
                     100 * exhibit.error.shareOff) +
           optionsOf(exhibit.setting) + "</figcaption></figure>\n";
}

std::string pictures(const SceneTradeoff& scene) {
    std::string html =
        formatted("<h3>Examples of such errors (right: the difference from the reference, %g times)</h3>\n",
                  exhibitMagnification) +
        "<div class=\"pictures\">\n<figure><div>" +
        image("reference", "the reference", scene.referencePicture) +
        "</div><figcaption><b>the reference</b></figcaption></figure>\n";
    char letter = 'A';
    for (const Exhibit& exhibit : scene.exhibits) html += figure(letter++, exhibit);
    return html + "</div>\n";
}

std::string section(const SceneTradeoff& scene) {
    return "<section id=\"" + escaped(scene.name) + "\"><h2>" + escaped(scene.name) +
           "</h2>\n<p class=\"about\">" + escaped(describeReference(scene)) +
           "</p>\n<div class=\"both\"><div>" + tradeoffChart(scene) + "</div><div>" +
           table(scene, scene.truncation, [](const Trial& trial) { return trial.onFront; }) +
           "</div></div>\n" + pictures(scene) +
           "<h3>The error of the arithmetic: the same samples, against extended precision</h3>\n" +
           table(scene, scene.arithmetic, [](const Trial&) { return true; }) + "</section>\n";
}

}  // namespace

std::string tradeoffPage(std::span<const SceneTradeoff> scenes) {
    std::string html =
        pageHead("Speed for accuracy", std::string(accuracy_page::colors) + "\n" + accuracy_page::chart +
                                           "\n" + accuracy_page::style) +
        "<header class=\"head\"><h1>Speed for accuracy</h1>\n" + accuracy_page::introduction + "<nav>";
    for (const SceneTradeoff& scene : scenes)
        html += "<a href=\"#" + escaped(scene.name) + "\">" + escaped(scene.name) + "</a>\n";
    html += "</nav></header>\n<main>\n";
    for (const SceneTradeoff& scene : scenes) html += section(scene);
    return html + "</main>\n<div id=\"tip\"></div>\n<script>\n" + accuracy_page::script +
           "</script>\n</body>\n</html>\n";
}

}  // namespace raytracer
