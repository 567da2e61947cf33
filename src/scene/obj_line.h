// The lines of an OBJ file and the words of a line. A line that ends in a backslash goes on in the next,
// unless the backslash is in a comment (the end of a path, say).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace raytracer {

enum class ObjKeyword { position, texCoord, normal, face, other };

bool endsInBackslash(std::string_view physicalLine);

// Takes the first line from `text`, without its line end, and says in `physicalLines` how many it spans in
// the file.
std::string_view takeObjLine(std::string_view& text, std::size_t& physicalLines);

// Reads a line from left to right. Throws Error with the line's number.
class ObjLine {
  public:
    // Of a line whose keyword alone is asked for, path and number do not matter.
    explicit ObjLine(std::string_view line, std::string_view path = {}, std::size_t number = 0)
        : p_(line.data()), end_(p_ + line.size()), path_(path), number_(number) {}

    ObjKeyword keyword();
    // Skips blanks; a comment ends the line too.
    bool atEnd() {
        startWord();
        return p_ == end_ || *p_ == '#';
    }

    // A finite number, correctly rounded.
    double number();

    // A corner of a face as written: v, v/vt, v//vn or v/vt/vn; 0 stands for what is left out.
    struct Corner {
        std::int64_t position = 0, texCoord = 0, normal = 0;
    };
    Corner corner();

    [[noreturn]] void fail(const std::string& message) const;

  private:
    std::int64_t index();
    bool takeSlash() { return p_ != end_ && *p_ == '/' && ++p_; }
    // Inside a line, a line end is one that a backslash takes back.
    bool isAtBlank() const {
        return *p_ == ' ' || *p_ == '\t' || *p_ == '\r' || *p_ == '\n' || (*p_ == '\\' && isAtContinuation());
    }
    bool isAtContinuation() const;
    bool isAtWordEnd() const { return p_ == end_ || isAtBlank(); }
    void startWord() {
        while (p_ != end_ && isAtBlank()) ++p_;
        word_ = p_;
    }
    [[noreturn]] void failWord(const char* message) const;

    const char* p_;
    const char* end_;
    const char* word_ = nullptr;
    std::string_view path_;
    std::size_t number_;
};

}  // namespace raytracer
