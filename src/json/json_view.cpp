#include "raytracer/json/json_view.h"

#include <algorithm>

#include "number_mistake.h"
#include "raytracer/json/json_edit.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/text.h"
#include "word_mistake.h"

namespace raytracer {
namespace {

using Kind = JsonDocument::Kind;

// The direction of the axis that the text names ("y", "-Z"), as numbers; empty if it names none.
std::vector<std::string> axisNamed(std::string_view text) {
    const bool isNegative = text.starts_with('-');
    const std::string lower = inLowerCase(text.substr(isNegative));
    const std::size_t axis = lower.size() == 1 ? std::string_view("xyz").find(lower) : std::string::npos;
    if (axis == std::string::npos) return {};
    std::vector<std::string> numbers(3, "0");
    numbers[axis] = isNegative ? "-1" : "1";
    return numbers;
}

bool inSingleQuotes(std::string_view text) {
    return text.size() > 1 && text.starts_with('\'') && text.ends_with('\'');
}

}  // namespace

bool JsonView::boolean() const {
    require(Kind::Boolean, "true or false");
    return document_->boolean(node_);
}

double JsonView::number() const {
    require(Kind::Number, "a number");
    return document_->number(node_);
}

std::string_view JsonView::string() const {
    require(Kind::String, "a text");
    return document_->string(node_);
}

void JsonView::numbers(std::span<double> out, const std::string& expected) const {
    if (kind() != Kind::Array || size() != out.size())
        failExpectedNumbers(expected.empty() ? std::to_string(out.size()) + " numbers" : expected,
                            out.size());
    std::size_t i = 0;
    for (const JsonView element : elements()) out[i++] = element.number();
}

glm::dvec3 JsonView::vec3() const {
    double xyz[3];
    numbers(xyz);
    return {xyz[0], xyz[1], xyz[2]};
}

std::size_t JsonView::choice(std::span<const std::string_view> choices) const {
    const std::string_view chosen = string();
    const auto found = std::ranges::find(choices, chosen);
    if (found != choices.end()) return static_cast<std::size_t>(found - choices.begin());
    NearestName nearest(chosen);
    std::vector<std::string> names;
    for (const std::string_view choice : choices) {
        nearest.consider(choice);
        names.emplace_back(choice);
    }
    failExpected(nearest.found() ? inQuotes(nearest.name()) : listed(names));
}

JsonView::Children JsonView::elements() const {
    require(Kind::Array, "a list");
    return {{*document_, node_ + 1, 0}, {*document_, document_->end(node_), 0}};
}

JsonView::Children JsonView::members() const {
    require(Kind::Object, "an object");
    return {{*document_, node_ + 1, 1}, {*document_, document_->end(node_), 1}};
}

std::size_t JsonView::size() const {
    if (kind() != Kind::Array && kind() != Kind::Object) return 0;
    std::size_t count = 0;
    const auto [first, last] = kind() == Kind::Array ? elements() : members();
    for (Iterator child = first; !(child == last); ++child) ++count;
    return count;
}

void JsonView::requireElements(std::size_t count, const char* expected) const {
    if (kind() != Kind::Array || size() != count) failExpected(expected, Kind::Array);
}

JsonView JsonView::element(std::size_t index) const {
    Iterator element = elements().begin();
    while (index-- > 0) ++element;
    return *element;
}

std::string_view JsonView::key() const { return document_->string(node_ - 1); }

std::optional<JsonView> JsonView::find(std::string_view key) const {
    for (const JsonView member : members())
        if (member.key() == key) return member;
    return std::nullopt;
}

bool JsonView::isString(std::string_view text) const { return kind() == Kind::String && string() == text; }

void JsonView::failExpected(const std::string& expected, Kind wanted) const {
    const std::string start = "expected " + expected, why = whyText(wanted);
    if (why.empty()) fail(start + form(wanted) + ", found " + inWords());
    const std::size_t remedy = why.find("write ");
    constexpr std::size_t widest = 98;  // characters behind the file's name
    const bool fits = columnCount(pointer() + ", by --set: " + start + ": " + why) <= widest;
    fail(start + ": " + (fits || remedy == why.npos ? why : why.substr(remedy)));
}

void JsonView::failExpectedNumbers(const std::string& expected, std::size_t count) const {
    const std::string meant = numbersMeant(count);
    if (!meant.empty()) fail("expected " + expected + ", found " + inWords() + ": write " + meant);
    const bool isText = kind() == Kind::String && isColor();
    const bool isWhy = isText && !whyText(Kind::Array).empty();
    failExpected(expected + (isText && !isWhy ? ", red, green and blue" : ""), Kind::Array);
}

// Why this string is not the value that is wanted; empty if nothing more is known than that. --set takes a
// value that is not JSON for a string: then the reason is why it is not. A reason that begins with "expected"
// is left out, since the message states an expectation already.
std::string JsonView::whyText(Kind wanted) const {
    if (kind() != Kind::String) return {};
    const std::string_view text = document_->string(node_);
    const Meant decimal = wanted == Kind::Number ? withDecimalPoint(text) : Meant{};
    if (decimal && decimal.size == text.size()) return "a number has a decimal point: write " + decimal.json;
    if (!document_->isEdited(node_) || inSingleQuotes(text)) return {};
    const std::string why = readingOf(text).why;
    const bool isOther = wanted != Kind::Array && why.starts_with("a list ");
    return why.starts_with("expected ") || isOther ? "" : why;
}

// How to write this string so that it is the kind that is wanted: without its quotes, or in small letters.
std::string JsonView::form(Kind wanted) const {
    if (kind() != Kind::String || wanted == Kind::String) return {};
    const std::string_view text = document_->string(node_);
    const auto is = [&](std::string_view json) {
        const JsonReading reading = readingOf(json);
        return reading.kind == wanted && reading.why.empty();
    };
    if (is(text) || (inSingleQuotes(text) && is(text.substr(1, text.size() - 2)))) return " without quotes";
    const std::string lower = inLowerCase(text);
    if (!is(lower)) return {};
    return document_->isEdited(node_) ? " in small letters" : " as " + lower + ", without quotes";
}

bool JsonView::hasKey() const { return node_ > 0 && document_->kind(node_ - 1) == Kind::Key; }
bool JsonView::isColor() const { return hasKey() && key().starts_with("color"); }

// The array of `count` numbers that was probably meant by this value, which is not one; empty if not known.
std::string JsonView::numbersMeant(std::size_t count) const {
    if (!hasKey()) return {};
    std::vector<std::string> numbers;
    if (kind() == Kind::String) {
        const std::string_view text = document_->string(node_);
        std::string color = isColor() ? hexColor(text) : "";
        if (!color.empty()) return color;
        numbers = numbersIn(text);
        if (numbers.empty()) numbers = axisNamed(text);
    }
    if (kind() == Kind::Number && (isColor() || (key() == "scale" && document_->number(node_) != 0)))
        numbers.assign(count, shortestNumber(document_->number(node_)));
    if (kind() == Kind::Object) numbers = coordinates();
    return numbers.size() == count ? listOf(numbers) : "";
}

// The members x, y, z or r, g, b, if there are no others and all are numbers.
std::vector<std::string> JsonView::coordinates() const {
    for (const std::string_view names : {"xyz", "rgb"}) {
        std::vector<std::string> numbers;
        for (const char& name : names)
            if (const auto member = find({&name, 1}); member && member->kind() == Kind::Number)
                numbers.push_back(shortestNumber(member->number()));
        if (numbers.size() == size()) return numbers;
    }
    return {};
}

std::string JsonView::inWords() const {
    switch (kind()) {
        case Kind::Null: return "null";
        case Kind::Boolean: return document_->boolean(node_) ? "true" : "false";
        case Kind::Number: return shortestNumber(document_->number(node_));
        case Kind::String: return inQuotes(document_->string(node_));
        case Kind::Array: return "a list of " + std::to_string(size());
        case Kind::Object: return "an object";
        case Kind::Key: break;  // not a value
    }
    return {};
}

}  // namespace raytracer
