// Checks the keys of objects. An unknown key is a warning with the nearest known one; in a value of --set it
// is an Error. A required key that is missing is an Error with the unknown key that may have been meant.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "raytracer/json/json_view.h"
#include "raytracer/util/error.h"

namespace raytracer {

// A JSON object and the keys that it may have.
class JsonObject {
  public:
    JsonObject(JsonView json, std::span<const std::string_view> known) : json_(json), known_(known) {}

    bool knows(std::string_view key) const;
    JsonView operator[](std::string_view key) const;  // throws Error if it is missing
    std::optional<JsonView> find(std::string_view key) const { return json_.find(key); }

    // The known key that an unknown member probably means, or nothing; and a message with what to do about
    // it.
    std::string meantBy(JsonView member) const;
    std::string whyUnknown(JsonView member) const;

    JsonView json() const { return json_; }
    std::span<const std::string_view> known() const { return known_; }

  private:
    std::optional<JsonView> findInside(std::string_view key) const;

    JsonView json_;
    std::span<const std::string_view> known_;
};

class KnownKeys {
  public:
    // `known` must outlive the result.
    JsonObject check(JsonView json, std::span<const std::string_view> known);

    // Throws Error if an unknown key probably means this one: then that is why something is missing.
    void requireNamed(const std::string& key) const;

    // One line each, as what() of an Error about the file `path`. Only the first few are shown, and the last
    // line counts the others: in a scene of a million shapes, each may have a key for a comment.
    std::vector<std::string> warnings(const std::string& path) const;

  private:
    void warn(const JsonObject& object, JsonView member);

    std::vector<std::string> warnings_;
    std::map<std::string, Error> misnamed_;  // by what it means, the first such key
    std::size_t notShown_ = 0;
};

}  // namespace raytracer
