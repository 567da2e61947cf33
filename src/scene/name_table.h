// Finds a scene's materials, transforms or textures by name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "raytracer/json/json_view.h"
#include "raytracer/util/large_vector.h"

namespace raytracer {

class NameTable {
  public:
    // `kind` is a word for messages, as in "no material named ...".
    explicit NameTable(const char* kind) : kind_(kind) {}

    // Makes room for so many names, which take at most bytesOfName each.
    void reserve(std::size_t count);
    static constexpr std::size_t bytesOfName = 100;

    // Gives `name` the next index, from 0. `name` must outlive the table. Throws Error at `owner` if the name
    // is in use.
    void add(std::string_view name, JsonView owner);

    // The index of this name. Throws Error, with the nearest name, where there is none.
    std::size_t find(JsonView name);

  private:
    struct Entry {
        std::string_view name;
        JsonView owner;
    };

    std::string someNames() const;

    const char* kind_;
    LargeVector<Entry> entries_;
    std::unordered_map<std::string_view, std::uint32_t> indices_;
    std::size_t next_ = 0;  // the entry after the one found last, which scenes often ask for next
};

}  // namespace raytracer
