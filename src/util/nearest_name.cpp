#include "raytracer/util/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "raytracer/util/text.h"

namespace raytracer {
namespace {

// A longer text is not a misspelled name. The time to compare grows with the product of the lengths.
constexpr std::size_t longestName = 100;

bool areSwapped(std::string_view a, std::string_view b, std::size_t i, std::size_t j) {
    return i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
}

// The distance of the first i letters of a to the first j of b, row by row (dynamic programming).
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(above);
        above.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = above[j - 1] + (a[i - 1] != b[j - 1]);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, changed});
            if (areSwapped(a, b, i, j)) row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::size_t lengthDifference(std::string_view a, std::string_view b) {
    return std::max(a.size(), b.size()) - std::min(a.size(), b.size());
}

// Whether the name ends with `part`, and `part` consists
// of whole words: a name's last word says what it names.
bool endsInWord(std::string_view name, std::string_view part) {
    constexpr std::size_t least = 4;  // letters; many names end with the same two or three
    if (part.size() < least || part.size() >= name.size() || !name.ends_with(part)) return false;
    return std::isalnum(static_cast<unsigned char>(name[name.size() - part.size() - 1])) == 0;
}

// Whether `whole` begins with `part`, and `part` has at least `least` letters.
bool begins(std::string_view whole, std::string_view part, std::size_t least) {
    return part.size() >= least && whole.size() > part.size() && whole.starts_with(part);
}

}  // namespace

NearestName::NearestName(std::string_view name, std::size_t lettersForError)
    : name_(inLowerCase(name)),
      limit_(std::min(std::max<std::size_t>(1, name.size() / lettersForError) + 1, name.size())) {}

void NearestName::consider(std::string_view candidate) {
    if (name_.size() > longestName) return;
    const std::string other = inLowerCase(candidate);
    if (endsInWord(other, name_) || endsInWord(name_, other)) last_.add(candidate);
    if (begins(other, name_, 3) || begins(name_, other, 4)) first_.add(candidate);
    if (lengthDifference(name_, other) >= limit_) return;
    const std::size_t errors = distance(name_, other);
    if (errors >= limit_) return;
    limit_ = errors;
    nearest_ = candidate;
    found_ = true;
}

std::string NearestName::question() const { return found() ? didYouMean(name()) : ""; }

std::string didYouMean(std::string_view name) { return "; did you mean " + inQuotes(name) + "?"; }

}  // namespace raytracer
