#include "raytracer/util/shell_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "raytracer/util/text.h"

namespace raytracer {
namespace {

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool isAmong(char c, std::string_view characters) { return characters.find(c) != characters.npos; }

class WordReader {
  public:
    explicit WordReader(std::string_view command) : command_(command) {}

    // False at the end.
    bool read(ShellWord& word) {
        skipBlanks();
        if (isEnd()) return false;
        word = {at_, at_};
        if (isAmong(now(), operators)) readOperator(word);
        else readWord(word);
        word.end = at_;
        return true;
    }

  private:
    static constexpr std::string_view operators = ";|&<>()\n";

    bool isEnd() const { return at_ >= command_.size(); }
    char now() const { return command_[at_]; }

    void skipBlanks() {
        while (!isEnd() && isAmong(now(), " \t\r")) ++at_;
        if (isEnd() || now() != '#') return;
        at_ = std::min(command_.find('\n', at_), command_.size());
    }

    void readOperator(ShellWord& word) {
        const char first = now();
        const bool isAlone = isAmong(first, "()\n");
        word.text += command_[at_++];
        while (!isAlone && !isEnd() && isAmong(now(), ";|&<>")) word.text += command_[at_++];
        const bool leads = isAmong(first, "<>") || word.text.starts_with("&>");
        word.role = leads ? ShellRole::Redirection : ShellRole::Operator;
    }

    void readWord(ShellWord& word) {
        while (!isEnd() && !isAmong(now(), operators) && !isAmong(now(), " \t\r")) readCharacter(word);
        const bool isNumber = !word.isQuoted && std::ranges::all_of(word.text, isDigit);
        if (isNumber && !isEnd() && isAmong(now(), "<>")) readOperator(word);  // 2>
    }

    void readCharacter(ShellWord& word) {
        const char c = command_[at_];
        if (c == '\'' || c == '"') return readQuoted(word, c);
        if (c == '\\') return readEscaped(word);
        const bool isFolder = command_.substr(at_, 2) == "{}";
        if (isAmong(c, "$`*?[{}") && !isFolder) word.isPlain = false;
        if (c == '~' && word.text.empty()) word.isPlain = false;
        word.text += command_.substr(at_, isFolder ? 2 : 1);
        at_ += isFolder ? 2 : 1;
    }

    void readEscaped(ShellWord& word) {
        word.isQuoted = true;
        if (++at_ < command_.size()) word.text += command_[at_++];
    }

    void readQuoted(ShellWord& word, char quote) {
        word.isQuoted = true;
        for (++at_; !isEnd() && now() != quote; ++at_) {
            if (quote == '"' && isAmong(now(), "$`")) word.isPlain = false;
            const bool isEscape = quote == '"' && now() == '\\' && at_ + 1 < command_.size() &&
                                  isAmong(command_[at_ + 1], "$`\"\\");
            word.text += command_[isEscape ? ++at_ : at_];
        }
        if (isEnd()) word.isPlain = false;  // a quote without its end
        else ++at_;
    }

