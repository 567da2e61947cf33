// "did you mean ...?": the known name that a misspelled one is nearest to.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace raytracer {

// Collects candidates for `name` and keeps the nearest (the first of equals), counting letters inserted, left
// out, replaced or swapped with their neighbour, whatever their case (Damerau, Levenshtein; the restricted
// distance). Only a candidate with at most one such error for each three letters counts: what is further off
// is a different word.
class NearestName {
  public:
    explicit NearestName(std::string_view name);

    void consider(std::string_view candidate);
    bool found() const { return found_; }
    const std::string& name() const { return nearest_; }

    // `; did you mean "nearest"?`, or nothing.
    std::string question() const;

  private:
    std::string name_, nearest_;
    std::size_t limit_;  // a candidate counts if its distance is below this
    bool found_ = false;
};

}  // namespace raytracer
