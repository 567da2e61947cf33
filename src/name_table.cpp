#include "name_table.h"

#include "nearest_name.h"

namespace raytracer {

void NameTable::add(std::string_view name, JsonView owner) {
    const auto [index, isNew] = indices_.try_emplace(name, entries_.size());
    if (!isNew)
        owner.fail(std::string("expected a name that no other ") + kind_ + " has, found " + inQuotes(name) + " as in " +
                   entries_[index->second].owner.pointer());
    entries_.push_back({name, owner});
}

std::size_t NameTable::find(JsonView name) const {
    const std::string& wanted = name.string();
    if (const auto index = indices_.find(wanted); index != indices_.end()) return index->second;
    NearestName nearest(wanted);
    for (const Entry& entry : entries_) nearest.consider(entry.name);
    name.fail(std::string("no ") + kind_ + " named " + inQuotes(wanted) + nearest.question());
}

}  // namespace raytracer
