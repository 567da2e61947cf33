// The words of a program's command: which are files of ours, what it starts, and why that cannot work.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <utility>

#include "programs.h"
#include "raytracer/util/nearby_file.h"
#include "raytracer/util/shell_words.h"
#include "raytracer/util/temporary_folder.h"
#include "raytracer/util/text.h"

namespace raytracer {

namespace {

namespace files = std::filesystem;

using WordSet = std::set<std::string_view>;

bool hasSlash(std::string_view word) { return word.find('/') != word.npos; }

// Whether the command is an interpreter, which runs a script: python, also as /usr/bin/python3.12.
bool isInterpreter(std::string_view command) {
    static const WordSet interpreters{"sh",   "bash", "dash", "zsh",    "ksh", "python", "pypy",  "node",
                                      "ruby", "perl", "lua",  "luajit", "php", "java",   "julia", "Rscript"};
    const std::string_view name = command.substr(command.rfind('/') + 1);
    return interpreters.contains(name.substr(0, name.find_last_not_of("0123456789.") + 1));
}

// Finds the words of a command that are relative paths to files here: the command runs in another folder, so
// they need absolute paths. A word that means a file which the command itself makes is left as it is.
class PathsFromHere {
  public:
    bool isOurs(const ShellWord& word) {
        if (word.kind == ShellWord::Operator) endCommand(word.text == "(");
        if (word.kind == ShellWord::Redirection) isTarget_ = true;
        if (word.kind != ShellWord::Text) return false;
        std::error_code error;
        const bool isTarget = std::exchange(isTarget_, false);
        const bool isThere =
            isHere_ && word.isPlain && !word.text.starts_with('/') && files::exists(word.text, error);
        const bool isScript = isThere && !isTarget && std::exchange(awaitsScript_, false);
        if (isTarget) makes_ = makes_ || !word.text.starts_with("/dev/");
        else follow(word.text);
        if (!isThere || word.text.find_first_not_of("./") == word.text.npos) return false;
        if (!hasSlash(word.text)) return isScript && isFresh_;
        return !word.text.starts_with("./") || (isFresh_ && startsFile_ && !isTarget);
    }

  private:
    // Words of the shell that may stand before a command.
    inline static const WordSet leading{"if", "then", "elif", "else", "do", "while", "until", "{", "!"};
    // Commands, and words of the shell, that make no files.
    inline static const WordSet harmless{"export", "ulimit", "umask", "set",  "unset", "trap",
                                         ":",      "true",   "false", "test", "[",     "echo",
                                         "printf", "for",    "done",  "fi",   "}"};
    // Commands that start another one: p in "timeout 8 p".
    inline static const WordSet wrappers{"env",    "timeout", "nice",    "nohup", "time", "stdbuf",
                                         "setsid", "taskset", "command", "exec",  "sudo", "xvfb-run"};

    // Ends a command. With `isName`, the word was a function's name before (), which is not run.
    void endCommand(bool isName) {
        const bool isFresh = isFresh_ && (isName || !makes_), isHere = isHere_ && !moves_;
        *this = {};
        isFresh_ = isFresh;
        isHere_ = isHere;
    }

    void follow(std::string_view word) {
        const bool isAssignment = word.find('=') != word.npos;
        if (isFirst_ && (isAssignment || leading.contains(word))) return;
        if (isFirst_) {
            makes_ = makes_ || !harmless.contains(word);
            moves_ = word == "cd" || word == "pushd";
            isWrapped_ = wrappers.contains(word);
        }
        const bool isStarted = std::exchange(isFirst_, false) || isWrapped_;
        awaitsScript_ = awaitsScript_ || (isStarted && isInterpreter(word));
        startsFile_ = startsFile_ || awaitsScript_ || (isStarted && hasSlash(word));
    }

