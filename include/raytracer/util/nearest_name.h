// "did you mean ...?": finds the known name nearest to a misspelled one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace raytracer {

// Keeps the candidate nearest to `name`; of equally near ones, the first.
//
// The distance is the restricted Damerau-Levenshtein distance, ignoring case: the number of letters inserted,
// left out, replaced, or swapped with a neighbour. A candidate is a different word, and does not count, if it
// has more than one error for each `lettersForError` letters of the name (one is always allowed), or as many
// errors as the name has letters.
//
// A candidate that shares words with the name is preferred to any with two errors or more, if it is the only
// one. First comes one that ends with the name, or with which the name ends: "color_diffuse" and "diffuse".
// If there is none, one that begins with the name, or with which the name begins: "focal" and "focal_length".
class NearestName {
  public:
    static constexpr std::size_t lettersAnError = 3;

    explicit NearestName(std::string_view name, std::size_t lettersForError = lettersAnError);

    void consider(std::string_view candidate);
    bool found() const { return found_ || kin().count == 1; }
    const std::string& name() const {
        return kin().count == 1 && (!found_ || limit_ > 1) ? kin().name : nearest_;
    }

    // `; did you mean "nearest"?`, or empty.
    std::string question() const;

  private:
    // The number of candidates that share words with the name, and one of them.
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
    std::size_t limit_;  // a candidate counts if its distance is below this: once found, that of nearest_
    bool found_ = false;
    Kin last_, first_;  // those that share their last words, and their first letters
};

// '; did you mean "diffuse"?'
std::string didYouMean(std::string_view name);

}  // namespace raytracer
