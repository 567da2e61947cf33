#include "known_keys.h"

#include <algorithm>

#include "foreign_keys.h"
#include "raytracer/util/nearest_name.h"

namespace raytracer {

namespace {
constexpr std::size_t mostWarnings = 20;  // what fits a terminal

// The first few keys, for a message.
std::string keysOf(std::span<const JsonView> members) {
    constexpr std::size_t most = 3;
    std::vector<std::string> keys;
    for (const JsonView member : members.first(std::min(most, members.size())))
        keys.push_back(inQuotes(member.key()));
    if (members.size() > most) keys.emplace_back("others");
    return listed(keys, "and");
}

}  // namespace

bool JsonObject::knows(std::string_view key) const { return std::ranges::find(known_, key) != known_.end(); }

JsonView JsonObject::operator[](std::string_view key) const {
    if (const auto member = find(key)) return *member;
    NearestName misspelled(key);
    std::vector<JsonView> unknown;
    for (const JsonView member : json_.members()) {
        if (knows(member.key())) continue;
        const ForeignKey* const other = foreignKey(member.key(), known_);
        const bool isThis = other && other->beside == key;
        if (isThis && !other->why.empty()) throw json_.errorAtKey(member, whyUnknown(member));
        if (other && !isThis) continue;
        misspelled.consider(member.key());
        unknown.push_back(member);
    }
    if (misspelled.found()) unknown = {*find(misspelled.name())};
    const std::string expected = "expected the key " + inQuotes(key) + ", found ";
    if (!unknown.empty()) throw json_.errorAtKey(unknown[0], expected + keysOf(unknown));
    if (const auto inside = findInside(key))
        throw json_.errorAtKey(*inside, expected + "it as " + inside->pointer());
    json_.fail(expected + "none");
}

// Finds a key that this object lacks in an object inside it, where a misplaced bracket may have put it.
// Strings do not count: many kinds of object have the same key with a string.
std::optional<JsonView> JsonObject::findInside(std::string_view key) const {
    for (const JsonView member : json_.members()) {
        if (member.kind() != JsonDocument::Kind::Object) continue;
        const auto inside = member.find(key);
        if (inside && inside->kind() != JsonDocument::Kind::String) return inside;
    }
    return {};
}

// A key that the object has already is not meant, except by --set, which replaces its value.
std::string JsonObject::meantBy(JsonView member) const {
    const auto mayBe = [&](std::string_view key) { return member.hasEditedKey() || !find(key); };
    if (const ForeignKey* const other = foreignKey(member.key(), known_))
        return other->why.empty() && mayBe(other->beside) ? std::string(other->beside) : "";
    NearestName nearest(member.key());
    for (const std::string_view name : known_)
        if (mayBe(name)) nearest.consider(name);
    return nearest.found() ? nearest.name() : "";
}

std::string JsonObject::whyUnknown(JsonView member) const {
    const std::string unknown = "unknown key " + inQuotes(member.key()), meant = meantBy(member);
    if (!meant.empty()) return unknown + "; did you mean " + inQuotes(meant) + "?";
    const ForeignKey* const other = foreignKey(member.key(), known_);
    if (!other) return unknown + ": delete it";
    if (!other->why.empty()) return unknown + ": " + std::string(other->why);
    return unknown + ": delete it, there is " + inQuotes(other->beside);
}

JsonObject KnownKeys::check(JsonView json, std::span<const std::string_view> known) {
    const JsonObject object(json, known);
    for (const JsonView member : json.members()) {
        if (object.knows(member.key())) continue;
        if (member.hasEditedKey()) throw object.json().errorAtKey(member, object.whyUnknown(member));
        if (warnings_.size() < mostWarnings) warn(object, member);
        else ++notShown_;
    }
    return object;
}

void KnownKeys::warn(const JsonObject& object, JsonView member) {
    Error error = object.json().errorAtKey(member, object.whyUnknown(member));
    warnings_.emplace_back(error.what());
    misnamed_.emplace(object.meantBy(member), std::move(error));
}

void KnownKeys::requireNamed(const std::string& key) const {
    const auto found = misnamed_.find(key);
    if (found != misnamed_.end()) throw found->second;
}

std::vector<std::string> KnownKeys::warnings(const std::string& path) const {
    std::vector<std::string> all = warnings_;
    if (notShown_ > 0) all.push_back(path + ": " + std::to_string(notShown_) + " more unknown keys");
    return all;
}

}  // namespace raytracer
