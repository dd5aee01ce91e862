#include "core/formats/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace knittsim::formats {
namespace {

TEST(ShownText, IsCutBetweenCharacters) {
    const std::string text = std::string(59, 'a') + "\xC3\xBC" + "b";
    EXPECT_EQ(shown(text), std::string(59, 'a') + "...");
    EXPECT_EQ(shown(text.substr(1)), text.substr(1, 60) + "...");
    EXPECT_EQ(shown(std::string(60, 'a')), std::string(60, 'a'));
}

TEST(ShownText, HasNoControlCharactersAndNoBrokenBytes) {
    EXPECT_EQ(shown("a\tb\x1b\x7f"), "a?b??");
    EXPECT_EQ(shown("\xC2\x85"), "?");            // a C1 control
    EXPECT_EQ(shown("x\xE2\x80\xAEy"), "x?y");    // right-to-left override
    EXPECT_EQ(shown("\xC0\xAF"), "??");           // overlong '/'
    EXPECT_EQ(shown("\xED\xA0\x80"), "???");      // surrogate
    EXPECT_EQ(shown("\xF4\x90\x80\x80"), "????"); // beyond U+10FFFF
    EXPECT_EQ(shown("\xE2\x88"), "??");           // cut short
    EXPECT_EQ(shown("\xE2\x88\x92 \xF0\x9F\xA7\xB6"), "\xE2\x88\x92 \xF0\x9F\xA7\xB6");
}

TEST(Utf8, RepairKeepsTheLength) {
    const std::string text = "ok \xC3\xBC \xFC \xE2\x88";
    EXPECT_FALSE(isUtf8(text));
    EXPECT_EQ(replaceBadUtf8(text), "ok \xC3\xBC ? ??");
    EXPECT_TRUE(isUtf8(replaceBadUtf8(text)));
}

TEST(Words, CarryTheirColumn) {
    Tokens words("  knit\t+ f1  ");
    EXPECT_EQ(words.next().column, 3);
    EXPECT_EQ(words.peek().text, "+");
    EXPECT_EQ(words.rest(), "+ f1");
    EXPECT_EQ(words.next().column, 8);
    EXPECT_EQ(words.next().text, "f1");
    EXPECT_EQ(words.next().text, "");
    EXPECT_EQ(words.next().column, 14);
}

TEST(Numbers, AreWholeAndFinite) {
    EXPECT_EQ(parseNumber("-1.5e2"), -150);
    EXPECT_EQ(parseNumber("+2"), 2);
    EXPECT_EQ(parseNumber("1e999"), std::numeric_limits<double>::infinity());
    for (const char* text :
         {"", "+", "-", "nan", "inf", "-inf", "0x10", "1 ", "1,5", "++1", "+-1", "--1", "e5"}) {
        EXPECT_FALSE(parseNumber(text)) << text;
    }
    EXPECT_EQ(parseInteger("-12"), -12);
    EXPECT_EQ(parseInteger("99999999999999999999"), std::numeric_limits<std::int64_t>::max());
    EXPECT_FALSE(parseInteger("1.0"));
    EXPECT_FALSE(parseInteger("1e3"));
}

TEST(Numbers, AreWrittenAsShortAsTheyReadBack) {
    EXPECT_EQ(formatNumber(0.25), "0.25");
    EXPECT_EQ(formatNumber(-3), "-3");
    EXPECT_EQ(formatNumber(0.1), "0.1");
    for (const double value : {1.0 / 3, 1e-300, 123456789.123456789, -0.75}) {
        EXPECT_EQ(parseNumber(formatNumber(value)), value);
    }
}

} // namespace
} // namespace knittsim::formats
