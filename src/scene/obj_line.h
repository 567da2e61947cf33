// The lines of an OBJ file and the words of a line. A backslash at the end of a v, vt or f line, which blanks
// may follow, continues it in the next line. It does not in a comment or another line: these may end in a
// path. A comment may follow a word without a blank.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace raytracer {

enum class ObjKeyword { position, texCoord, face, other };

inline bool isObjBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool endsInBackslash(std::string_view physicalLine);

// Removes the first line from `text` and returns it without its line end. `physicalLines` is how many lines
// of the file it spans.
std::string_view takeObjLine(std::string_view& text, std::size_t& physicalLines);

// Reads a line from left to right. Throws Error with the line's number.
class ObjLine {
  public:
    // `path` and `number` are for errors; keyword() throws none.
    explicit ObjLine(std::string_view line, std::string_view path = {}, std::size_t number = 0)
        : p_(line.data()), end_(p_ + line.size()), path_(path), number_(number) {}

    ObjKeyword keyword() {
        startWord();
        skipWord();
        const std::string_view word(word_, p_);
        if (word == "v") return ObjKeyword::position;
        if (word == "f") return ObjKeyword::face;
        return word == "vt" ? ObjKeyword::texCoord : ObjKeyword::other;
    }
    // Skips blanks. A comment counts as the end.
    bool atEnd() {
        startWord();
        return p_ == end_ || *p_ == '#';
    }

    // How many words are left; moves behind them.
    std::size_t words() {
        std::size_t count = 0;
        for (; !atEnd(); ++count) skipWord();
        return count;
    }

    // A finite number, correctly rounded.
    double number();

    // A corner of a face as written: v, v/vt, v//vn or v/vt/vn, where what follows a slash may be missing. 0:
    // left out. A normal may be any whole number, since normals are ignored.
    struct Corner {
        std::int64_t position = 0, texCoord = 0;
    };
    Corner corner() {
        startWord();
        const std::int64_t position = index();
        return isAtWordEnd() ? Corner{.position = position} : textured(position);
    }

    [[noreturn]] void fail(const std::string& message) const;

  private:
    Corner textured(std::int64_t position);
    std::int64_t index() {
        const char* const begin = p_;
        const std::int64_t value = wholeNumber();
        if (value == 0) failIndex({begin, p_});
        return value;
    }
    std::int64_t wholeNumber();
    bool takeSlash() {
        const bool isSlash = p_ != end_ && *p_ == '/';
        p_ += isSlash;
        return isSlash;
    }
    // A line end within a line comes after a backslash.
    bool isAtBlank() const { return isObjBlank(*p_) || *p_ == '\n' || (*p_ == '\\' && isAtContinuation()); }
    bool isWindowsNumber() const;
    bool isAtContinuation() const;
    bool isAtWordEnd() const { return p_ == end_ || (!isPlain(*p_) && (isAtComment() || isAtBlank())); }
    // Windows writes 1.#INF, 1.#IND, 1.#QNAN and 1.#SNAN for what is no finite number.
    bool isAtComment() const { return *p_ == '#' && !isWindowsNumber(); }
    // A fast test: true of most characters of words, never of a blank or the start of a comment or
    // continuation.
    static bool isPlain(char c) { return c > '#' && c != '\\'; }
    void skipWord() {
        while (!isAtWordEnd()) ++p_;
    }
    void startWord() {
        while (p_ != end_ && !isPlain(*p_) && isAtBlank()) ++p_;
        word_ = p_;
    }
    [[noreturn]] void failIndex(std::string_view written) const;
    [[noreturn]] void failWord(const char* message) const;

    const char* p_;
    const char* end_;
    const char* word_ = nullptr;
    std::string_view path_;
    std::size_t number_;
};

}  // namespace raytracer
