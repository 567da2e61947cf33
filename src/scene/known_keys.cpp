#include "known_keys.h"

#include <algorithm>

#include "raytracer/util/error.h"
#include "raytracer/util/nearest_name.h"

namespace raytracer {

namespace {
constexpr std::size_t mostWarnings = 20;  // what fits a terminal

// For a message, the first few of them.
std::string keysOf(std::span<const JsonView> members) {
    constexpr std::size_t most = 3;
    std::vector<std::string> keys;
    for (const JsonView member : members.first(std::min(most, members.size())))
        keys.push_back(inQuotes(member.key()));
    if (members.size() > most) keys.emplace_back("others");
    return listed(keys, "and");
}

// What other programs have, in an object that has the key `beside` in ours, and what is instead of it.
struct Foreign {
    std::string_view key, beside, instead;
};
constexpr Foreign foreign[] = {
    {"rotation", "rotate", "; did you mean \"rotate\"?"},
    {"angle", "degrees", "; did you mean \"degrees\"?"},
    {"scaling", "scale", "; did you mean \"scale\"?"},
    {"size", "scale", "; did you mean \"scale\"?"},
    {"position", "translate", "; did you mean \"translate\"?"},
    {"position", "eye", "; did you mean \"eye\"?"},
    {"texture", "diffuse_texture", "; did you mean \"diffuse_texture\"?"},
    {"use_texture", "use_diffuse_texture", "; did you mean \"use_diffuse_texture\"?"},
    {"color", "color_diffuse", "; did you mean \"color_diffuse\"?"},
    {"ior", "index_of_refraction", "; did you mean \"index_of_refraction\"?"},
    {"intensity", "color", "; did you mean \"color\"?"},
    {"fov", "film_left", ": focal_length and film_left to film_top give the angle"},
    {"radius", "transform", ": scale in its transform gives the size"},
    {"size", "transform", ": scale in its transform gives the size"},
    {"center", "transform", ": translate in its transform gives the place"},
    {"position", "transform", ": translate in its transform gives the place"},
    {"color", "transform", ": its material has the colors"},
    {"path", "transform", ": only a mesh has one; delete it"},
};

std::string insteadOf(std::string_view key, const JsonObject& object) {
    for (const Foreign& other : foreign)
        if (key == other.key && object.knows(other.beside)) return std::string(other.instead);
    return {};
}
}  // namespace

bool JsonObject::knows(std::string_view key) const { return std::ranges::find(known_, key) != known_.end(); }

JsonView JsonObject::operator[](std::string_view key) const {
    if (const auto member = find(key)) return *member;
    NearestName misspelled(key);
    std::vector<JsonView> unknown;
    for (const JsonView member : json_.members()) {
        if (knows(member.key())) continue;
        misspelled.consider(member.key());
        unknown.push_back(member);
    }
    if (misspelled.found()) unknown = {*find(misspelled.name())};
    const std::string expected = "expected the key " + inQuotes(key) + ", found ";
    if (unknown.empty()) json_.fail(expected + "none");
    throw json_.errorAtKey(unknown[0], expected + keysOf(unknown));
}

JsonObject KnownKeys::check(JsonView json, std::span<const std::string_view> known) {
    const JsonObject object(json, known);
    for (const JsonView member : json.members()) {
        if (object.knows(member.key())) continue;
        if (member.hasEditedKey() || warnings_.size() < mostWarnings) report(object, member);
        else ++notShown_;
    }
    return object;
}

void KnownKeys::report(const JsonObject& object, JsonView member) {
    const std::string_view key = member.key();
    NearestName nearest(key);
    for (const std::string_view name : object.known()) nearest.consider(name);
    const std::string message = "unknown key " + inQuotes(key);
    std::string remedy = nearest.found() ? nearest.question() : insteadOf(key, object);
    if (member.hasEditedKey()) throw object.json().errorAtKey(member, message + remedy);
    if (remedy.empty()) remedy = ": delete it";
    warnings_.emplace_back(object.json().errorAtKey(member, message + remedy).what());
}

std::vector<std::string> KnownKeys::warnings(const std::string& path) const {
    std::vector<std::string> all = warnings_;
    if (notShown_ > 0) all.push_back(path + ": " + std::to_string(notShown_) + " more unknown keys");
    return all;
}

}  // namespace raytracer
