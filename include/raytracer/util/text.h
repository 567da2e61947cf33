// Text from numbers, text that can be shown, and in which encoding text is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

#if defined(__MINGW32__)
#define RAYTRACER_PRINTF gnu_printf  // C's, not that of Windows' own library
#else
#define RAYTRACER_PRINTF printf
#endif
// What printf prints, of any length.
[[gnu::format(RAYTRACER_PRINTF, 1, 2)]] std::string formatted(const char* format, ...);

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";  // of UTF-8, without meaning

// "UTF-16" (which Windows calls "Unicode"), "UTF-32" or nothing: by its byte order mark, or by the zeros of
// ASCII characters at its beginning (RFC 4627, section 3).
std::string wideEncoding(std::string_view text);

// What a text, which is not empty, begins with (RFC 3629).
struct Character {
    std::uint32_t code = 0;
    std::size_t size = 0;  // bytes; 0: not UTF-8
};
Character firstCharacter(std::string_view text);

// The bytes of that character; 0 where it is not UTF-8.
inline std::size_t utf8Bytes(std::string_view text) { return firstCharacter(text).size; }

// The same, and 0 where that is a control character (those of U+0080 to U+009F too), one that turns the
// direction of text, or no character.
std::size_t printableBytes(std::string_view text);

// The code point of the character that the text begins with, where that looks like a space but is none, or
// like nothing; else 0. Of the control characters, programs read tabs and ends of lines.
unsigned invisibleCharacter(std::string_view text);

// What is behind the dash (Unicode's, or its minus) that a text program makes of "--" or of "-"; empty where
// the text begins with none.
std::string_view behindLongDash(std::string_view text);

// The text as terminals, tables and pages may show it: what printableBytes refuses becomes \xNN, byte by
// byte, but for the characters in `kept`.
std::string printable(std::string_view text, std::string_view kept = {});

// A field of CSV (RFC 4180) that shows the text, as printable has it. A spreadsheet takes a text that begins
// with one of =+-@ for a formula; an apostrophe before it makes it text.
std::string csvField(std::string_view text);

// `text` in quotes, with escape sequences for what JSON forbids in a string, and for "<", so that the result
// can stand in a <script>.
std::string jsonString(std::string_view text);

// `text` in quotes with what is not shown escaped, for a message; shortened to so many bytes. 60 are enough
// for any name that people choose, and leave room on a terminal's line.
std::string inQuotes(std::string_view text, std::size_t longest = 60);

// A word of a command line as a POSIX shell takes it: in single quotes where it needs them.
std::string inShellQuotes(std::string_view word);

// The text in lines of at most so many columns, broken at blanks; all lines but the first begin with `indent`
// blanks. `used`: what the first line has already. A longer word has a line of its own.
std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent, std::size_t used = 0);

// The parts of a text between the characters that are separators, the empty ones too.
std::vector<std::string> split(std::string_view text, std::string_view separators);

// The parts that are not empty, with a text between each two.
std::string joined(const std::vector<std::string>& parts, std::string_view between);

// The text with other words for each `what` in it.
std::string replaced(std::string text, std::string_view what, std::string_view with);

// "a, b or c".
std::string listed(const std::vector<std::string>& names, const std::string& last = "or");

// How many columns of a terminal the text, of UTF-8, takes: two for an East Asian wide character or an emoji,
// none for a mark on the one before it (src/util/characters.h). Of several characters that are shown as one,
// as flags and families are, each counts.
std::size_t columnCount(std::string_view text);

// ASCII's letters; the others as they are.
std::string inLowerCase(std::string_view text);

// Whether a file's name ends so, in large or small letters (ASCII).
bool endsIn(std::string_view name, std::string_view ending);

}  // namespace raytracer
