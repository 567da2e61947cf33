#include "command_line.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <CLI/CLI.hpp>

#include "raytracer/json/json_document.h"
#include "raytracer/util/number.h"
#include "raytracer/util/standard_streams.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

constexpr std::size_t columns = 80;      // what a terminal shows of a line
constexpr std::size_t nameColumns = 26;  // the help's left column: "  --max-recursion N=3" and blanks

// The text in lines that fit the help's right column.
std::string wrapped(const std::string& text) {
    std::string lines;
    std::size_t used = 0;
    for (std::size_t start = 0, end = 0; start < text.size(); start = end + 1) {
        end = std::min(text.find(' ', start), text.size());
        const bool fits = used + 1 + (end - start) <= columns - nameColumns;
        if (start > 0) lines += fits ? ' ' : '\n';
        used = (fits && start > 0 ? used + 1 : 0) + (end - start);
        lines.append(text, start, end - start);
    }
    return lines;
}

// Empty for any number.
std::string inWords(const Range& range) {
    if (range.most < Range().most)
        return " from " + formatted("%.6g", range.least) + " to " + formatted("%.6g", range.most);
    if (range.least == Range().least) return "";
    return (range.open ? " above " : " not below ") + formatted("%.6g", range.least);
}

[[noreturn]] void refuse(const char* name, const std::string& expected, const std::string& found) {
    throw CLI::ValidationError(name, "expected " + expected + ", found " + inQuotes(found));
}

template <class Number>
Number numberIn(const char* name, const std::string& text, const Range& range) {
    const std::optional<Number> number = raytracer::numberOf<Number>(text);
    const double value = number ? static_cast<double>(*number) : range.least - 1;
    if (!number || !(value >= range.least && value <= range.most) || (range.open && value == range.least))
        refuse(name, (std::is_integral_v<Number> ? "a whole number" : "a number") + inWords(range), text);
    return *number;
}

std::string helpWithRange(const std::string& help, const Range& range) {
    const std::string words = inWords(range);
    return words.empty() ? help : help + " (" + words.substr(1) + ")";
}

std::string listed(const std::vector<std::string>& choices) {
    std::string list;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i > 0) list += i + 1 < choices.size() ? ", " : " or ";
        list += choices[i];
    }
    return list;
}

template <class Number>
constexpr const char* placeholderOf = std::is_integral_v<Number> ? "N" : "NUMBER";

}  // namespace

CommandLine::CommandLine(const std::string& command, const std::string& purpose)
    : app_(std::make_unique<CLI::App>(purpose, command)) {
    app_->get_formatter()->column_width(nameColumns);
}

CommandLine::~CommandLine() = default;

CLI::Option& CommandLine::add(const char* name, const std::string& placeholder, const std::string& help,
                              Read read) {
    CLI::Option& option = *app_->add_option(
        name,
        [read = std::move(read)](const CLI::results_t& texts) {
            for (const std::string& text : texts) read(text);
            return true;
        },
        wrapped(help));
    const bool isArgument = option.get_positional();
    option.required(isArgument);
    option.option_text(isArgument ? " " : placeholder);
    return option;
}

// Where nothing is the default, an empty text would pass for that: "$VARIABLE" of a variable that is not set.
void CommandLine::text(const char* name, std::string& value, const std::string& help) {
    add(name, value.empty() ? "TEXT" : "TEXT=" + value, help, [=, &value](const std::string& text) {
        if (text.find_first_not_of(" \t\n") == text.npos) refuse(name, "a text", text);
        value = text;
    });
}

void CommandLine::texts(const char* name, std::vector<std::string>& values, const std::string& help) {
    add(name, "TEXT ...", help, [&values](const std::string& text) { values.push_back(text); })
        .expected(1, CLI::detail::expected_max_vector_size)
        ->allow_extra_args();
}

void CommandLine::choice(const char* name, std::string& value, const std::vector<std::string>& choices,
                         const std::string& help) {
    add(name, value.empty() ? "NAME" : "NAME=" + value, help, [=, &value](const std::string& text) {
        if (std::find(choices.begin(), choices.end(), text) == choices.end())
            refuse(name, listed(choices), text);
        value = text;
    });
}

void CommandLine::flag(const char* name, bool& value, const std::string& help) {
    app_->add_flag(name, value, wrapped(help));
}

template <class Number>
void CommandLine::number(const char* name, Number& value, const Range& range, const std::string& help) {
    add(name, placeholderOf<Number> + ("=" + formatted("%.6g", static_cast<double>(value))),
        helpWithRange(help, range),
        [=, &value](const std::string& text) { value = numberIn<Number>(name, text, range); });
}

template <class Number>
void CommandLine::number(const char* name, std::optional<Number>& value, const Range& range,
                         const std::string& help) {
    add(name, placeholderOf<Number>, helpWithRange(help, range),
        [=, &value](const std::string& text) { value = numberIn<Number>(name, text, range); });
}

template void CommandLine::number(const char*, int&, const Range&, const std::string&);
template void CommandLine::number(const char*, double&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<int>&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<double>&, const Range&, const std::string&);
template void CommandLine::number(const char*, std::optional<std::uint64_t>&, const Range&,
                                  const std::string&);

void CommandLine::exclude(const char* option, std::initializer_list<const char*> others) {
    for (const char* other : others) app_->get_option(option)->excludes(app_->get_option(other));
}

void CommandLine::footer(const char* text) { app_->footer(text); }

std::optional<int> CommandLine::parse(int argc, char** argv) {
    try {
        app_->parse(argc, argv);
    } catch (const CLI::ParseError& end) {
        const std::string& command = app_->get_name();
        if (end.get_exit_code() != 0) {
            tell(command + ": " + end.what() + " (" + command + " --help tells more)");
            return 2;
        }
        print(app_->help());
        return 0;
    }
    return std::nullopt;
}

}  // namespace raytracer::commands
