#include "split_values.h"

#include <algorithm>
#include <vector>

#include "arguments.h"
#include "raytracer/util/number.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

// Without the empty ones.
std::vector<std::string> partsOf(const std::string& text, const ListForm& form) {
    std::vector<std::string> parts = split(text, form.separators);
    std::erase(parts, "");
    return parts;
}

// Empty where the text is whole, or what is behind is no part.
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

// An object's text whose quotes a shell has taken away: {"type":"sphere"} of type:sphere.
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

// "0" "1" "2", which a shell has made of {0..2}; or downwards.
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

// "/a={0..2}" of "/a=0" "/a=1" "/a=2", which a shell has made of braces; empty where it has not.
std::string joinedBraces(const std::string& text, Behind behind) {
    constexpr std::size_t longest = 24;  // leaves room on a line
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

// Whether a value is still to come, or its end.
bool isUnfinished(const std::string& edit) {
    const auto count = [&](const char* brackets) {
        return std::ranges::count_if(
            edit, [=](char c) { return std::string_view(brackets).find(c) != std::string_view::npos; });
    };
    return edit.find('=') == edit.npos || edit.ends_with('=') || edit.ends_with(',') ||
           count("[{") > count("]}");
}

bool isFile(const std::string& word) { return word == "-" || endsIn(word, ".json") || isPictureName(word); }

// In double quotes, which any shell has, but for what a shell changes in them.
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
