#include "core/base/message_table.h"
#include "tests/support/build.h"
#include "ui/document/history_text.h"
#include "ui/document/message_text.h"
#include "ui/document/operation_text.h"
#include "ui/views/style/numbers.h"

#include <QLocale>
#include <gtest/gtest.h>

namespace knittsim {
namespace {

class TextTest : public ::testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale::c()); }
};

TEST_F(TextTest, OperationsAreSaidInWords) {
    const machine::Program program = test::program(
        "inhook 1\nknit - f5 1\nxfer f5 b4\nrack -1\nknit + b2 1 3\ntuck + f-3 2\nsplit - f1 b1 1\n");
    EXPECT_EQ(document::operationText(program, 0), QStringLiteral("Bring in carrier 1 with the hook"));
    EXPECT_EQ(document::operationText(program, 1),
              QStringLiteral("Knit on front needle 5 with carrier 1, to the left"));
    EXPECT_EQ(document::operationText(program, 2),
              QStringLiteral("Transfer from front needle 5 to rear needle 4"));
    EXPECT_EQ(document::operationText(program, 3), QStringLiteral("Rack the rear bed to \u22121"));
    EXPECT_EQ(document::operationText(program, 4),
              QStringLiteral("Knit on rear needle 2 with carrier 1 + 3, to the right"));
    EXPECT_EQ(document::operationText(program, 5),
              QStringLiteral("Tuck on front needle -3 with carrier 2, to the right"));
    EXPECT_EQ(document::operationText(program, 6),
              QStringLiteral("Split on front needle 1 to rear needle 1 with carrier 1, to the left"));
    EXPECT_TRUE(document::operationText(program, 7).isEmpty());
    EXPECT_TRUE(document::operationText(program, -1).isEmpty());
}

TEST_F(TextTest, AStitchNamesNeedleCourseCarrierAndLine) {
    const machine::Timeline timeline = test::timeline("in 1\nknit - f5 1\nknit + f5 1\n");
    const document::StitchGrid grid(timeline.loops(), fabric::buildFabric(timeline));
    EXPECT_EQ(document::stitchText(timeline.program(), timeline.loops(), grid, 1),
              QStringLiteral("Front needle 5, course 2: knit with carrier 1, line 5"));
}

/// The texts of a point's history, each with its line.
QStringList historyOf(const machine::Timeline& timeline, const fabric::Fabric& fabric,
                      fabric::PointIndex point) {
    QStringList all;
    for (const auto& [line, text] :
         document::historyLines(timeline, fabric::pointHistory(fabric, timeline, point))) {
        all << QStringLiteral("%1 %2").arg(line).arg(text);
    }
    return all;
}

TEST_F(TextTest, AHistoryTellsEveryEventWithItsLine) {
    const machine::Timeline timeline =
        test::timeline("in 1\nknit + f0 1\nknit + f1 1\nknit - f1 1\nknit - f0 1\n"
                       "xfer f0 b0\nrack 1\nxfer b0 f1\nknit + f1 1\ndrop f1\n");
    const fabric::Fabric fabric = fabric::buildFabric(timeline);
    const fabric::Loop& moved = fabric.loops[3];
    EXPECT_EQ(historyOf(timeline, fabric, moved.footLeft),
              QStringList({
                  "7 Made: Knit on front needle 0 with carrier 1, to the left, through one loop, rack 0",
                  "8 Transferred from front needle 0 to rear needle 0, rack 0",
                  "10 Transferred from rear needle 0 to front needle 1, onto one loop, rack +1",
                  "11 Bound: Knit on front needle 1 with carrier 1, to the right, rack +1",
                  "-1 The yarn of this loop lies in front here",
              }));
    EXPECT_EQ(historyOf(timeline, fabric, fabric.loops[0].headRight).last(),
              QStringLiteral("-1 In front here: the loop of line 7 on front needle 0"));
    EXPECT_EQ(
        historyOf(timeline, fabric, fabric.loops[0].headRight).first(),
        QStringLiteral(
            "4 Made: Knit on front needle 0 with carrier 1, to the right, on the empty needle, rack 0"));
    EXPECT_EQ(historyOf(timeline, fabric, fabric.loops[4].headLeft).last(),
              QStringLiteral("12 Dropped by front needle 1"));
    EXPECT_EQ(document::pointText(fabric::pointHistory(fabric, timeline, moved.footLeft)),
              QStringLiteral("Left foot"));
}

TEST_F(TextTest, ACrossingNamesTheOtherStrand) {
    const machine::Timeline timeline =
        test::timeline("in 1\n" + test::pass("knit", 'f', 0, 1, 1) + test::pass("knit", 'f', 1, 0, 1) +
                       "xfer f0 b0\nxfer f1 b1\nrack 1\nxfer b0 f1\nrack -1\nxfer b1 f0\nrack 0\n");
    const fabric::Fabric fabric = fabric::buildFabric(timeline);
    ASSERT_EQ(fabric.crossings.size(), 4U);
    const auto history = fabric::pointHistory(fabric, timeline, fabric.crossings[0].over);
    EXPECT_TRUE(document::pointText(history).startsWith(QStringLiteral("Crossing on the ")));
    const QStringList lines = historyOf(timeline, fabric, fabric.crossings[0].over);
    const QStringList crossed = lines.filter(QStringLiteral("Crossed: "));
    ASSERT_EQ(crossed.size(), 1);
    EXPECT_TRUE(crossed[0].contains(QStringLiteral("; in front of the "))) << crossed[0].toStdString();
    EXPECT_TRUE(crossed[0].contains(QStringLiteral(" leg of the loop of line "))) << crossed[0].toStdString();
    EXPECT_TRUE(historyOf(timeline, fabric, fabric.crossings[0].under)
                    .join('\n')
                    .contains(QStringLiteral("; behind the ")));
}

TEST_F(TextTest, EveryRuleHasACauseAndArgumentsAreFilledIn) {
    for (const Message& message : messages()) {
        Diagnostic diagnostic;
        diagnostic.id = message.id;
        diagnostic.arguments = {"A", "B", "C", "D"};
        EXPECT_FALSE(document::causeText(diagnostic).isEmpty()) << message.id;
        EXPECT_FALSE(document::causeText(diagnostic).contains(QStringLiteral("{0}"))) << message.id;
    }
}

TEST_F(TextTest, NumbersAreShortAndHaveUnits) {
    EXPECT_EQ(ui::energyText(0), QStringLiteral("0 \u00b5J"));
    EXPECT_EQ(ui::energyText(39'200), QStringLiteral("39.2\u202fmJ"));
    EXPECT_EQ(ui::energyText(-0.5), QStringLiteral("\u2212500\u202fnJ"));
    EXPECT_EQ(ui::shortNumber(9.996), QStringLiteral("10.0"));
    EXPECT_EQ(ui::shortNumber(0.00093), QStringLiteral("9.3\u00b710\u207b\u2074"));
    EXPECT_EQ(ui::shortNumber(123.4), QStringLiteral("123"));
}

} // namespace
} // namespace knittsim
