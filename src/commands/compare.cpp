// raytracer compare A B: measures how much two pictures differ.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "arguments.h"
#include "raytracer/commands/commands.h"
#include "raytracer/grading/compare.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

constexpr const char* compareFooter =
    R"(Pictures are PNG or JPEG files, of 8 or 16 bits a channel, grey or in colour,
or PFM (linear float32). Alpha is ignored.

What the numbers mean:
  score    the course autograder's: each pixel is compared with the 3 x 3 pixels
           around it in the other picture, so an edge may be off by one pixel;
           100 - 1000 / 255 times the mean of these differences, rounded
  speckle  isolated pixels that only one of the pictures has; a few do not lower
           the score
  PSNR     20 log10(255 / RMSE); above about 50 dB nobody sees the difference
  In PFM pictures mean, RMSE and maximum are of the linear floats (PSNR: of
  1 / RMSE), the rest of the bytes that the floats would be in a PNG. A NaN
  is infinitely far from any number; JSON has null for infinite.

Exit status: 0 the same; 1 not the same; 2 they can't be compared (missing,
broken, different sizes). Without an option, the same means that no pixel
differs.

Examples:
  raytracer compare mine.png reference.png
  raytracer compare mine.png reference.png --diff difference.png
  # at most 3 pixels off by more than 1
  raytracer compare mine.png reference.png --tolerance 1 --max-pixels 3
  # as the autograder sees it
  raytracer compare mine.png reference.png --min-score 95
  # for a script to read
  raytracer compare mine.pfm reference.pfm --json)";

struct CompareArguments {
    std::string a, b, diff;
    bool json = false, quiet = false;
    Thresholds thresholds;

    void addTo(CommandLine& line) {
        line.text("A", a, "A picture: PNG, JPEG or PFM", ArgumentKind::Picture);
        line.text("B", b, "A picture of the same size", ArgumentKind::Picture);
        line.output("--diff", diff,
                    "Write the difference as a picture: black where equal, 64 + 8 d where off by d",
                    ArgumentKind::Picture);
        line.flag("--json", json, "Print the numbers as JSON");
        addThresholds(line, thresholds);
        addSilence(line, quiet);
        line.exclude("--json", {"--quiet"});
        line.footer(compareFooter);
    }
};

void printJson(const Comparison& c, bool same) {
    JsonWriter json;
    json.beginObject();
    json.key("width").value(c.width);
    json.key("height").value(c.height);
    json.key("differing").value(c.pixelsOver(0));
    json.key("differing_by_more_than_1").value(c.pixelsOver(1));
    json.key("differing_by_more_than_8").value(c.pixelsOver(8));
    json.key("mean").value(c.mean);
    json.key("rmse").value(c.rmse);
    json.key("psnr").value(c.psnr);  // null: infinite, as of equal pictures
    json.key("maximum").value(c.maximum);
    json.key("worst").values(std::array{c.worstX, c.worstY});
    json.key("score").value(c.score);
    json.key("speckle").value(c.speckle);
    json.key("within").value(same);
    json.endObject();
    print(json.text() + "\n");
}

std::string countLine(const char* name, std::uint64_t count, const Comparison& c) {
    const double pixels = static_cast<double>(c.width) * c.height;
    return formatted("  %-20s %10llu  (%.3g %%)\n", name, static_cast<unsigned long long>(count),
                     100 * static_cast<double>(count) / pixels);
}

std::string psnrLine(double psnr) {
    if (std::isinf(psnr)) return formatted("  %-20s %10s\n", "PSNR", psnr > 0 ? "infinite" : "-infinite");
    return formatted("  %-20s %10.4g dB\n", "PSNR", psnr);
}

void printText(const Comparison& c) {
    print(formatted("%d x %d pixels\n", c.width, c.height) +
          countLine("pixels that differ", c.pixelsOver(0), c) +
          countLine("by more than 1", c.pixelsOver(1), c) + countLine("by more than 8", c.pixelsOver(8), c) +
          countLine("speckle", c.speckle, c) +
          formatted("  %-20s %10.6g\n  %-20s %10.6g\n", "mean", c.mean, "RMSE", c.rmse) + psnrLine(c.psnr) +
          formatted("  %-20s %10.6g  at (%d, %d)\n", "maximum", c.maximum, c.worstX, c.worstY) +
          formatted("  %-20s %10d\n", "score", c.score));
}

std::string colorAt(const Picture& picture, const Comparison& c) {
    if (const auto* floats = std::get_if<FloatImage>(&picture)) {
        const float* const p = floats->at(c.worstX, c.worstY);
        return formatted("(%.6g, %.6g, %.6g)", static_cast<double>(p[0]), static_cast<double>(p[1]),
                         static_cast<double>(p[2]));
    }
    return rgbInWords(std::get<ByteImage>(picture).at(c.worstX, c.worstY));
}

// Prints the verdict, and a command that tells why the worst pixel differs.
void printVerdict(const CompareArguments& arguments, const Picture& a, const Picture& b, const Comparison& c,
                  bool same) {
    if (c.maximum > 0)
        print(formatted("at (%d, %d): ", c.worstX, c.worstY) + colorAt(a, c) + " in " +
              printable(arguments.a) + ", " + colorAt(b, c) + " in " + printable(arguments.b) + "\n" +
              formatted("why: raytracer explain SCENE.json %d %d %d --picture ", c.worstX, c.worstY,
                        std::max(c.width, c.height)) +
              printable(inShellQuotes(arguments.a)) + "\n");
    print(c.maximum == 0         ? "the pictures are equal\n"
          : c.pixelsOver(0) == 0 ? "the pictures are the same, once their colours are bytes\n"
          : same                 ? "the pictures are the same, within the limits given\n"
                                 : "the pictures are not the same\n");
}

int comparePictures(const CompareArguments& arguments) {
    std::optional<OutputFile> diff;
    if (!arguments.diff.empty()) {
        if (!endsIn(arguments.diff, ".png"))
            throw Error({arguments.diff}, "expected a name that ends in .png");
        refuseInput(arguments.diff, std::array{arguments.a, arguments.b});
        diff.emplace(arguments.diff);
    }
    const Picture a = readPicture(arguments.a), b = readPicture(arguments.b);
    const ImageSize size = sizeOf(b), expected = sizeOf(a);
    if (size != expected)
        throw Error({arguments.b}, "expected " + inWords(expected) + " pixels, as in " + arguments.a +
                                       ", found " + inWords(size));
    const Comparison comparison = compareImages(a, b);
    const bool same = within(comparison, arguments.thresholds);
    if (diff) {
        const ByteImage difference = amplifiedDifference(toBytes(a, b), toBytes(b, a));
        writePng(std::move(*diff), difference);
    }
    if (arguments.json) printJson(comparison, same);
    else if (!arguments.quiet) {
        printText(comparison);
        printVerdict(arguments, a, b, comparison, same);
    }
    return same ? 0 : 1;
}

}  // namespace

int compare(int argc, char** argv) {
    CommandLine line("compare", "Says how much two pictures differ.");
    CompareArguments arguments;
    arguments.addTo(line);
    if (line.parse(argc, argv)) return 0;
    return comparePictures(arguments);
}

}  // namespace raytracer::commands
