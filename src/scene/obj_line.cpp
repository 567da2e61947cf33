#include "obj_line.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "raytracer/util/error.h"
#include "raytracer/util/number.h"

namespace raytracer {
bool endsInBackslash(std::string_view physicalLine) {
    std::size_t end = physicalLine.size();
    while (end > 0 && isObjBlank(physicalLine[end - 1])) --end;
    return end > 0 && physicalLine[end - 1] == '\\';
}

std::string_view takeObjLine(std::string_view& text, std::size_t& physicalLines) {
    std::size_t begin = 0, end = text.find('\n');
    const auto goesOn = [&] {
        const std::string_view line = text.substr(begin, end - begin);
        return end != text.npos && endsInBackslash(line) && line.find('#') == line.npos &&
               ObjLine(text.substr(0, end + 1)).keyword() != ObjKeyword::other;
    };
    for (physicalLines = 1; goesOn(); ++physicalLines) {
        begin = end + 1;
        end = text.find('\n', begin);
    }
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    return line;
}

double ObjLine::number() {
    if (atEnd()) fail("expected a number, found the end of the line");
    const char* const begin = p_ + (*p_ == '+' && end_ - p_ > 1 && p_[1] != '-');
    double value = 0;
    p_ = readNumber(begin, end_, value);
    if (p_ == begin || !isAtWordEnd()) failWord("expected a number, found ");
    if (!std::isfinite(value)) failWord("expected a finite number, found ");
    return value;
}

ObjLine::Corner ObjLine::textured(std::int64_t position) {
    Corner corner{.position = position};
    if (takeSlash()) {
        if (!isAtWordEnd() && *p_ != '/') corner.texCoord = index();
        if (takeSlash() && !isAtWordEnd()) wholeNumber();
    }
    if (!isAtWordEnd()) failWord("expected a corner as v, v/vt, v//vn or v/vt/vn, found ");
    return corner;
}

std::int64_t ObjLine::wholeNumber() {
    std::int64_t value = 0;
    const char* const begin = std::exchange(p_, readNumber(p_, end_, value));
    if (p_ == begin) failWord("expected a corner as v, v/vt, v//vn or v/vt/vn, found ");
    return value;
}

bool ObjLine::isWindowsNumber() const {
    const std::string_view behind(p_ + 1, end_);
    const auto begins = [&](std::string_view letters) { return behind.starts_with(letters); };
    return p_ != word_ && p_[-1] == '.' && (begins("IN") || begins("QNAN") || begins("SNAN"));
}

bool ObjLine::isAtContinuation() const {
    const std::string_view rest(p_ + 1, end_);
    const auto next = std::ranges::find_if_not(rest, isObjBlank);
    return next != rest.end() && *next == '\n';
}

void ObjLine::fail(const std::string& message) const {
    throw Error({.file = std::string(path_), .line = number_}, message);
}

// For an index that is 0, or that is read as 0 because it does not fit.
void ObjLine::failIndex(std::string_view written) const {
    const bool isZero = written.find_first_of("123456789") == written.npos;
    failWord(isZero ? "indices begin at 1 or -1, found " : "no mesh has such an index: ");
}

// The word may have any bytes and any length, since the file may be no OBJ at all.
void ObjLine::failWord(const char* message) const {
    constexpr std::size_t longest = 40;
    ObjLine rest(std::string_view(word_, end_));
    rest.skipWord();
    std::string word(word_, rest.p_);
    const bool isLong = word.size() > longest;
    word.resize(std::min(word.size(), longest));
    std::ranges::replace_if(
        word, [](char c) { return c < ' ' || c > '~'; }, '?');
    fail(message + ('"' + word) + (isLong ? "\"..." : "\""));
}

}  // namespace raytracer
