#include "name_table.h"

#include "raytracer/util/nearest_name.h"

namespace raytracer {

void NameTable::reserve(std::size_t count) {
    entries_.reserve(count);
    indices_.reserve(count);
}

void NameTable::add(std::string_view name, JsonView owner) {
    const auto [known, isNew] = indices_.emplace(name, static_cast<std::uint32_t>(entries_.size()));
    if (!isNew)
        owner.fail("the name " + inQuotes(name) + " is taken by " + entries_[known->second].owner.pointer() +
                   ": choose another");
    entries_.push_back({name, owner});
}

std::size_t NameTable::find(JsonView name) {
    if (name.kind() != JsonDocument::Kind::String) name.failExpected(std::string("the name of a ") + kind_);
    const std::string_view wanted = name.string();
    if (next_ < entries_.size() && entries_[next_].name == wanted) return next_++;
    if (const auto known = indices_.find(wanted); known != indices_.end()) {
        next_ = known->second + 1;
        return known->second;
    }
    const std::string unknown = std::string("no ") + kind_ + " named " + inQuotes(wanted);
    if (entries_.empty()) name.fail(unknown + ": the scene has no " + kind_ + "s");
    NearestName nearest(wanted);
    for (const Entry& entry : entries_) {
        if (entry.owner.isString(wanted)) name.fail(unknown + "; it is the path of " + inQuotes(entry.name));
        nearest.consider(entry.name);
    }
    name.fail(unknown + (nearest.found() ? nearest.question() : someNames()));
}

// The names that there are, if they are few and short.
std::string NameTable::someNames() const {
    constexpr std::size_t most = 3, longest = 40;  // fits a terminal's line
    std::vector<std::string> names;
    for (const Entry& entry : entries_) {
        const bool isNamed = entry.owner.kind() == JsonDocument::Kind::String;
        if (!isNamed) return "; " + entry.owner.pointer() + " has no name";
        if (names.size() <= most) names.push_back(inQuotes(entry.name));
    }
    const std::string list = listed(names, "and");
    if (names.size() > most || list.size() > longest) return {};
    return (names.size() == 1 ? "; there is " : "; there are ") + list;
}

}  // namespace raytracer
