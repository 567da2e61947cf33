#include "raytracer/util/text.h"

#include <algorithm>
#include <cctype>
#include <cstdarg>
#include <cstdio>

#include "characters.h"

namespace raytracer {

namespace {

const UnseenRange* unseenAt(std::uint32_t code) {
    const auto has = [&](const UnseenRange& range) { return range.codes.contains(code); };
    const auto* const found = std::ranges::find_if(unseen, has);
    return found == std::end(unseen) ? nullptr : found;
}

bool isShown(const Character& character) {
    const bool isNoCharacter = (character.code & 0xfffe) == 0xfffe;
    const UnseenRange* const range = unseenAt(character.code);
    const bool acts = range && (range->look == Unseen::Control || range->look == Unseen::Turning);
    return character.size > 0 && !isNoCharacter && !acts;
}

std::size_t columnsOf(std::uint32_t code) {
    const auto has = [&](const CodeRange& range) { return range.contains(code); };
    const UnseenRange* const range = unseenAt(code);
    const bool takesNone = range && (range->look == Unseen::Turning || range->look == Unseen::Nothing);
    if (takesNone || std::ranges::any_of(marks, has)) return 0;
    return std::ranges::any_of(wide, has) ? 2 : 1;
}

// The text's first character, or an escape sequence of JSON's if it is not shown. A byte that is not UTF-8
// becomes \xNN. JSON has no such escape sequence: there the byte is taken for Latin-1.
std::string escape(std::string_view text, const Character& character, bool isJson) {
    if (text[0] == '"' || text[0] == '\\') return {'\\', text[0]};
    if (text[0] == '\n') return "\\n";
    const auto [code, size] = character;
    const bool isEscaped = isJson && text[0] == '<';
    if (isShown(character) && !isEscaped) return std::string(text.substr(0, size));
    if (size == 0) return formatted(isJson ? "\\u%04x" : "\\x%02x", static_cast<unsigned char>(text[0]));
    if (code > 0xffff) return formatted("\\u%04x\\u%04x", 0xd7c0 + (code >> 10), 0xdc00 + (code & 0x3ff));
    return formatted("\\u%04x", code);
}

// The text in quotes: for JSON, or for a message.
std::string quoted(std::string_view text, bool isJson) {
    std::string quoted = "\"";
    while (!text.empty()) {
        const Character character = firstCharacter(text);
        quoted += escape(text, character, isJson);
        text.remove_prefix(std::max<std::size_t>(character.size, 1));
    }
    return quoted + '"';
}

}  // namespace

Character firstCharacter(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    if (lead < 0x80) return {lead, 1};
    const std::size_t size = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < size) return {};
    std::uint32_t code = lead & (0x7fU >> size);
    for (const char c : text.substr(1, size - 1)) {
        if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) return {};
        code = code << 6 | (static_cast<unsigned char>(c) & 0x3f);
    }
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};  // a smaller code is an overlong form
    const bool isSurrogate = code >> 11 == 0xd800 >> 11;
    if (code < least[size] || code > 0x10ffff || isSurrogate) return {};
    return {code, size};
}

std::size_t printableBytes(std::string_view text) {
    const Character character = firstCharacter(text);
    return isShown(character) ? character.size : 0;
}

unsigned invisibleCharacter(std::string_view text) {
    if (text.empty()) return 0;
    const std::uint32_t code = firstCharacter(text).code;
    const bool isRead = code == '\t' || code == '\n' || code == '\r';
    return unseenAt(code) && !isRead ? code : 0;
}

std::string_view behindLongDash(std::string_view text) {
    for (const std::string_view dash : {"\u2012", "\u2013", "\u2014", "\u2015", "\u2212"})
        if (text.starts_with(dash)) return text.substr(dash.size());
    return {};
}

std::string formatted(const char* format, ...) {
    va_list values, again;
    va_start(values, format);
    va_copy(again, values);
    std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, format, values)), '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    va_end(values);
    return text;
}

