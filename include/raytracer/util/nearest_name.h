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
// and does not count. Nearer than two errors is the one candidate that has the name as its last words, or is
// the last words of the name: "color_diffuse" and "diffuse".
class NearestName {
  public:
    explicit NearestName(std::string_view name);

    void consider(std::string_view candidate);
    bool found() const { return found_ || kin_ == 1; }
    const std::string& name() const { return kin_ == 1 && (!found_ || limit_ > 1) ? kinName_ : nearest_; }

    // `; did you mean "nearest"?`, or nothing.
    std::string question() const;

  private:
    std::string name_, nearest_, kinName_;
    std::size_t limit_;  // a candidate counts if its distance is below this, that of nearest_
    bool found_ = false;
    int kin_ = 0;  // candidates with the same last words, of which kinName_ is one
};

}  // namespace raytracer
