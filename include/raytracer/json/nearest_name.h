// "did you mean ...?": finds the known name nearest to a misspelled one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace raytracer {

// Keeps the candidate nearest to `name`, the first of several. The distance is that of Damerau and
// Levenshtein (restricted, without regard to case): the number of letters inserted, left out, replaced, or
// swapped with a neighbour. A candidate with more than one error for each three letters is a different word
// and does not count.
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
