// Makes a command's help, man page and shell completions from its declarations.
#include <algorithm>

#include "command_line.h"
#include "raytracer/util/text.h"

namespace raytracer::commands {

namespace {

constexpr std::size_t helpColumns = 80;  // the usual width of a terminal
constexpr std::size_t nameColumns = 26;  // the left column: "  --max-recursion N=3" and blanks

std::string entry(const std::string& name, const std::string& help) {
    std::string left = "  " + name;
    left += left.size() + 1 > nameColumns ? "\n" + std::string(nameColumns, ' ')
                                          : std::string(nameColumns - left.size(), ' ');
    return left + wrapped(help, helpColumns, nameColumns, nameColumns) + "\n";
}

// A line of text in roff: backslashes and hyphens are escaped, and so is a beginning that would be a request.
std::string roff(const std::string& text) {
    const std::string plain = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
    return plain.starts_with('.') || plain.starts_with('\'') ? "\\&" + plain : plain;
}

std::string roffLines(const std::string& text) {
    std::string lines;
    for (const std::string& line : split(text, "\n")) lines += roff(line) + "\n";
    return lines;
}

// A help text shortened for a list of options: its first phrase, up to "; " or ". ". If that is too long, it
// is cut at the last ": " that fits; if that does not suffice, at " (", and so on.
std::string brief(const std::string& help) {
    constexpr std::size_t longest = 79;
    std::string first = help.substr(0, std::min(help.find("; "), help.find(". ")));
    for (const char* const end : {": ", " (", ", ", " "})
        if (first.size() > longest) first = first.substr(0, first.rfind(end, longest));
    return first;
}

// A text for zsh: between single quotes, in the brackets of an option of _arguments.
std::string inZsh(const std::string& text) {
    std::string safe = replaced(text, "\\", "\\\\");
    for (const char* const bracket : {"[", "]"}) safe = replaced(safe, bracket, std::string("\\") + bracket);
    return replaced(safe, "'", "'\\''");
}

// A text for fish, between single quotes.
std::string inFish(const std::string& text) { return replaced(replaced(text, "\\", "\\\\"), "'", "\\'"); }

std::string options(const CommandLine& line) {
    std::vector<std::string> names;
    for (const Word& word : line.words())
        if (word.isOption()) names.push_back(word.name);
    return joined(names, " ");
}

// Cases of the completion script: "COMMAND PREVIOUS-WORD" for values, "COMMAND ..." for all options.
std::string forBash(const CommandLine& line) {
    const std::string command = line.name().empty() ? "render" : line.name();
    std::string cases;
    for (const Word& word : line.words())
        if (!word.choices.empty())
            cases += "        \"" + command + " " + word.name + "\") words=\"" + joined(word.choices, " ") +
                     "\" ;;\n";
        else if (word.isOption() && !word.isFlag())
            cases += "        \"" + command + " " + word.name + "\") return ;;\n";
    return cases + "        \"" + command + " \"*) [[ $current == -* ]] && words=\"" + options(line) +
           "\" ;;\n";
}

std::string zshFiles(ArgumentKind kind) {
    switch (kind) {
        case ArgumentKind::Scene: return "_files -g \"*.json\"";
        case ArgumentKind::Picture: return "_files -g \"*.(png|pfm)\"";
        case ArgumentKind::Folder: return "_files -/";
        case ArgumentKind::Any: return "_files";
        case ArgumentKind::Number: break;
    }
    return " ";
}

std::string forZsh(const CommandLine& line) {
    std::string specs;
    for (const Word& word : line.words()) {
        const std::string values =
            word.choices.empty() ? zshFiles(word.kind) : "(" + joined(word.choices, " ") + ")";
        const std::string value = word.isFlag() ? "" : ":" + word.placeholder + ":" + values;
        if (word.isOption())
            specs += "            '" + word.name + "[" + inZsh(brief(word.help)) + "]" + value + "' \\\n";
        else
            specs += std::string("            '") + (word.isMany ? "*" : "") + ":" + word.name + ":" +
                     values + "' \\\n";
    }
    const std::string& name = line.name();
    return "        " + (name.empty() ? "*" : name) + ")\n        _arguments \\\n" + specs +
           "            && return ;;\n";
}

std::string forFish(const CommandLine& line) {
    const std::string& name = line.name();
    const std::string when = std::string(name.empty() ? "not " : "") + "__fish_seen_subcommand_from " +
                             (name.empty() ? "$names" : name);
    std::string lines;
    if (!name.empty())
        lines = "complete -c raytracer -n __fish_use_subcommand -a " + name + " -d '" +
                inFish(brief(line.purpose())) + "'\n";
    for (const Word& word : line.words()) {
        if (!word.isOption()) continue;
        lines += "complete -c raytracer -n \"" + when + "\" -l " + word.name.substr(2) + " -d '" +
                 inFish(brief(word.help)) + "'";
        if (!word.choices.empty()) lines += " -xa '" + joined(word.choices, " ") + "'";
        else if (word.kind == ArgumentKind::Number) lines += " -x";
        else if (!word.isFlag()) lines += " -r";
        lines += "\n";
    }
    return lines;
}

}  // namespace

std::string CommandLine::help() const {
    std::string arguments, options;
    for (const Word& word : words_) {
        const std::string value = word.isFlag() ? "" : " " + word.shown();
        if (word.isOption()) options += entry(word.name + value, word.help);
        else arguments += entry(word.name + (word.isMany ? "..." : ""), word.help);
    }
    return purpose_ + "\n\nUsage: " + command_ + " [options] " + order() + "\n\n" + arguments +
           "\nOptions:\n" + options + "\n" + footer_ + "\n";
}

std::string CommandLine::manual() const {
    std::string text = ".SH \"" + command_ + "\"\n.B " + roff(command_) + "\n[options] " + roff(order()) +
                       "\n.PP\n" + roff(purpose_) + "\n";
    for (const Word& word : words_) {
        const std::string value = word.isFlag()     ? ""
                                  : word.isOption() ? " \\fI" + roff(word.shown()) + "\\fR"
                                                    : "";
        text += ".TP\n\\fB" + roff(word.name) + "\\fR" + value + "\n" + roff(word.help) + "\n";
    }
    return text + ".PP\n.in 0\n.nf\n" + roffLines(footer_) + ".fi\n.in\n";
}

std::string CommandLine::completion(const std::string& shell) const {
    return shell == "bash" ? forBash(*this) : shell == "zsh" ? forZsh(*this) : forFish(*this);
}

// The command's part of the installed man page and completions: run.cpp asks each command for it.
std::optional<std::string> CommandLine::document(const std::vector<std::string>& line) const {
    if (line.size() == 1 && line[0] == "--print-manual") return manual();
    if (line.size() != 2 || line[0] != "--print-completion") return std::nullopt;
    if (std::ranges::find(shells, line[1]) == std::end(shells))
        refuse(line[0], listed({std::begin(shells), std::end(shells)}), inQuotes(line[1]));
    return completion(line[1]);
}

}  // namespace raytracer::commands
