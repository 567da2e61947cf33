// Text from numbers, and in which encoding text is.
#pragma once

#include <string>
#include <string_view>

namespace raytracer {

// What printf prints, of any length.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";  // of UTF-8, without meaning

// By its byte order mark, or by the zeros of two ASCII characters at its beginning (RFC 4627, section 3).
// Windows calls UTF-16 "Unicode".
bool isUtf16(std::string_view text);

}  // namespace raytracer