    bool isHere_ = true, isFresh_ = true;  // no earlier command has left our folder, or can have made files
    bool makes_ = false, moves_ = false, isWrapped_ = false, startsFile_ = false;  // of this command
    bool isFirst_ = true, isTarget_ = false, awaitsScript_ = false;                // of its next word
};

// Whether the word contains "{}", which stands for a submission's folder.
bool hasFolder(const std::string& word) { return word.find("{}") != word.npos; }

std::string noFile(const std::string& name) { return "there is no file " + printable(name) + hintAt(name); }

// Asks the shell that will run the command: it knows its own commands, and where to look for others.
bool isCommand(const std::string& name) { return runProcess({"command -v", {name}, "/dev/null"}).well(); }

// The script that an interpreter certainly runs: a file's name
// that is not an option's value. Empty if that is not certain.
std::string scriptAmong(std::span<const ShellWord> words) {
    static constexpr std::string_view endings[] = {".py", ".sh",  ".js",  ".rb",
                                                   ".pl", ".lua", ".jar", ".java"};
    static const WordSet otherwise{"-m", "-e", "--eval", "-cp", "-classpath"};
    bool isBehindOption = false;
    for (const ShellWord& word : words) {
        const bool isOption = word.text.starts_with('-');
        const bool isFile =
            std::ranges::any_of(endings, [&](std::string_view ending) { return endsIn(word.text, ending); });
        if (isOption && (word.text.ends_with('c') || otherwise.contains(word.text))) return {};
        if (!isOption && word.isPlain && (isFile || (hasSlash(word.text) && !isBehindOption)))
            return word.text;
        if (!isOption && !isBehindOption) return {};
        isBehindOption = isOption;
    }
    return {};
}

// What a shell says of the command's syntax: it reads the command, and runs nothing of it.
std::string syntaxFault(const std::string& command) {
    const TemporaryFolder folder;
    const std::string said = folder.file("said");
    if (runProcess({"set -n; " + command, {}, said}).well()) return {};
    std::ifstream file(said);
    std::string line;
    std::getline(file, line);
    return "a shell cannot read it: " + printable(line);
}

// The comment at the end of a command, which would hide the arguments that are appended; empty if there is
// none.
std::string lastComment(const std::string& command) {
    const std::vector<ShellWord> words = shellWords(command);
    const std::size_t rest = command.find_first_not_of(" \t", words.empty() ? 0 : words.back().end);
    return rest != command.npos && command[rest] == '#' ? command.substr(rest) : "";
}

std::string faultOfProgram(const std::string& word) {
    std::error_code error;
    const files::file_status status = files::status(word, error);
    constexpr files::perms any =
        files::perms::owner_exec | files::perms::group_exec | files::perms::others_exec;
    const bool isThere = files::is_regular_file(status);
    if (hasFolder(word)) return {};
    if (!hasSlash(word)) {
        const std::string hint = isThere ? "; write ./" + printable(word) : hintAt(word);
        return isCommand(word) ? "" : "there is no command " + printable(word) + hint;
    }
    if (status.type() == files::file_type::not_found) return noFile(word);
    if (files::is_directory(status)) return printable(word) + " is a folder: name a program in it";
    const bool isProgram = (status.permissions() & any) != files::perms::none;
    return isProgram ? "" : printable(word) + " is not executable: chmod +x makes it so";
}

}  // namespace

std::string commandFromHere(const std::string& command) {
    PathsFromHere paths;
    std::string text;
    std::size_t done = 0;
    for (const ShellWord& word : shellWords(command)) {
        if (!paths.isOurs(word)) continue;
        text += command.substr(done, word.begin - done) + inShellQuotes(absolutePath(word.text));
        done = word.end;
    }
    return text + command.substr(done);
}

std::vector<std::string> filesStarted(const std::string& command) {
    const std::vector<ShellWord> words = shellWords(command);
    const auto end = std::ranges::find(words, ShellWord::Operator, &ShellWord::kind);
    const bool isFunction = end != words.end() && end->text == "(";
    const bool hasOther = end != words.end() && end->text == "||";
    if (end == words.begin() || isFunction || hasOther) return {};
    const ShellWord& first = words[0];
    const bool isAssignment = first.text.find('=') != first.text.npos;
    if (first.kind != ShellWord::Text || !first.isPlain || isAssignment) return {};
    std::vector<std::string> started{first.text};
    const std::string script = isInterpreter(first.text) ? scriptAmong({words.begin() + 1, end}) : "";
    if (!script.empty()) started.push_back(script);
    return started;
}

std::string programFault(const std::string& command) {
    if (std::string fault = syntaxFault(command); !fault.empty()) return fault;
    if (const std::string comment = lastComment(command); !comment.empty())
        return "a comment hides the scene from it: leave out " + inQuotes(comment);
    const std::vector<std::string> started = filesStarted(command);
    if (started.empty()) return {};
    if (std::string fault = faultOfProgram(started[0]); !fault.empty() || started.size() < 2) return fault;
    const std::string& script = started[1];
    std::error_code error;
    if (hasFolder(script) || files::exists(script, error)) return {};
    return !hasSlash(script) && isCommand(script) ? "" : noFile(script);
}

}  // namespace raytracer
