// "did you mean ...?": finds the known name nearest to a misspelled one.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace raytracer {

// Keeps the candidate nearest to `name`, the first of several. The distance is that of Damerau and
// Levenshtein (restricted, without regard to case): the number of letters inserted, left out, replaced, or
// swapped with a neighbour. A candidate with more than one error for each three letters (or more, where the
// constructor is told) is a different word and does not count, and so is one with as many errors as the name
// has letters. Nearer than two errors is the one candidate that has the name as its last words, or is the
// last words of the name: "color_diffuse" and "diffuse"; and else the one that begins with the name, or that
// the name begins with: "focal" and "focal_length".
class NearestName {
  public:
    static constexpr std::size_t lettersAnError = 3;

    explicit NearestName(std::string_view name, std::size_t lettersForError = lettersAnError);

    void consider(std::string_view candidate);
    bool found() const { return found_ || kin().count == 1; }
    const std::string& name() const {
        return kin().count == 1 && (!found_ || limit_ > 1) ? kin().name : nearest_;
    }

    // `; did you mean "nearest"?`, or nothing.
    std::string question() const;

  private:
    // Candidates that share words with the name, and one of them.
    struct Kin {
        int count = 0;
        std::string name{};
        void add(std::string_view candidate) {
            ++count;
            name = candidate;
        }
    };
    const Kin& kin() const { return last_.count > 0 ? last_ : first_; }

    std::string name_;  // in small letters
    std::string nearest_;
    std::size_t limit_;  // a candidate counts if its distance is below this, that of nearest_
    bool found_ = false;
    Kin last_, first_;  // by their last words, and by their first letters
};

// '; did you mean "diffuse"?'
std::string didYouMean(std::string_view name);

}  // namespace raytracer
