#include "raytracer/json/json_view.h"

#include <algorithm>

#include "raytracer/json/json_edit.h"
#include "raytracer/json/json_writer.h"
#include "raytracer/util/nearest_name.h"
#include "raytracer/util/text.h"
#include "word_mistake.h"

namespace raytracer {
namespace {

using Kind = JsonDocument::Kind;

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
    require(Kind::String, "a string");
    return document_->string(node_);
}

void JsonView::numbers(std::span<double> out) const {
    if (kind() != Kind::Array || size() != out.size())
        failExpected(std::to_string(out.size()) + " numbers", Kind::Array);
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
    require(Kind::Array, "an array");
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
    const std::string why = whyText(wanted);
    fail("expected " + expected + (why.empty() ? form(wanted) + ", found " + inWords() : ": " + why));
}

// --set takes for a text what is no JSON. A reason that is an expectation too says no more than this one.
std::string JsonView::whyText(Kind wanted) const {
    if (kind() != Kind::String) return {};
    const std::string_view text = document_->string(node_);
    const bool isColor = node_ > 0 && document_->kind(node_ - 1) == Kind::Key && key().starts_with("color");
    if (const auto color = isColor ? hexColor(text) : ""; wanted == Kind::Array && !color.empty())
        return "a color is 3 numbers: write " + color;
    if (!document_->isEdited(node_)) return {};
    const std::string why = readingOf(text).why;
    return why.starts_with("expected ") ? "" : why;
}

// What a text has to lose for what is wanted.
std::string JsonView::form(Kind wanted) const {
    if (kind() != Kind::String || wanted == Kind::String) return {};
    const std::string_view text = document_->string(node_);
    const auto is = [&](std::string_view json) {
        const JsonReading reading = readingOf(json);
        return reading.kind == wanted && reading.why.empty();
    };
    if (is(text)) return " without quotes";
    const std::string lower = inLowerCase(text);
    if (!is(lower)) return {};
    return document_->isEdited(node_) ? " in small letters" : " as " + lower + ", without quotes";
}

std::string JsonView::inWords() const {
    switch (kind()) {
        case Kind::Null: return "null";
        case Kind::Boolean: return document_->boolean(node_) ? "true" : "false";
        case Kind::Number: return shortestNumber(document_->number(node_));
        case Kind::String: return inQuotes(document_->string(node_));
        case Kind::Array: return "an array of " + std::to_string(size());
        case Kind::Object: return "an object";
        case Kind::Key: break;  // a key is no value
    }
    return {};
}

}  // namespace raytracer
