#include "known_keys.h"

#include <algorithm>

#include "raytracer/json/nearest_name.h"
#include "raytracer/util/error.h"

namespace raytracer {

namespace {
constexpr std::size_t mostWarnings = 20;  // what fits a terminal
}

bool JsonObject::knows(std::string_view key) const { return std::ranges::find(known_, key) != known_.end(); }

JsonView JsonObject::operator[](std::string_view key) const {
    if (const auto member = find(key)) return *member;
    NearestName misspelled(key);
    for (const JsonView member : json_.members())
        if (!knows(member.key())) misspelled.consider(member.key());
    json_.fail("expected the key " + inQuotes(key) + ", found " +
               (misspelled.found() ? inQuotes(misspelled.name()) : "none"));
}

JsonObject KnownKeys::check(JsonView json, std::span<const std::string_view> known) {
    const JsonObject object(json, known);
    for (const JsonView member : json.members()) {
        if (object.knows(member.key())) continue;
        if (strict_ || warnings_.size() < mostWarnings) report(object, member.key());
        else ++notShown_;
    }
    return object;
}

void KnownKeys::report(const JsonObject& object, std::string_view key) {
    NearestName nearest(key);
    for (const std::string_view name : object.known()) nearest.consider(name);
    const std::string message = "unknown key " + inQuotes(key) + nearest.question();
    if (strict_) throw object.json().error(message);
    warnings_.emplace_back(object.json().error(message).what());
}

std::vector<std::string> KnownKeys::warnings(const std::string& path) const {
    std::vector<std::string> all = warnings_;
    if (notShown_ > 0) all.push_back(path + ": " + std::to_string(notShown_) + " more unknown keys");
    return all;
}

}  // namespace raytracer
