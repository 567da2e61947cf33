// The names of a scene's materials, transforms or textures, and which of them a string means.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "json_view.h"

namespace raytracer {

class NameTable {
  public:
    // `kind` is for messages: no material named ...
    explicit NameTable(const char* kind) : kind_(kind) {}

    // Gives the next index, from 0, to `name`, which must outlive the table; an error at `owner` if it has one already.
    void add(std::string_view name, JsonView owner);

    // The index of the name that this string is; an error with the nearest one if it is none.
    std::size_t find(JsonView name) const;

  private:
    struct Entry {
        std::string_view name;
        JsonView owner;
    };

    const char* kind_;
    std::vector<Entry> entries_;
    std::unordered_map<std::string_view, std::size_t> indices_;
};

}  // namespace raytracer
