#include "core/base/json_reader.h"
#include "core/base/message_table.h"
#include "core/base/text_check.h"

#include <gtest/gtest.h>

namespace knittsim {
namespace {

using namespace std::string_literals;

std::string reason(const std::string& bytes) {
    const auto found = whyNotText(bytes, "a.txt");
    return found ? toLine(*found) : "text";
}

TEST(TextCheck, TextIsTextEvenWithBrokenCharacters) {
    EXPECT_EQ(reason("knit + f1 1\n"), "text");
    EXPECT_EQ(reason("\n"), "text");
    EXPECT_EQ(reason("\t \f\r\n"), "text");
    EXPECT_EQ(reason("M\xFCtze"), "text");
    EXPECT_EQ(reason("\xEF\xBB\xBFknit"), "text");
    EXPECT_EQ(reason("a comment with one \x1B[0m escape"), "text");
}

TEST(TextCheck, OtherBytesHaveOneReasonEach) {
    EXPECT_EQ(reason(""),
              "a.txt:1:1: error KS0012: The file is empty. Check that the right file was chosen.");
    EXPECT_EQ(reason("\xEF\xBB\xBF").substr(0, 25), "a.txt:1:1: error KS0012: ");
    EXPECT_EQ(reason("\xFF\xFEk\0"s),
              "a.txt:1:1: error KS0013: The file is text in UTF-16, expected UTF-8. Save the file as UTF-8.");
    EXPECT_EQ(reason("\xFE\xFF\0k"s).substr(0, 50), "a.txt:1:1: error KS0013: The file is text in UTF-1");
    EXPECT_NE(reason("\xFF\xFE\0\0k\0\0\0"s).find("UTF-32"), std::string::npos);
    EXPECT_NE(reason("\0\0\xFE\xFF\0\0\0k"s).find("UTF-32"), std::string::npos);
    EXPECT_EQ(reason("ab\nc\0d"s).substr(0, 25), "a.txt:2:2: error KS0122: ");
    EXPECT_EQ(reason("ab\n\x01\x02"),
              "a.txt:2:1: error KS0014: This is not a text file: 2 of its 5 bytes are control characters. "
              "Check that the right file was chosen.");
}

TEST(TextCheck, JsonReportsTheSameReasonsAndABoundedNumberOfProblems) {
    EXPECT_EQ(parseJson("", "a.json").diagnostics().at(0).id, "KS0012");
    EXPECT_EQ(parseJson("\xFF\xFE{\0"s, "a.json").diagnostics().at(0).id, "KS0013");
    EXPECT_TRUE(parseJson("\xEF\xBB\xBF{}", "a.json"));
    nlohmann::json many;
    for (int i = 0; i < 1000; ++i) {
        many["key" + std::to_string(i)] = i;
    }
    Diagnostics problems;
    JsonReader(many, "a.json", problems).rejectUnknownKeys();
    ASSERT_EQ(problems.size(), JsonReader::kMaxProblems + 1);
    EXPECT_EQ(problems.back().id, "KS0115");
}

} // namespace
} // namespace knittsim
