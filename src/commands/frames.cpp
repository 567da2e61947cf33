#include "frames.h"

#include <cmath>
#include <optional>

#include "arguments.h"
#include "raytracer/json/json_document.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

constexpr int lastFrame = 999999;

template <class Number>
struct Ends {
    std::optional<Number> from, to;
    explicit operator bool() const { return from && to; }
};

// "a..b".
template <class Number>
Ends<Number> endsOf(const std::string& text) {
    const std::size_t dots = text.find("..");
    if (dots == text.npos || text.substr(dots).starts_with("...")) return {};
    return {numberOf<Number>(text.substr(0, dots)), numberOf<Number>(text.substr(dots + 2))};
}

// A {a..b} in a text.
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
            throw usageError("--set " + text + ": a range has finite ends and a finite length");
        return Span{open, close + 1, ends};
    }
    return std::nullopt;
}

// The "%04d" of a name, which has one.
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

Frames parseFrames(const std::string& text) {
    const auto ends = endsOf<int>(text);
    if (!ends || *ends.from < 0 || *ends.to < *ends.from || *ends.to > lastFrame)
        throw usageError("--frames: expected A..B, two whole numbers with 0 <= A <= B <= 999999, found " +
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

void refuseFrames(const std::string& out, const std::vector<std::string>& sets) {
    const auto place = frameNumberIn(out);
    if (place && place->width > 0)
        throw usageError("the picture " + printable(out) + " needs --frames, for " +
                         out.substr(place->begin, place->end - place->begin));
    for (const std::string& set : sets)
        if (findRange(set, 0)) throw usageError("--set " + set + ": a range needs --frames");
}

}  // namespace raytracer::commands
