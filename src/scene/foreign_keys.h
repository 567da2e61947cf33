// Keys that other programs have, and what is instead of them.
#pragma once

#include <span>
#include <string_view>

namespace raytracer {

// In an object that may have the key `beside`, that is what `key` means, or if there is one, `why` says what
// has its place.
struct ForeignKey {
    std::string_view key, beside, why{};
};

// The one for a key, in small or large letters, of an object with these known keys; null where there is none.
const ForeignKey* foreignKey(std::string_view key, std::span<const std::string_view> known);

}  // namespace raytracer
