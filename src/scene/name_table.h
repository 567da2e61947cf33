// The names of a scene's materials, transforms or textures, and which of them a string means.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "raytracer/json/json_view.h"

namespace raytracer {

// A hash table by open addressing (linear probing), for a scene may have a million names.
class NameTable {
  public:
    // `kind` is for messages: no material named ...
    explicit NameTable(const char* kind) : kind_(kind) {}

    // Gives the next index, from 0, to `name`, which must outlive the table; an error at `owner` if it has
    // one already.
    void add(std::string_view name, JsonView owner);

    // The index of the name that this string is; an error with the nearest one if it is none.
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

    Slot& slotOf(std::string_view name);
    void grow();

    const char* kind_;
    std::vector<Entry> entries_;
    std::vector<Slot> slots_ = std::vector<Slot>(2);  // as many as a power of two, at most half of them taken
    std::size_t next_ = 0;  // behind the one found last: likely to be asked for next
};

}  // namespace raytracer
