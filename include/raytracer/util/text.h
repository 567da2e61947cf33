// Formats, quotes, splits and measures text, and finds its encoding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

#if defined(__MINGW32__)
#define RAYTRACER_PRINTF gnu_printf  // C's format, not that of Windows' own library
#else
#define RAYTRACER_PRINTF printf
#endif
// The text that printf would print, of any length.
[[gnu::format(RAYTRACER_PRINTF, 1, 2)]] std::string formatted(const char* format, ...);

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";  // that of UTF-8

// "UTF-16" (which Windows calls "Unicode"), "UTF-32", or empty if the text is neither. It is recognised by
// its byte order mark, or by the zeros of ASCII characters at its beginning (RFC 4627, section 3).
std::string wideEncoding(std::string_view text);

// The first character of a UTF-8 text (RFC 3629). The text must not be empty.
struct Character {
    std::uint32_t code = 0;
    std::size_t size = 0;  // bytes; 0: not UTF-8
};
Character firstCharacter(std::string_view text);

// The number of bytes of that character; 0 if it is not UTF-8.
inline std::size_t utf8Bytes(std::string_view text) { return firstCharacter(text).size; }

// The same, but 0 also for a control character (those of U+0080 to U+009F too), for one that changes the
// direction of text, and for a code point that is no character.
std::size_t printableBytes(std::string_view text);

// The code point of the text's first character if a reader cannot see it or takes it for a space; else 0.
// Tabs and line ends do not count.
unsigned invisibleCharacter(std::string_view text);

// What follows the Unicode dash or minus at the text's beginning, which word
// processors put in place of "--" or "-". Empty if the text does not begin with one.
std::string_view behindLongDash(std::string_view text);

// The text as it may be shown on terminals, in tables and in pages. What printableBytes refuses becomes \xNN,
// byte by byte, except the characters in `kept`.
std::string printable(std::string_view text, std::string_view kept = {});

// A CSV field (RFC 4180) with the printable text. A spreadsheet would take a text that begins with one of
// =+-@ for a formula, so an apostrophe is put before it.
std::string csvField(std::string_view text);

// `text` as a JSON string, with its quotes. Escape sequences replace what JSON forbids in a string, what is
// not shown, and "<": so the result can stand in a <script>.
std::string jsonString(std::string_view text);

// `text` in quotes for a message, with what is not shown escaped, and shortened to at most `longest` bytes.
// 60 are enough for any name that people choose, and leave room on a terminal's line.
std::string inQuotes(std::string_view text, std::size_t longest = 60);

// A word for a POSIX shell's command line, in single quotes if it needs them.
std::string inShellQuotes(std::string_view word);

// Breaks the text at blanks into lines of at most `columns` columns. All
// lines but the first begin with `indent` blanks. `used` columns of the
// first line are taken already. A word that is too long gets its own line.
std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent, std::size_t used = 0);

// The parts of a text between separator characters, empty parts included.
std::vector<std::string> split(std::string_view text, std::string_view separators);

// The parts that are not empty, with `between` between each two.
std::string joined(const std::vector<std::string>& parts, std::string_view between);

// The text with each `what` in it replaced by `with`.
std::string replaced(std::string text, std::string_view what, std::string_view with);

// "a, b or c".
std::string listed(const std::vector<std::string>& names, const std::string& last = "or");

// The number of terminal columns that a UTF-8 text takes. An East Asian wide character or an emoji takes two,
// a combining mark none (src/util/characters.h). Several characters that are shown as one, as in flags and
// families, are counted one by one.
std::size_t columnCount(std::string_view text);

// Changes ASCII letters only.
std::string inLowerCase(std::string_view text);

// Whether a file's name ends with `ending`, ignoring the case of ASCII letters.
bool endsIn(std::string_view name, std::string_view ending);

}  // namespace raytracer
