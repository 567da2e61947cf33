#include "raytracer/grading/grade_report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "page.h"
#include "raytracer/util/html.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

std::string number(double value, const char* format = "%.4g") {
    if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
    return formatted(format, value);
}

std::string attribute(const char* name, const std::string& value) {
    return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

std::string percent(double part, int whole) { return number(100 * part / whole, "%.3f") + "%"; }

// A ring around the worst pixel, which is hard to see in a small picture.
std::string ring(const GradeResult& result) {
    const auto& c = result.comparison;
    if (!c || c->maximum == 0) return {};
    const std::string left = percent(c->worstX + 0.5, c->width), top = percent(c->worstY + 0.5, c->height);
    return "<i style=\"left:" + left + ";top:" + top + "\"></i>";
}

std::string picture(const char* kind, const std::string& png, const std::string& overlay = {}) {
    if (png.empty())
        return std::string("<div class=\"picture\"><span class=\"none\">no picture</span>") + kind +
               "</div>\n";
    return std::string("<button class=\"picture\" data-kind=\"") + kind + "\"><span><img alt=\"" + kind +
           "\" decoding=\"async\" src=\"" + pngUri(png) + "\">" + overlay + "</span>" + kind + "</button>\n";
}

std::string numberRow(const char* name, const std::string& value) {
    return std::string("<dt>") + name + "</dt><dd>" + value + "</dd>";
}

std::string numbers(const GradeResult& result) {
    std::string html = "<dl>";
    if (const auto& c = result.comparison) {
        html += numberRow("size", std::to_string(c->width) + " × " + std::to_string(c->height));
        html += numberRow("pixels off", std::to_string(c->pixelsOver(0)));
        html += numberRow("by over 1", std::to_string(c->pixelsOver(1)));
        html += numberRow("by over 8", std::to_string(c->pixelsOver(8)));
        html += numberRow("speckle", std::to_string(c->speckle));
        html += numberRow("mean", number(c->mean));
        html += numberRow("RMSE", number(c->rmse));
        html += numberRow("PSNR", number(c->psnr) + " dB");
        const std::string place =
            " at (" + std::to_string(c->worstX) + ", " + std::to_string(c->worstY) + ")";
        html += numberRow("maximum", number(c->maximum) + (c->maximum > 0 ? place : ""));
    }
    return html + numberRow("time", number(result.seconds, "%.2f") + " s") + "</dl>\n";
}

std::string message(const GradeResult& result) {
    std::string html;
    if (!result.message.empty()) html += "<p class=\"message\">" + escaped(result.message) + "</p>\n";
    if (!result.message.empty() && !result.output.empty())
        html += "<pre>" + escaped(result.output) + "</pre>\n";
    return html;
}

// For the script: what it sorts by and the pixel it shows.
std::string attributes(const GradeResult& result) {
    std::string html =
        attribute("data-name", result.test.name) + attribute("data-group", result.test.group) +
        attribute("data-score", std::to_string(result.score())) +
        attribute("data-error", number(result.comparison ? result.comparison->rmse : 256, "%.9g"));
    if (const auto& c = result.comparison)
        html += attribute("data-worst", std::to_string(c->worstX) + "," + std::to_string(c->worstY));
    return html;
}

// "near": different, but with a score of 100.
std::string verdict(const GradeResult& result, const Thresholds& thresholds) {
    if (within(result, thresholds)) return "same";
    return result.score() == 100 ? "near" : "off";
}

std::string card(const GradeResult& result, const Thresholds& thresholds) {
    return "<article class=\"" + verdict(result, thresholds) + "\"" + attributes(result) + ">\n<header><h3>" +
           escaped(result.test.name) + "</h3><output title=\"the autograder's score, of 100\">" +
           std::to_string(result.score()) + "</output></header>\n<div class=\"pictures\">" +
           picture("reference", result.referencePng) + picture("ours", result.ourPng) +
           picture("difference", result.differencePng, ring(result)) + "</div>\n" + numbers(result) +
           message(result) + "</article>\n";
}

using Group = std::vector<const GradeResult*>;

// Worst first, in each group and among the groups, which count by their worst member.
std::vector<Group> groupsOf(std::span<const GradeResult> results) {
    Group sorted;
    for (const GradeResult& result : results) sorted.push_back(&result);
    std::sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) { return isWorse(*a, *b); });
    std::vector<Group> groups;
    std::map<std::string, std::size_t> place;
    for (const GradeResult* result : sorted) {
        const auto [known, isNew] = place.emplace(result->test.group, groups.size());
        if (isNew) groups.emplace_back();
        groups[known->second].push_back(result);
    }
    return groups;
}

std::string summary(std::span<const GradeResult> results, const Thresholds& thresholds) {
    const auto good = std::count_if(results.begin(), results.end(),
                                    [&](const GradeResult& result) { return within(result, thresholds); });
    const double sum = std::accumulate(results.begin(), results.end(), 0.0,
                                       [](double total, const GradeResult& r) { return total + r.score(); });
    const double mean = results.empty() ? 0 : sum / static_cast<double>(results.size());
    return "<p class=\"summary\"><b>" + std::to_string(good) + "</b> of <b>" +
           std::to_string(results.size()) + "</b> pictures as the reference, mean score <b>" +
           number(mean, "%.1f") + "</b></p>\n";
}

}  // namespace

std::string gradeReport(std::span<const GradeResult> results, const Thresholds& thresholds,
                        const std::string& title) {
    std::string html = pageHead(title, grading_page::style) + "<header class=\"page\"><h1>" + escaped(title) +
                       "</h1>\n" + summary(results, thresholds) + grading_page::controls +
                       "</header>\n<main>\n";
    for (const Group& group : groupsOf(results)) {
        html += "<section><h2>" + escaped(group.front()->test.group) + "</h2>\n";
        for (const GradeResult* result : group) html += card(*result, thresholds);
        html += "</section>\n";
    }
    return html + "</main>\n" + grading_page::viewer + "<script>\n" + grading_page::script +
           "</script>\n</body>\n</html>\n";
}

}  // namespace raytracer
