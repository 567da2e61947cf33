#include "raytracer/util/text.h"

#include <cstdarg>
#include <cstdio>

namespace raytracer {

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

bool isUtf16(std::string_view text) {
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return true;
    if (text.size() < 4 || (text[0] == 0) != (text[2] == 0)) return false;
    return text[0] == 0 ? text[1] != 0 && text[3] != 0 : text[1] == 0 && text[3] == 0;
}

}  // namespace raytracer
