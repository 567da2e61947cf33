#include "name_table.h"

#include <functional>
#include <utility>

#include "raytracer/util/nearest_name.h"

namespace raytracer {

void NameTable::add(std::string_view name, JsonView owner) {
    if (slots_.size() <= 2 * entries_.size()) grow();
    Slot& slot = slotOf(name);
    if (slot.index != none)
        owner.fail("the name " + inQuotes(name) + " is taken by " + entries_[slot.index].owner.pointer() +
                   ": choose another");
    slot.index = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({name, owner});
}

std::size_t NameTable::find(JsonView name) {
    if (name.kind() != JsonDocument::Kind::String) name.failExpected(std::string("the name of a ") + kind_);
    const std::string_view wanted = name.string();
    if (next_ == entries_.size() || entries_[next_].name != wanted) next_ = slotOf(wanted).index;
    if (next_ != none) return next_++;
    const std::string unknown = std::string("no ") + kind_ + " named " + inQuotes(wanted);
    if (entries_.empty()) name.fail(unknown + ": the scene has no " + kind_ + "s");
    NearestName nearest(wanted);
    for (const Entry& entry : entries_) {
        if (entry.owner.isString(wanted)) name.fail(unknown + "; it is the path of " + inQuotes(entry.name));
        nearest.consider(entry.name);
    }
    name.fail(unknown + (nearest.found() ? nearest.question() : someNames()));
}

// What there is, if it is not much.
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

// The slot of the name, or the free one that it would get.
NameTable::Slot& NameTable::slotOf(std::string_view name) {
    const auto hash = static_cast<std::uint32_t>(std::hash<std::string_view>()(name));
    const std::size_t last = slots_.size() - 1;
    const auto isOther = [&](const Slot& slot) {
        return slot.index != none && (slot.hash != hash || entries_[slot.index].name != name);
    };
    std::size_t place = hash & last;
    while (isOther(slots_[place])) place = (place + 1) & last;
    slots_[place].hash = hash;
    return slots_[place];
}

void NameTable::grow() {
    const LargeVector<Slot> old = std::exchange(slots_, LargeVector<Slot>(4 * slots_.size()));
    const std::size_t last = slots_.size() - 1;
    for (const Slot& slot : old) {
        if (slot.index == none) continue;
        std::size_t place = slot.hash & last;
        while (slots_[place].index != none) place = (place + 1) & last;
        slots_[place] = slot;
    }
}

}  // namespace raytracer