std::string wideEncoding(std::string_view text) {
    const auto hasZeros = [&](std::string_view pattern) {  // zeros exactly where the pattern has '0'
        return text.size() >= pattern.size() &&
               std::ranges::equal(text.substr(0, pattern.size()), pattern,
                                  [](char c, char zero) { return (c == 0) == (zero == '0'); });
    };
    using namespace std::string_view_literals;
    if (text.starts_with("\xff\xfe\0\0"sv) || hasZeros("x000") || hasZeros("000x")) return "UTF-32";
    if (text.starts_with("\0\0\xfe\xff"sv)) return "UTF-32";
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return "UTF-16";
    return hasZeros("x0x0") || hasZeros("0x0x") ? "UTF-16" : "";
}

std::string printable(std::string_view text, std::string_view kept) {
    std::string shown;
    while (!text.empty()) {
        const std::size_t good = kept.find(text[0]) != kept.npos ? 1 : printableBytes(text);
        if (good) shown += text.substr(0, good);
        else shown += formatted("\\x%02x", static_cast<unsigned char>(text[0]));
        text.remove_prefix(std::max<std::size_t>(good, 1));
    }
    return shown;
}

std::string csvField(std::string_view text) {
    std::string field = printable(text);
    if (!field.empty() && std::string_view("=+-@").find(field[0]) != std::string_view::npos)
        field.insert(0, 1, '\'');
    return field.find_first_of(",\"") == field.npos ? field : '"' + replaced(field, "\"", "\"\"") + '"';
}

std::string jsonString(std::string_view text) { return quoted(text, true); }

std::string inQuotes(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) return quoted(text, false);
    std::size_t end = longest;
    const auto isInCharacter = [](char c) {
        return (static_cast<unsigned char>(c) & 0xc0) == 0x80;
    };  // UTF-8
    while (end > 0 && isInCharacter(text[end])) --end;
    return quoted(text.substr(0, end), false) + "...";
}

std::vector<std::string> split(std::string_view text, std::string_view separators) {
    std::vector<std::string> parts;
    for (std::size_t start = 0, end = 0; end != text.npos; start = end + 1) {
        end = text.find_first_of(separators, start);
        parts.emplace_back(text.substr(start, end - start));
    }
    return parts;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
    std::string text;
    for (const std::string& part : parts)
        if (!part.empty()) text.append(text.empty() ? "" : between).append(part);
    return text;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
    for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
        text.replace(at, what.size(), with);
    return text;
}

std::string listed(const std::vector<std::string>& names, const std::string& last) {
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) list += i + 1 < names.size() ? ", " : " " + last + " ";
        list += names[i];
    }
    return list;
}

std::size_t columnCount(std::string_view text) {
    std::size_t columns = 0;
    while (!text.empty()) {
        const Character character = firstCharacter(text);
        columns += columnsOf(character.code);
        text.remove_prefix(std::max<std::size_t>(character.size, 1));
    }
    return columns;
}

std::string inShellQuotes(std::string_view word) {
    constexpr std::string_view plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=,@%+-";
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) return std::string(word);
    return "'" + replaced(std::string(word), "'", "'\\''") + "'";
}

std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent, std::size_t used) {
    std::string lines;
    for (std::size_t start = 0, end = 0; start < text.size(); start = end + 1) {
        end = std::min(text.find(' ', start), text.size());
        const std::string_view word = text.substr(start, end - start);
        const std::size_t width = columnCount(word);
        const bool isFirst = start == 0, fits = used + !isFirst + width <= columns;
        if (!isFirst) lines += fits ? " " : "\n" + std::string(indent, ' ');
        used = (fits ? used + !isFirst : indent) + width;
        lines += word;
    }
    return lines;
}

std::string inLowerCase(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower;
}

bool endsIn(std::string_view name, std::string_view ending) {
    return inLowerCase(name).ends_with(inLowerCase(ending));
}

}  // namespace raytracer
