#include "foreign_text.h"

#include <algorithm>
#include <cctype>

#include "number_mistake.h"
#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// "% sun" and "; sun" are comments. The "%" of "40 % 3" is not, nor is the ";" of "1; 2" or "1; b: 2", which
// stands for a comma.
bool isCommentBySign(std::string_view text) {
    if (text.empty() || (text[0] != '%' && text[0] != ';')) return false;
    const std::size_t word = text.find_first_not_of(text[0] == '%' ? "% \t" : "; \t");
    const bool isWord = word != text.npos && std::isalpha(static_cast<unsigned char>(text[word]));
    return isWord && (text[0] == '%' || text.substr(0, text.find('\n')).find(':') == text.npos);
}

bool isComment(std::string_view text) {
    const bool isDashes = text.starts_with("--") && !isDigitAt(text, 2) && !text.substr(2).starts_with('.');
    return isDashes || text.starts_with("//") || text.starts_with("/*") || text.starts_with('#') ||
           text.starts_with("<!--") || isCommentBySign(text);
}

bool isConflict(std::string_view text) {
    return text.starts_with("<<<<<<< ") || text.starts_with("=======") || text.starts_with(">>>>>>> ");
}

bool isNoText(std::string_view text) {
    constexpr std::size_t most = 16;  // bytes; pictures and archives have a control character in fewer
    const auto isControl = [](unsigned char c) { return c < ' ' && c != '\t' && c != '\n' && c != '\r'; };
    return utf8Bytes(text) == 0 || std::ranges::any_of(text.substr(0, most), isControl);
}

// Whether one of the first lines is a vertex.
bool isObj(std::string_view text) {
    constexpr std::size_t most = 4096;  // bytes: comments and names may come first
    std::string_view rest = text.substr(0, most);
    for (; !rest.empty(); rest.remove_prefix(std::min(rest.find('\n'), rest.size() - 1) + 1)) {
        const std::size_t number = rest.starts_with("v ") ? rest.find_first_not_of(' ', 1) : rest.npos;
        if (number != rest.npos &&
            isNumber(rest.substr(number, rest.find_first_of(" \r\n", number) - number)))
            return true;
    }
    return false;
}

}  // namespace

std::string aboutForeign(std::string_view text) {
    if (isConflict(text)) return "a merge conflict: keep one of the versions";
    if (isComment(text)) return "a comment, which JSON does not have: delete it";
    if (!text.empty() && utf8Bytes(text) == 0) return "a byte that is no UTF-8: save the file as UTF-8";
    const unsigned code = invisibleCharacter(text);
    return code == 0 ? "" : formatted("an invisible character (U+%04X): delete it", code);
}

std::string aboutFormat(std::string_view text) {
    const std::string lower = inLowerCase(text.substr(0, text.find('\n')));
    const std::string expected = "expected a scene, found ";
    if (lower.starts_with("<!doctype html") || lower.starts_with("<html")) return expected + "a web page";
    if (lower.starts_with("<?xml")) return expected + "XML";
    if (lower.starts_with("%pdf-")) return expected + "a PDF";
    if (lower.starts_with("version https://git-lfs"))
        return expected + "a pointer of Git LFS: git lfs pull gets the file";
    if (!text.empty() && isNoText(text)) return "expected JSON, found what is no text";
    return isObj(text) ? expected + "an OBJ mesh" : "";
}

}  // namespace raytracer
