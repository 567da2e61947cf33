#include "split_values.h"

#include <algorithm>
#include <vector>

#include "arguments.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

// The parts of a list, without empty ones.
std::vector<std::string> partsOf(const std::string& text, const ListForm& form) {
    std::vector<std::string> parts = split(text, form.separators);
    std::erase(parts, "");
    return parts;
}

// The list that begins with `text` and goes on in the words behind it. Empty if it does not go on there.
std::string joinedList(const std::string& text, Behind behind, const ListForm& form) {
    std::vector<std::string> parts = partsOf(text, form);
    const std::size_t own = parts.size();
    if (!std::ranges::all_of(parts, form.isPart)) return {};
    for (const std::string& word : behind) {
        const std::vector<std::string> more = partsOf(word, form);
        if (parts.size() + more.size() > form.most || !std::ranges::all_of(more, form.isPart)) break;
        parts.insert(parts.end(), more.begin(), more.end());
    }
    if (parts.size() == own || parts.size() < form.least) return {};
    return joined(parts, form.between);
}

// Restores the quotes that a shell has taken from an object: {"type":"sphere"} for type:sphere.
std::string objectOf(const std::string& bare) {
    std::string object = "{";
    for (std::size_t start = 0, end = 0; start < bare.size(); start = end + 1) {
        end = std::min(bare.find_first_of(":,[]{}", start), bare.size());
        const std::string token = bare.substr(start, end - start);
        const bool isPlain = token.empty() || numberOf<double>(token) || token == "true" || token == "false";
        object += isPlain ? token : '"' + token + '"';
        if (end < bare.size()) object += bare[end];
    }
    return object + "}";
}

// Whether the values count up or down by 1, as a shell makes "0" "1" "2" from {0..2}.
bool isCount(const std::vector<std::string>& values) {
    const auto step = [](const std::string& a, const std::string& b) {
        const auto from = numberOf<int>(a), to = numberOf<int>(b);
        return from && to ? static_cast<double>(*to) - *from : 0.0;
    };
    const double first = step(values[0], values[1]);
    for (std::size_t i = 1; i < values.size(); ++i)
        if (step(values[i - 1], values[i]) != first) return false;
    return first == 1 || first == -1;
}

// "/a={0..2}" from "/a=0" "/a=1" "/a=2", into which a
// shell has expanded it. Empty if there is only one value.
std::string joinedBraces(const std::string& text, Behind behind) {
    constexpr std::size_t longest = 24;  // characters; fits into the message's line
    const std::string pointer = text.substr(0, text.find('=') + 1);
    std::vector<std::string> values{text.substr(pointer.size())};
    for (const std::string& word : behind) {
        if (pointer.empty() || !word.starts_with(pointer)) break;
        values.push_back(word.substr(pointer.size()));
    }
    if (values.size() == 1) return {};
    if (isCount(values)) return pointer + "{" + values.front() + ".." + values.back() + "}";
    const std::string list = joined(values, ",");
    const std::string whole = list.find(':') == list.npos ? "[" + list + "]" : objectOf(list);
    return pointer + (whole.size() > longest ? "{...}" : whole);
}

// Whether the value of an edit, or the end of it, is still to come.
bool isUnfinished(const std::string& edit) {
    const auto count = [&](const char* brackets) {
        return std::ranges::count_if(
            edit, [=](char c) { return std::string_view(brackets).find(c) != std::string_view::npos; });
    };
    return edit.find('=') == edit.npos || edit.ends_with('=') || edit.ends_with(',') ||
           count("[{") > count("]}");
}

bool isFile(const std::string& word) { return word == "-" || endsIn(word, ".json") || isPictureName(word); }

// The text in double quotes, which every shell has; in single
// quotes if a shell would change something in double ones.
std::string inAnyShell(const std::string& text) {
    return text.find_first_of("\"$`\\!") == text.npos ? '"' + text + '"' : inShellQuotes(text);
}

}  // namespace

Word::Rejoin rejoinedList(const ListForm& form) {
    return [form](const std::string& text, Behind behind) -> Word::Whole {
        return {form.inWords, joinedList(text, behind, form)};
    };
}

Word::Whole joinedEdit(const std::string& text, Behind behind) {
    if (const std::string braces = joinedBraces(text, behind); !braces.empty())
        return {"needs quotes around braces", inShellQuotes(braces)};
    if (!text.starts_with('/') || !isUnfinished(text)) return {};
    std::string edit = text;
    for (const std::string& word : behind) {
        if (!isUnfinished(edit) || isFile(word)) break;
        const bool hasEquals = edit.find('=') != edit.npos || word.starts_with('=');
        if (!hasEquals) edit += '=';
        else if (!edit.ends_with('=') && !word.starts_with('=')) edit += ' ';
        edit += word;
    }
    if (isUnfinished(edit)) return {};
    const std::size_t value = edit.find('=') + 1;
    const bool isBareList =
        edit.find_first_not_of("0123456789.,-+e ", value) == edit.npos && edit.find(',', value) != edit.npos;
    if (isBareList) edit = edit.substr(0, value) + "[" + edit.substr(value) + "]";
    return {"takes /pointer=value", inAnyShell(edit)};
}

}  // namespace raytracer::commands