    std::string_view command_;
    std::size_t at_ = 0;
};

enum class Starter { None, Wrapper, Shell, Interpreter, Java };

// Of a command, by its name: python for /usr/bin/python3.12.
Starter starterOf(std::string_view path) {
    constexpr std::array<std::string_view, 12> wrappers{"env",     "timeout", "nice",   "nohup",
                                                        "time",    "stdbuf",  "setsid", "taskset",
                                                        "command", "exec",    "sudo",   "xvfb-run"};
    constexpr std::array<std::string_view, 5> shells{"sh", "bash", "dash", "zsh", "ksh"};
    constexpr std::array<std::string_view, 10> interpreters{"python", "pypy",   "node",  "ruby",    "perl",
                                                            "lua",    "luajit", "julia", "Rscript", "php"};
    std::string_view name = path.substr(path.rfind('/') + 1);
    while (!name.empty() && (isDigit(name.back()) || name.back() == '.')) name.remove_suffix(1);
    const auto isIn = [&](const auto& names) { return std::ranges::find(names, name) != names.end(); };
    if (name == "java") return Starter::Java;
    if (isIn(wrappers)) return Starter::Wrapper;
    if (isIn(shells)) return Starter::Shell;
    return isIn(interpreters) ? Starter::Interpreter : Starter::None;
}

// Whether a command follows the shell's keyword.
bool isLeading(std::string_view text) {
    constexpr std::array<std::string_view, 9> keywords{"if",    "then",  "elif", "else", "do",
                                                       "while", "until", "{",    "!"};
    return std::ranges::find(keywords, text) != keywords.end();
}

bool isAssignment(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0 || isDigit(text[0])) return false;
    return std::ranges::all_of(text.substr(0, equals),
                               [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

// Whether no file follows the option that is to be run: it gives the program itself, or another folder.
bool hasNoScript(Starter starter, std::string_view option) {
    const bool isLong = option.starts_with("--");
    if (starter == Starter::Shell) return !isLong && isAmong('c', option);
    if (starter == Starter::Wrapper) return option == "-C" || option == "-S" || option.starts_with("--chdir");
    return option == "-c" || option == "-m" || option == "-e" || option == "--eval";
}

// Follows one simple command after the other.
class RoleFinder {
  public:
    ShellRole next(const ShellWord& word) {
        if (word.role == ShellRole::Operator) *this = {};
        if (word.role == ShellRole::Redirection) isTarget_ = true;
        if (word.role != ShellRole::Argument) return word.role;
        if (std::exchange(isTarget_, false)) return ShellRole::Target;
        if (!isNamed_) return first(word);
        if (starter_ == Starter::None) return ShellRole::Argument;
        const bool isBehind = !option_.empty();
        if (word.text.starts_with('-')) return option(word);
        const ShellRole role =
            starter_ == Starter::Wrapper ? ofWrapper(word, isBehind) : ofInterpreter(word, isBehind);
        option_.clear();
        return role;
    }

  private:
    ShellRole first(const ShellWord& word) {
        if (isAssignment(word.text)) return ShellRole::Assignment;
        if (!word.isQuoted && isLeading(word.text)) return ShellRole::Keyword;
        isNamed_ = true;
        starter_ = starterOf(word.text);
        return ShellRole::Command;
    }

    ShellRole option(const ShellWord& word) {
        option_ = word.text;
        if (hasNoScript(starter_, option_)) starter_ = Starter::None;
        return ShellRole::Option;
    }

    ShellRole ofWrapper(const ShellWord& word, bool isBehind) {
        const Starter starter = starterOf(word.text);
        const bool isName = !isAmong('/', word.text);
        const bool isValue = isBehind && starter == Starter::None;
        if (isAssignment(word.text) || (isName && (isValue || isDigit(word.text[0]))))
            return ShellRole::Argument;
        starter_ = starter;
        return ShellRole::Wrapped;
    }

    ShellRole ofInterpreter(const ShellWord& word, bool isBehind) {
        if (starter_ == Starter::Java) {
            const bool isFile = option_ == "-jar" || endsIn(word.text, ".java");
            if (isFile || !isBehind) starter_ = Starter::None;
            return isFile ? ShellRole::Script : ShellRole::Argument;
        }
        if (!isBehind || isAmong('.', word.text)) starter_ = Starter::None;
        return ShellRole::Script;
    }

    bool isTarget_ = false, isNamed_ = false;
    Starter starter_ = Starter::None;
    std::string option_;  // right before
};

}  // namespace

std::vector<ShellWord> shellWords(std::string_view command) {
    std::vector<ShellWord> words;
    WordReader reader(command);
    RoleFinder roles;
    for (ShellWord word; reader.read(word) && word.text.find("<<") == word.text.npos;) {
        word.role = roles.next(word);
        words.push_back(word);
    }
    return words;
}

bool hasQuotedBraces(std::string_view command) {
    char quote = 0;
    for (std::size_t at = 0; at < command.size(); ++at) {
        const char c = command[at];
        if (c == '\\' && quote != '\'') ++at;
        else if (quote ? c == quote : c == '\'' || c == '"') quote = quote ? '\0' : c;
        else if (quote && command.substr(at, 2) == "{}") return true;
    }
    return false;
}

}  // namespace raytracer
