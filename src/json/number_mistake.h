// Recognises text that was meant as a number, or as a list of numbers, but is not JSON.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raytracer {

// The first `size` bytes of a text, and the JSON that was meant by them. Size 0: nothing was recognised.
struct Meant {
    std::size_t size = 0;
    std::string json{};
    explicit operator bool() const { return size > 0; }
};

bool isDigitAt(std::string_view text, std::size_t at);

// Whether the word is a finite number in any common form: 1, but also +.5 and 007.
bool isNumber(std::string_view word);

// The same number in JSON's form: 0.5, 7.
std::string asJsonNumber(std::string_view word);

// Why a number is not in JSON's form.
const char* aboutNumberForm(std::string_view number);

// Whether the word is a unit of length or angle, or the like. Numbers have no units here.
bool isUnit(std::string_view word);

// A number with thousands separators: 1 000, 1_000, 1.000,5. In a list, blanks and commas are not taken for
// thousands separators, since they may separate numbers.
Meant withoutThousands(std::string_view text, bool isInList);

// A number with a decimal comma, between digits: "0,5".
// mayBeThousand: "1,000" may be a thousand, "0,125" not.
Meant withDecimalPoint(std::string_view text);
bool mayBeThousand(std::string_view number);

// Two numbers or more, separated by commas, without brackets: 0, 1, 4
Meant bareList(std::string_view text);

// The numbers, in JSON's form, that make up the whole text, with blanks or commas between them. Empty if the
// text has anything else.
std::vector<std::string> numbersIn(std::string_view text);

// The list of these numbers: "[1, 2]" for "1" and "2"; empty if there are none.
std::string listOf(const std::vector<std::string>& numbers);

// Numbers as other languages write them: (3, 5, 4), <3, 5, 4>, vec3(3, 5, 4), x: 3, y: 5, and, if the text
// begins with the bracket, [x=3, y=5].
Meant vectorElsewhere(std::string_view text);

}  // namespace raytracer
