#include "raytracer/util/shell_words.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace raytracer {
namespace {

bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool isAmong(char c, std::string_view characters) { return characters.find(c) != characters.npos; }

constexpr std::string_view blanks = " \t\r", joiners = ";|&<>", alone = "()\n";

class WordReader {
  public:
    explicit WordReader(std::string_view command) : command_(command) {}

    // Reads the next word. False at the end.
    bool read(ShellWord& word) {
        while (isAt(blanks) || isContinued()) at_ += isContinued() ? 2 : 1;
        if (isAt("#")) at_ = std::min(command_.find('\n', at_), command_.size());
        if (isEnd()) return false;
        word = {at_, at_};
        readHome(word);
        if (isAt(joiners) || isAt(alone)) readOperator(word);
        else readWord(word);
        word.end = at_;
        return true;
    }

  private:
    bool isEnd() const { return at_ >= command_.size(); }
    bool isAt(std::string_view characters) const { return !isEnd() && isAmong(command_[at_], characters); }

    // Whether a backslash ends the line here: a shell removes both.
    bool isContinued() const { return command_.substr(std::min(at_, command_.size()), 2) == "\\\n"; }

    // Reads a "~" before a slash as $HOME. What a shell makes of any other is not known here.
    void readHome(ShellWord& word) {
        const char* const home = std::getenv("HOME");
        if (command_.substr(at_, 2) != "~/" || !home || !*home) return;
        word.text = home;
        ++at_;
    }

    void readOperator(ShellWord& word) {
        const bool isAlone = isAt(alone), leads = isAt("<>") || command_.substr(at_, 2) == "&>";
        word.kind = leads ? ShellWord::Redirection : ShellWord::Operator;
        word.text += command_[at_++];
        while (!isAlone && isAt(joiners)) word.text += command_[at_++];
    }

    void readWord(ShellWord& word) {
        char quote = 0;
        for (; !isEnd() && (quote || !(isAt(blanks) || isAt(joiners) || isAt(alone))); ++at_) {
            const char c = command_[at_];
            if (quote != '\'' && isContinued()) ++at_;
            else if (c == quote) quote = 0;
            else if (!quote && isAmong(c, "'\"")) quote = c;
            else if (!isEscape(quote)) readCharacter(word, quote);
            else if (at_ + 1 < command_.size()) word.text += command_[++at_];
        }
        if (quote) word.isPlain = false;  // the quote is not closed
        const bool isNumber = at_ - word.begin == word.text.size() && std::ranges::all_of(word.text, isDigit);
        if (isNumber && isAt("<>")) readOperator(word);  // 2>
    }

    bool isEscape(char quote) const {
        if (!isAt("\\") || quote == '\'') return false;
        return !quote || isAmong(command_.substr(at_, 2).back(), "$`\"\\");
    }

    void readCharacter(ShellWord& word, char quote) {
        const char c = command_[at_];
        word.text += c;
        if (command_.substr(at_, 2) == "{}") {
            word.text += command_[++at_];
            word.quotesBraces = word.quotesBraces || quote;
        } else if (isAmong(c, !quote         ? "$`*?[{}"
                              : quote == '"' ? "$`"
                                             : "") ||
                   (c == '~' && at_ == word.begin)) {
            word.isPlain = false;
        }
    }

    std::string_view command_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<ShellWord> shellWords(std::string_view command) {
    std::vector<ShellWord> words;
    WordReader reader(command);
    for (ShellWord word; reader.read(word) && word.text.find("<<") == word.text.npos;) words.push_back(word);
    return words;
}

}  // namespace raytracer
