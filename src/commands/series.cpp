#include "series.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "raytracer/json/json_edit.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"
#include "split_values.h"

namespace raytracer::commands {

namespace {

constexpr int lastFrame = 999999;

template <class Number>
struct Ends {
    std::optional<Number> from, to;
    explicit operator bool() const { return from && to; }
};

// The two ends of "a..b"; empty ones if the text is anything else.
template <class Number>
Ends<Number> endsOf(const std::string& text) {
    const std::size_t dots = text.find("..");
    if (dots == text.npos || text.substr(dots).starts_with("...")) return {};
    return {numberOf<Number>(text.substr(0, dots)), numberOf<Number>(text.substr(dots + 2))};
}

// The place of a {a..b} in a text, and its ends.
struct Span {
    std::size_t begin = 0, end = 0;
    Ends<double> ends{};
};

std::optional<Span> findRange(const std::string& text, std::size_t begin) {
    for (std::size_t open = begin; (open = text.find('{', open)) != text.npos; ++open) {
        const std::size_t close = text.find('}', open);
        if (close == text.npos) return std::nullopt;
        const auto ends = endsOf<double>(text.substr(open + 1, close - open - 1));
        if (!ends) continue;
        if (!std::isfinite(*ends.to - *ends.from))
            throw UsageError("--set " + text + ": a range has finite ends and a finite length");
        return Span{open, close + 1, ends};
    }
    return std::nullopt;
}

// Whether the pointer leads to a string: a name, a path and the like.
bool isOfText(std::string_view pointer) {
    static constexpr std::string_view keys[] = {"/name",      "/type", "/material",
                                                "/transform", "/path", "/diffuse_texture"};
    return pointer.starts_with("/textures/") ||
           std::ranges::any_of(keys, [&](std::string_view key) { return pointer.ends_with(key); });
}

// Whether the text between braces was probably meant as a range: "0-1", "0:1", "0..", "0...3", and with
// --frames "0,1". "0,0,4" is a list.
bool isNearRange(const std::string& inside, bool hasFrames) {
    if (inside.find_first_not_of("0123456789.,:;- ") != inside.npos) return false;
    if (inside.find_first_of("0123456789") == inside.npos) return false;
    const auto commas = std::ranges::count(inside, ',');
    if (commas > 0) return commas == 1 && hasFrames;
    const auto isSeparator = [](char c) {
        return std::string_view(":;- ").find(c) != std::string_view::npos;
    };
    return inside.find("..") != inside.npos || std::ranges::count_if(inside.substr(1), isSeparator) == 1;
}

// Whether the value, which is meant as numbers, has something that is meant as a range but is none: numbers
// between braces, or dots between numbers.
bool hasNearRange(const std::string& set, bool hasFrames) {
    const std::size_t equals = set.find('=');
    if (equals == set.npos || isOfText(std::string_view(set).substr(0, equals))) return false;
    std::string atSome = set;
    while (const auto range = findRange(atSome, equals))
        atSome.replace(range->begin, range->end - range->begin, "0");
    const std::string value = atSome.substr(equals + 1);
    if (value.empty() || readingOf(value).why.empty()) return false;
    for (std::size_t open = 0; (open = value.find('{', open)) != value.npos; ++open) {
        const std::size_t end = std::min(value.find_first_of("}]", open), value.size());
        if (isNearRange(value.substr(open + 1, end - open - 1), hasFrames)) return true;
    }
    return value.find("..") != value.npos && value.find_first_not_of("0123456789.-+") == value.npos;
}

// The place of the "%04d" in a name, and its width.
struct NumberPlace {
    std::size_t begin, end;
    int width;
};

std::optional<NumberPlace> frameNumberIn(const std::string& name) {
    const std::size_t percent = name.find('%'), d = name.find('d', percent);
    const bool isOne = percent != name.npos && d != name.npos && name.find('%', percent + 1) == name.npos;
    const std::string digits = isOne ? name.substr(percent + 1, d - percent - 1) : "x";
    const std::optional<int> width = digits.empty() ? 0 : numberOf<int>(digits);
    if (!width || *width < 0 || *width > 9 || (*width > 0 && digits[0] != '0')) return std::nullopt;
    return NumberPlace{percent, d + 1, *width};
}

}  // namespace

void addPartsAndFramesTo(CommandLine& line, std::string& part, std::string& frames) {
    line.text("--part", part,
              "Render the K-th of N parts of the picture, K/N, into the file IMAGE_OUT.part-K-of-N, for "
              "raytracer assemble; all parts take about the same time");
    line.shown("--part", "K/N");
    line.rejoins("--part", rejoinedList({"is K/N, no blanks", "/of", "/", 2, 2, isWholeNumber}));
    line.exclude("--part", {"--target-time"});
    line.text(
        "--frames", frames,
        "Render frames A..B; IMAGE_OUT has one %04d, for their number. In a --set, {a..b} is a number that "
        "runs from a at frame A to b at the one after B; write it in quotes: '/camera/eye/0={0..1}'");
    line.shown("--frames", "A..B");
    line.rejoins("--frames", rejoinedList({"is A..B, no blanks", ".to", "..", 2, 2, isWholeNumber}));
}

std::string pictureOptions(const RenderArguments& arguments, const RenderOptions& options) {
    std::string text;
    const auto add = [&](const std::string& option) { text += (text.empty() ? "--" : " --") + option; };
    add("max-recursion " + std::to_string(options.max_recursion));
    add("samples " + std::to_string(options.samples));
    add("adaptive " + shortestNumber(options.adaptive));
    add("cutoff " + shortestNumber(options.cutoff));
    add("texture-filter " + arguments.textureFilter);
    add("precision " + arguments.precision);
    add("pass " + arguments.pass);
    if (!arguments.only.empty()) add("only " + arguments.only);
    if (arguments.opaque) add("opaque");
    for (const std::string& set : arguments.sets) add("set " + set);
    return text;
}

PicturePart parsePart(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto number = numberOf<int>(text.substr(0, slash));
    const auto count = numberOf<int>(slash == text.npos ? "" : text.substr(slash + 1));
    if (!number || !count || *number < 1 || *number > *count || *count > mostParts)
        throw UsageError("--part: expected K/N, two whole numbers with 1 <= K <= N <= " +
                         std::to_string(mostParts) + ", found " + inQuotes(text));
    return {*number, *count};
}

std::string partName(const std::string& out, const PicturePart& part) {
    return out + ".part-" + std::to_string(part.number) + "-of-" + std::to_string(part.count);
}

PartHead partHead(const RenderArguments& arguments, const RenderOptions& options, const PicturePart& part,
                  const std::vector<std::string>& sceneFiles) {
    PartHead head;
    head.version = programVersion();
    head.scene = sceneChecksum(sceneFiles);
    head.options = pictureOptions(arguments, options);
    head.size = options.size;
    head.crop = options.crop;
    head.part = part;
    return head;
}

Frames parseFrames(const std::string& text) {
    const auto ends = endsOf<int>(text);
    if (!ends || *ends.from < 0 || *ends.to < *ends.from || *ends.to > lastFrame)
        throw UsageError("--frames: expected A..B, two whole numbers with 0 <= A <= B <= 999999, found " +
                         inQuotes(text));
    return {*ends.from, *ends.to};
}

std::string frameName(const std::string& name, int frame) {
    const auto place = frameNumberIn(name);
    if (!place) throw Error({name}, "expected a name with one %04d, for the frame's number");
    return name.substr(0, place->begin) + formatted("%0*d", place->width, frame) + name.substr(place->end);
}

std::string atFrame(const std::string& set, const Frames& frames, int frame) {
    const double part = static_cast<double>(frame - frames.first) / (frames.last - frames.first + 1);
    std::string value = set;
    for (std::size_t at = 0; const auto range = findRange(value, at);) {
        const double from = *range->ends.from, to = *range->ends.to;
        const std::string number = shortestNumber(from + (to - from) * part);
        value.replace(range->begin, range->end - range->begin, number);
        at = range->begin + number.size();
    }
    return value;
}

void refuseNearRanges(const std::vector<std::string>& sets, bool hasFrames) {
    for (const std::string& set : sets)
        if (hasNearRange(set, hasFrames)) throw UsageError("--set " + set + ": a range is {0..1}");
}

void refuseFrames(const std::string& out, const std::vector<std::string>& sets) {
    const auto place = frameNumberIn(out);
    if (place && place->width > 0)
        throw UsageError("the picture " + printable(out) + " needs --frames, for " +
                         out.substr(place->begin, place->end - place->begin));
    for (const std::string& set : sets)
        if (findRange(set, 0)) throw UsageError("--set " + set + ": a range needs --frames");
}

}  // namespace raytracer::commands
