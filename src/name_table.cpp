#include "name_table.h"

#include <functional>

#include "nearest_name.h"

namespace raytracer {

void NameTable::add(std::string_view name, JsonView owner) {
    if (slots_.size() <= 2 * entries_.size()) grow();
    std::uint32_t& slot = slots_[slotOf(name)];
    if (slot != none)
        owner.fail(std::string("expected a name that no other ") + kind_ + " has, found " + inQuotes(name) + " as in " +
                   entries_[slot].owner.pointer());
    slot = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({name, owner});
}

std::size_t NameTable::find(JsonView name) const {
    const std::string_view wanted = name.string();
    if (const std::uint32_t index = slots_[slotOf(wanted)]; index != none) return index;
    NearestName nearest(wanted);
    for (const Entry& entry : entries_) nearest.consider(entry.name);
    name.fail(std::string("no ") + kind_ + " named " + inQuotes(wanted) + nearest.question());
}

// Where the name is, or would be put.
std::size_t NameTable::slotOf(std::string_view name) const {
    const std::size_t last = slots_.size() - 1;
    std::size_t slot = std::hash<std::string_view>()(name) & last;
    while (slots_[slot] != none && entries_[slots_[slot]].name != name) slot = (slot + 1) & last;
    return slot;
}

void NameTable::grow() {
    slots_.assign(4 * slots_.size(), none);
    for (std::uint32_t index = 0; index < entries_.size(); ++index) slots_[slotOf(entries_[index].name)] = index;
}

}  // namespace raytracer
