#include "raytracer/util/html.h"

#include <cstdint>

#include "raytracer/util/text.h"

namespace raytracer {

std::string escaped(std::string_view text) {
    std::string html;
    for (const char c : printable(text, "\n\t")) {
        switch (c) {
            case '&': html += "&amp;"; break;
            case '<': html += "&lt;"; break;
            case '>': html += "&gt;"; break;
            case '"': html += "&quot;"; break;
            case '\'': html += "&#39;"; break;
            default: html += c;
        }
    }
    return html;
}

std::string attribute(const char* name, std::string_view value) {
    return std::string(" ") + name + "=\"" + escaped(value) + "\"";
}

std::string pageHead(std::string_view title, std::string_view style) {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\">\n<title>" + escaped(title) +
           "</title>\n<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n" +
           std::string(style) + "</style></head>\n<body>\n";
}

std::string base64(std::span<const char> bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = i; j < i + 3; ++j)
            group = group << 8 | (j < bytes.size() ? static_cast<std::uint8_t>(bytes[j]) : 0u);
        for (int shift = 18; shift >= 0; shift -= 6) text += digits[group >> shift & 63];
    }
    const std::size_t padding = (3 - bytes.size() % 3) % 3;
    return text.replace(text.size() - padding, padding, padding, '=');
}

std::string pngUri(std::span<const char> png) { return "data:image/png;base64," + base64(png); }

}  // namespace raytracer
