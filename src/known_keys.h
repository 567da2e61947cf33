// Keys that the format does not know: warnings with the nearest key that it knows, or an error when strict.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "json_view.h"

namespace raytracer {

class KnownKeys {
  public:
    explicit KnownKeys(bool strict) : strict_(strict) {}

    void check(JsonView object, std::span<const std::string_view> known);

    // In the form of JsonError's what(). After the first few only how many more there are: a scene of a million shapes
    // may have a comment in each.
    std::vector<std::string> warnings() const;

  private:
    void report(JsonView object, std::string_view key, std::span<const std::string_view> known);

    bool strict_;
    std::vector<std::string> warnings_;
    std::size_t notShown_ = 0;
};

}  // namespace raytracer
