#include <catch2/catch.hpp>

#include "raytracer/util/shell_words.h"

using namespace raytracer;

namespace {

// Each word with a letter for its role; those that the shell changes with a $.
std::string told(const char* command) {
    std::string all;
    for (const ShellWord& word : shellWords(command))
        all += (all.empty() ? "" : " ") + std::string(1, "ORTAKCWoSa"[static_cast<int>(word.role)]) + ':' +
               (word.isPlain ? "" : "$") + word.text;
    return all;
}

}  // namespace

TEST_CASE("shell words: quotes, blanks and operators") {
    CHECK(told("") == "");
    CHECK(told("a\tb  'c d'\"e\\\"f\"\\ g") == "C:a a:b a:c de\"f g");
    CHECK(told("a;b&&c|d # e\nf") == "C:a O:; C:b O:&& C:c O:| C:d O:\n C:f");
    CHECK(told("2>/dev/null a 8 >b") == "R:2> T:/dev/null C:a a:8 R:> T:b");
    CHECK(told("a $b \"$c\" '$d' {} ~ e~ f* {g") == "C:a a:$$b a:$$c a:$d a:{} a:$~ a:e~ a:$f* a:${g");
    CHECK(told("a 'b") == "C:a a:$b");
    CHECK(told("a <<b\nc") == "C:a");
    CHECK(told("f() { a; }") == "C:f O:( O:) K:${ C:a O:; C:$}");
}

TEST_CASE("shell words: what starts what") {
    CHECK(told("A=1 B= a") == "A:A=1 A:B= C:a");
    CHECK(told("if ! a; then b; fi") == "K:if K:! C:a O:; K:then C:b O:; C:fi");
    CHECK(told("timeout -s KILL 8 a b") == "C:timeout o:-s a:KILL a:8 W:a a:b");
    CHECK(told("env A=1 nice -n 10 python3 -u b.py c.py") ==
          "C:env a:A=1 W:nice o:-n a:10 W:python3 o:-u S:b.py a:c.py");
    CHECK(told("env -C a python3 b.py") == "C:env o:-C a:a a:python3 a:b.py");
    CHECK(told("/bin/bash -lc a") == "C:/bin/bash o:-lc a:a");
    CHECK(told("java -cp a.jar B c") == "C:java o:-cp a:a.jar a:B a:c");
    CHECK(told("java -jar a.jar b.jar") == "C:java o:-jar S:a.jar a:b.jar");
    CHECK(told("java A.java") == "C:java S:A.java");
}

TEST_CASE("shell words: braces in quotes") {
    for (const char* quoted : {"'{}/a'", "\"a {}\"", "sh -c 'cd {}'", "\\' '{}'"})
        CHECK(hasQuotedBraces(quoted));
    for (const char* free : {"{}/a", "'a'{}\"b\"", "\\'{}", "\"\\\"\"{}", ""})
        CHECK_FALSE(hasQuotedBraces(free));
}
