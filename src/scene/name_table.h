// Finds a scene's materials, transforms or textures by name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "raytracer/json/json_view.h"
#include "raytracer/util/large_vector.h"

namespace raytracer {

// A hash table with open addressing and linear probing, since a scene may have a million names.
class NameTable {
  public:
    // `kind` is a word for messages, as in "no material named ...".
    explicit NameTable(const char* kind) : kind_(kind) {}

    // Gives `name`, which must outlive the table, the next index, from 0. Throws Error at `owner` if the name
    // is in use.
    void add(std::string_view name, JsonView owner);

    // The index of this name. Throws Error, with the nearest name, where there is none.
    std::size_t find(JsonView name);

  private:
    struct Entry {
        std::string_view name;
        JsonView owner;
    };
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct Slot {
        std::uint32_t hash = 0, index = none;  // of an entry
    };

    std::string someNames() const;
    Slot& slotOf(std::string_view name);
    void grow();

    const char* kind_;
    LargeVector<Entry> entries_;
    LargeVector<Slot> slots_ = LargeVector<Slot>(2);  // a power of two; at most half are in use
    std::size_t next_ = 0;  // the entry after the one found last, which scenes often ask for next
};

}  // namespace raytracer
