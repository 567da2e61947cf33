// Keys of other programs, and what to write instead.
#pragma once

#include <span>
#include <string_view>

namespace raytracer {

// In an object that may have the key `beside`, the foreign `key` means that one. Where there is a `why`, it
// says what to write instead.
struct ForeignKey {
    std::string_view key, beside, why{};
};

// The entry for a key, in upper or lower case, of an object with these known keys; null where there is none.
const ForeignKey* foreignKey(std::string_view key, std::span<const std::string_view> known);

}  // namespace raytracer
