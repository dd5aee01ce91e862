#include "core/base/message_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace knittsim {
namespace {

using testing::MatchesRegex;

TEST(MessageTable, HasIdsThatRise) {
    for (std::size_t i = 1; i < messages().size(); ++i) {
        EXPECT_LT(messages()[i - 1].id, messages()[i].id);
    }
}

TEST(MessageTable, HasOneNameAndOneSentenceForEachRule) {
    std::set<std::string_view> names;
    for (const Message& message : messages()) {
        EXPECT_THAT(std::string(message.id), MatchesRegex("KS[0-9]{4}"));
        EXPECT_THAT(std::string(message.name), MatchesRegex("[a-z0-9]+(-[a-z0-9]+)*"));
        EXPECT_TRUE(names.insert(message.name).second) << message.name;
        // An argument that brings its own words may end the sentence.
        EXPECT_TRUE(message.cause.ends_with('.') || message.cause.ends_with('}')) << message.id;
        EXPECT_TRUE(message.cure.empty() || message.cure.ends_with('.')) << message.id;
    }
}

TEST(MessageTable, FindsEveryRuleAndNoOther) {
    for (const Message& message : messages()) {
        EXPECT_EQ(findMessage(message.id), &message);
    }
    for (const char* id : {"", "KS", "KS0000", "KS9999", "ks0001", "KS00010"}) {
        EXPECT_EQ(findMessage(id), nullptr) << id;
    }
}

TEST(FillMessage, PutsArgumentsInTheirPlaces) {
    EXPECT_EQ(fillMessage("{1} before {0}, {0}", {"a", "b"}), "b before a, a");
    EXPECT_EQ(fillMessage("{{0}}", {"a"}), "{a}");
    EXPECT_EQ(fillMessage("", {"a"}), "");
}

TEST(FillMessage, DoesNotFillWhatAnArgumentSays) {
    EXPECT_EQ(fillMessage("{0}{1}", {"{1}", "{0}"}), "{1}{0}");
}

TEST(FillMessage, LeavesOtherBracesAlone) {
    for (const char* text : {"{0}", "{", "}", "{}", "{x}", "{-1}", "{0x}", "{99999999999999999999}", "a{1"}) {
        EXPECT_EQ(fillMessage(text, {}), text);
    }
}

TEST(ToLine, LooksLikeACompilerMessage) {
    Diagnostic d{"KS0107", Severity::Error, Place{.file = "a.k", .line = 3, .column = 7}, {"purl"}};
    EXPECT_EQ(toLine(d),
              "a.k:3:7: error KS0107: Found 'purl', expected an operation of knitout 2. Correct the "
              "spelling.");
    d.place.column = -1;
    EXPECT_THAT(toLine(d), testing::StartsWith("a.k:3: error KS0107: "));
    d.place.line = -1;
    d.severity = Severity::Warning;
    EXPECT_THAT(toLine(d), testing::StartsWith("a.k: warning KS0107: "));
    d.place = {.line = 3, .column = 7};
    EXPECT_THAT(toLine(d), testing::StartsWith("warning KS0107: "));
}

TEST(ToLine, ShowsTheIdOfARuleThatIsNotInTheTable) {
    EXPECT_EQ(toLine({"KS9999", Severity::Info, {}, {}}), "info KS9999: KS9999");
}

TEST(CauseAndCure, AreTheSentencesOfTheRule) {
    const Diagnostic d{"KS0109", Severity::Error, {}, {"7"}};
    EXPECT_EQ(causeText(d), "Carrier '7' is not in the header.");
    EXPECT_EQ(cureText(d), "Add it to ';;Carriers:' or correct the name.");
}

} // namespace
} // namespace knittsim
