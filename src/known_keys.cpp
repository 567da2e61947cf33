#include "known_keys.h"

#include <algorithm>

#include "nearest_name.h"

namespace raytracer {

namespace {
constexpr std::size_t mostWarnings = 20;  // what fits a terminal
}

void KnownKeys::check(JsonView object, std::span<const std::string_view> known) {
    for (const JsonView member : object.members()) {
        if (std::ranges::find(known, member.key()) != known.end()) continue;
        if (strict_ || warnings_.size() < mostWarnings) report(object, member.key(), known);
        else ++notShown_;
    }
}

void KnownKeys::report(JsonView object, std::string_view key, std::span<const std::string_view> known) {
    NearestName nearest(key);
    for (const std::string_view name : known) nearest.consider(name);
    const std::string message = "unknown key " + inQuotes(key) + nearest.question();
    if (strict_) object.fail(message);
    const std::string pointer = object.pointer();
    warnings_.push_back((pointer.empty() ? "" : ": " + pointer) + ": " + message);
}

std::vector<std::string> KnownKeys::warnings() const {
    std::vector<std::string> all = warnings_;
    if (notShown_ > 0) all.push_back(": " + std::to_string(notShown_) + " more unknown keys");
    return all;
}

}  // namespace raytracer
