#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>

#include "raytracer/util/shell_words.h"

using namespace raytracer;

namespace {

// Each word, operators with O:, redirections with R:, and with $ what the shell changes.
std::string told(const char* command) {
    std::string all;
    for (const ShellWord& word : shellWords(command)) {
        const char* const kind = word.kind == ShellWord::Operator      ? "O:"
                                 : word.kind == ShellWord::Redirection ? "R:"
                                                                       : "";
        all += (all.empty() ? "" : " ") + std::string(kind) + (word.isPlain ? "" : "$") + word.text;
    }
    return all;
}

}  // namespace

TEST_CASE("shell words: quotes, blanks and operators") {
    CHECK(told("") == "");
    CHECK(told("a\\") == "a");
    CHECK(told("a\\\n b\\\nc \\\n d \"e\\\nf\"") == "a bc d ef");
    CHECK(told("a\tb  'c d'\"e\\\"f\"\\ g") == "a b c de\"f g");
    CHECK(told("a;b&&c|d # e\nf") == "a O:; b O:&& c O:| d O:\n f");
    CHECK(told("2>/dev/null a 8 >b") == "R:2> /dev/null a 8 R:> b");
    CHECK(told("a $b \"$c\" '$d' {} ~ e~ f* {g") == "a $$b $$c $d {} $~ e~ $f* ${g");
    CHECK(told("a 'b") == "a $b");
    CHECK(told("a <<b\nc") == "a");
    CHECK(told("f() { a; }") == "f O:( O:) ${ a O:; $}");
}

TEST_CASE("shell words: a tilde before a slash is the home folder") {
    const char* const before = std::getenv("HOME");
    const std::string home = before ? before : "";
    ::setenv("HOME", "/home/my name", 1);
    CHECK(told("~/a ~/{} > ~/b") == "/home/my name/a /home/my name/{} R:> /home/my name/b");
    CHECK(told("~/'a b' ~/$c") == "/home/my name/a b $/home/my name/$c");
    CHECK(told("~ ~a/b ~'/a' '~/a' \\~/a b~/a A=~/a") == "$~ $~a/b $~/a ~/a ~/a b~/a A=~/a");
    ::setenv("HOME", "", 1);
    CHECK(told("~/a") == "$~/a");
    ::setenv("HOME", home.c_str(), 1);
}

TEST_CASE("shell words: braces in quotes") {
    for (const char* quoted : {"'{}/a'", "\"a {}\"", "sh -c 'cd {}'", "\\' '{}'"})
        CHECK(std::ranges::any_of(shellWords(quoted), &ShellWord::quotesBraces));
    for (const char* free : {"{}/a", "'a'{}\"b\"", "\\'{}", "\"\\\"\"{}", ""})
        CHECK(std::ranges::none_of(shellWords(free), &ShellWord::quotesBraces));
}
