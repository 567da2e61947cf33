// What was meant for a number, or for a list of numbers.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

// So many bytes with which a text begins, and what JSON has instead; none where nothing is known.
struct Meant {
    std::size_t size = 0;
    std::string json{};
    explicit operator bool() const { return size > 0; }
};

bool isDigitAt(std::string_view text, std::size_t at);

// 1, but +.5 and 007 too.
bool isNumber(std::string_view word);

// The number that the word is, as JSON has it: 0.5, 7.
std::string asJsonNumber(std::string_view word);

// Why a number is none of JSON's.
const char* aboutNumberForm(std::string_view number);

// Whether the word is a unit, which numbers do not have here.
bool isUnit(std::string_view word);

// A number with separators of thousands: 1 000, 1_000, 1.000,5. In a list, a blank and a comma may part
// numbers, and so may commas that leave a list of JSON's numbers.
Meant withoutThousands(std::string_view text, bool isInList);

// "0,5": what has one comma, between digits. "1,000" may be a thousand, "0,125" may not.
Meant withDecimalPoint(std::string_view text);
bool mayBeThousand(std::string_view number);

// Numbers with commas between them that lack their brackets: 0, 1, 4
Meant bareList(std::string_view text);

// The numbers, as JSON has them, that the whole text is, with blanks or commas between them; or none.
std::vector<std::string> numbersIn(std::string_view text);

// [1, 2] of "1" and "2"; nothing of no numbers.
std::string listOf(const std::vector<std::string>& numbers);

// Numbers as other languages have them: (3, 5, 4), <3, 5, 4>, vec3(3, 5, 4), x: 3, y: 5, and from its
// bracket, [x=3, y=5].
Meant vectorElsewhere(std::string_view text);

}  // namespace raytracer
