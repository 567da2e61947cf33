#include <catch2/catch.hpp>

#include "raytracer/util/progress_bar.h"
#include "raytracer/util/text.h"

using namespace raytracer;

TEST_CASE("formatted text is printf's, of any length") {
    CHECK(formatted("%s", "").empty());
    CHECK(formatted("%.3g %d %%", 0.12345, -7) == "0.123 -7 %");
    const std::string page(100000, 'x');
    CHECK(formatted("<%s>", page.c_str()) == "<" + page + ">");
}

TEST_CASE("printable text is UTF-8 without control characters") {
    const std::string good = "a~ \u00a0\u00e4\u2603\U0001f600\U0010fffd'<&";
    CHECK(printable(good) == good);
    CHECK(printable({"\0\n\x1b[31m\x7f", 8}) == "\\x00\\x0a\\x1b[31m\\x7f");
    CHECK(printable("a\r\n\t", "\n\t") == "a\\x0d\n\t");
    CHECK(printable("\u009b\uffff") == "\\xc2\\x9b\\xef\\xbf\\xbf");
    // What turns the direction of the text around it.
    CHECK(printable("a\u202eb\u2066") == "a\\xe2\\x80\\xaeb\\xe2\\x81\\xa6");
    for (const char* mark : {"\u061c", "\u200e", "\u200f", "\u202a", "\u202d", "\u2067", "\u2069"})
        CHECK(printableBytes(mark) == 0);
    CHECK(inQuotes("\u202efdp") == "\"\\u202efdp\"");
    CHECK(inQuotes("\xff\n\"\x1b") == "\"\\xff\\n\\\"\\u001b\"");
    // Too long, a surrogate, beyond Unicode, cut short, without a beginning.
    CHECK(printable("\xc0\x80") == "\\xc0\\x80");
    CHECK(printable("\xe0\x9f\xbf") == "\\xe0\\x9f\\xbf");
    CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");
    CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
    CHECK(printable("\xe2\x98") == "\\xe2\\x98");
    CHECK(printable("\xe2\x98z") == "\\xe2\\x98z");
    CHECK(printable("\x98") == "\\x98");
}

TEST_CASE("A name's ending counts in large and small letters") {
    CHECK(endsIn("a.PnG", ".png"));
    CHECK(endsIn(".png", ".png"));
    CHECK_FALSE(endsIn("png", ".png"));
    CHECK_FALSE(endsIn("a.png.txt", ".png"));
}

TEST_CASE("text is wrapped at blanks, to columns of characters") {
    CHECK(wrapped("", 10, 2) == "");
    CHECK(wrapped("one two three", 20, 2) == "one two three");
    CHECK(wrapped("one two three", 7, 2) == "one two\n  three");
    CHECK(wrapped("one two three", 6, 0) == "one\ntwo\nthree");
    CHECK(wrapped("8 × 8 × 8", 5, 1) == "8 × 8\n × 8");
    CHECK(wrapped("a_word_of_its_own and", 8, 2) == "a_word_of_its_own\n  and");
    CHECK(wrapped("one two", 30, 24, 24) == "one\n" + std::string(24, ' ') + "two");
}

TEST_CASE("columns are counted as a terminal shows them") {
    CHECK(columnCount("a\u00e4\u00d7") == 3);
    CHECK(columnCount("e\u0301") == 1);
    for (const char* wide :
         {"\u2705", "\u231a", "\u65e5", "\uff01", "\U0001f600", "\U0001f7e0", "\U00017000"})
        CHECK(columnCount(wide) == 2);
    // Thai, Arabic, Hebrew and Hindi; a zero-width space, and what turns the text.
    for (const char* none : {"\u0e34", "\u064b", "\u05b0", "\u094d", "\u20d0", "\u200b", "\u2069"})
        CHECK(columnCount(none) == 0);
    CHECK(columnCount("\xff") == 1);
}

TEST_CASE("a character that nobody sees is known") {
    for (const char* blank : {"\u00a0", "\u2000", "\u2003", "\u202f", "\u205f", "\u3000", "\u2028", "\u2800",
                              "\u3164", "\f", "\u0085"})
        CHECK(invisibleCharacter(blank) > 0);
    CHECK(invisibleCharacter("\u200bx") == 0x200b);
    CHECK(invisibleCharacter("\u00ad") == 0xad);
    CHECK(invisibleCharacter("\u202e") == 0x202e);
    CHECK(invisibleCharacter("\ufeff") == 0xfeff);
    for (const char* seen : {"", " ", "\t", "a", "\u00e4", "\xff", "x\u200b"})
        CHECK(invisibleCharacter(seen) == 0);
}

TEST_CASE("a long dash is no hyphen") {
    CHECK(behindLongDash("\u2013help") == "help");
    CHECK(behindLongDash("\u22121") == "1");
    CHECK(behindLongDash("--help").empty());
    CHECK(behindLongDash("a\u2014").empty());
}

TEST_CASE("the progress bar fits its columns") {
    CHECK(StepProgress::bar(0.5, 10, 80) ==
          "[" + std::string(20, '#') + std::string(20, ' ') + "]  50 %  0:10 left");
    CHECK(StepProgress::bar(0.5, 10, 40) == "[##########          ]  50 %  0:10 left");
    CHECK(StepProgress::bar(1, 10, 21) == "[#] 100 %  0:00 left");
    CHECK(StepProgress::bar(1, 10, 20) == "100 %  0:00 left");
}
