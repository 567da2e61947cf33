// Replaces mbrtowc by one that reads UTF-8. The manifest makes names UTF-8 for Windows, but the C library,
// msvcrt, has no UTF-8 locale, and libstdc++'s std::filesystem converts names to wide characters by mbrtowc.
// The linker puts this function in its place (--wrap).
#include <cerrno>
#include <cwchar>
#include <utility>

#include "raytracer/util/text.h"

namespace raytracer {
namespace {

constexpr std::size_t wrong = static_cast<std::size_t>(-1), incomplete = static_cast<std::size_t>(-2);

std::size_t bytesOf(unsigned char lead) { return lead < 0x80 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4; }

// A character beyond U+FFFF is two wide ones. The first takes all bytes but the last; the second is kept in
// `state`, and takes the last byte.
std::size_t wideFromUtf8(wchar_t* to, const char* from, std::size_t size, std::mbstate_t* state) {
    if (*state != 0) {
        *to = static_cast<wchar_t>(std::exchange(*state, 0));
        return 1;
    }
    const std::size_t bytes = bytesOf(static_cast<unsigned char>(*from));
    if (size < bytes) return incomplete;
    const Character character = firstCharacter({from, bytes});
    if (character.size != bytes) {
        errno = EILSEQ;
        return wrong;
    }
    const std::uint32_t code = character.code;
    if (bytes < 4) {
        *to = static_cast<wchar_t>(code);
        return code == 0 ? 0 : bytes;
    }
    *to = static_cast<wchar_t>(0xd7c0 + (code >> 10));
    *state = static_cast<std::mbstate_t>(0xdc00 + (code & 0x3ff));
    return bytes - 1;
}

}  // namespace
}  // namespace raytracer

extern "C" std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t size, std::mbstate_t* state);
std::size_t __wrap_mbrtowc(wchar_t* to, const char* from, std::size_t size, std::mbstate_t* state) {
    wchar_t ignored = 0;
    std::mbstate_t none = 0;
    if (!from) return 0;
    if (size == 0) return raytracer::incomplete;
    return raytracer::wideFromUtf8(to ? to : &ignored, from, size, state ? state : &none);
}
