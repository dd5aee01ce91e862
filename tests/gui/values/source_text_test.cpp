#include "ui/document/source_text.h"

#include <gtest/gtest.h>

namespace knittsim::document {
namespace {

TEST(SourceText, CutsAtBothKindsOfLineEnd) {
    const SourceText text(QStringLiteral("one\r\n\nthree"));
    ASSERT_EQ(text.lineCount(), 3);
    EXPECT_EQ(text.line(1), QStringLiteral("one"));
    EXPECT_TRUE(text.line(2).isEmpty());
    EXPECT_EQ(text.line(3), QStringLiteral("three"));
    EXPECT_EQ(text.longestLine(), 5);
}

TEST(SourceText, ALastLineEndBeginsNoLine) {
    EXPECT_EQ(SourceText(QStringLiteral("one\n")).lineCount(), 1);
    EXPECT_EQ(SourceText(QString()).lineCount(), 0);
}

TEST(SourceText, LinesOutsideAreEmpty) {
    const SourceText text(QStringLiteral("one"));
    EXPECT_TRUE(text.line(0).isEmpty());
    EXPECT_TRUE(text.line(2).isEmpty());
}

} // namespace
} // namespace knittsim::document
