#include "core/formats/knitout/reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace knittsim::formats::knitout {
namespace {

using machine::Bed;
using machine::Carrier;
using machine::CarrierSet;
using machine::Direction;
using machine::Needle;
using machine::Operation;
using machine::OperationKind;
using machine::Program;
using testing::ElementsAre;
using testing::Pair;

Program parsed(const std::string& text) {
    auto result = parse(text, "a.k");
    EXPECT_FALSE(hasErrors(result.diagnostics()));
    return result ? std::move(result).value() : Program{};
}

/// The only operation of a program with the carriers A, B and C.
Operation single(const std::string& line) {
    const Program program = parsed(";!knitout-2\n;;Carriers: A B C\n" + line);
    EXPECT_EQ(program.operations.size(), 1u) << line;
    return program.operations.empty() ? Operation{} : program.operations.front();
}

std::vector<std::string> ids(const Diagnostics& diagnostics) {
    std::vector<std::string> list;
    for (const Diagnostic& diagnostic : diagnostics) {
        list.push_back(diagnostic.id);
    }
    return list;
}

TEST(KnitoutHeader, ReadsEveryHeaderOfTheSpecification) {
    const Program program = parsed(";!knitout-2\n"
                                   ";;Machine: SWG091N2\n"
                                   ";;Yarn-L2: 50-50 Rust\n"
                                   ";;Gauge: 7.5\n"
                                   ";;Carriers: L1,L2;R1 \t 3 ;R4,R5\n"
                                   ";;Position: Keep\n"
                                   ";;Width: 540\n"
                                   ";;X-Presser: on: always\n"
                                   "pause\n");
    EXPECT_EQ(program.header.version, 2);
    EXPECT_EQ(program.header.machine, "SWG091N2");
    EXPECT_EQ(program.header.gauge, 7.5);
    EXPECT_EQ(program.header.position, "Keep");
    EXPECT_EQ(program.header.width, 540);
    EXPECT_THAT(program.header.others, ElementsAre(Pair("X-Presser", "on: always")));
    EXPECT_THAT(program.header.carriers,
                ElementsAre(Carrier{"L1", 0, false, ""}, Carrier{"L2", 0, false, "50-50 Rust"},
                            Carrier{"R1", 0, true, ""}, Carrier{"3", 1, false, ""},
                            Carrier{"R4", 2, true, ""}, Carrier{"R5", 2, true, ""}));
}

TEST(KnitoutHeader, KeepsTheFirstOfTwoAndIgnoresLateOnes) {
    const Program program =
        parsed(";!knitout-2\n;;Carriers: 1\n;;Gauge: 7\n;;Gauge: 15\npause\n;;Gauge: 20\n");
    EXPECT_EQ(program.header.gauge, 7);
}

TEST(KnitoutHeader, TakesLinesWithoutANameAsComments) {
    const auto result = parse(";!knitout-2\n;; made: by hand\n;;\n;;:\n;;Carriers: 1\npause\n", "a.k");
    EXPECT_TRUE(result.diagnostics().empty());
    EXPECT_TRUE(result.value().header.others.empty());
}

TEST(KnitoutHeader, IsReadAlsoWhereTheMagicLineComesLate) {
    const auto result = parse("; by hand\n;!knitout-3\n;;Carriers: 1\n;;Gauge: 7\nin 1\n", "a.k");
    ASSERT_TRUE(result);
    EXPECT_THAT(ids(result.diagnostics()), ElementsAre("KS0101", "KS0102", "KS0123"));
    EXPECT_EQ(result.value().header.version, 3);
    EXPECT_EQ(result.value().header.gauge, 7);
}

TEST(KnitoutOperations, CarryKindDirectionNeedleAndCarriers) {
    const Operation knit = single("knit - b-12 B A\n");
    EXPECT_EQ(knit.kind, OperationKind::Knit);
    EXPECT_EQ(knit.direction, Direction::Left);
    EXPECT_EQ(knit.needle, (Needle{Bed::Rear, -12}));
    EXPECT_EQ(knit.carriers, (CarrierSet{1, 0}));
    EXPECT_EQ(knit.line, 3);

    const Operation split = single("split + fs3 bs+4 C");
    EXPECT_EQ(split.kind, OperationKind::Split);
    EXPECT_EQ(split.needle, (Needle{Bed::FrontSlider, 3}));
    EXPECT_EQ(split.target, (Needle{Bed::RearSlider, 4}));
    EXPECT_EQ(split.carriers, (CarrierSet{2}));
}

TEST(KnitoutOperations, HaveOneKindEach) {
    EXPECT_EQ(single("in A").kind, OperationKind::In);
    EXPECT_EQ(single("inhook A B").kind, OperationKind::InHook);
    EXPECT_EQ(single("releasehook A B").kind, OperationKind::ReleaseHook);
    EXPECT_EQ(single("out A").kind, OperationKind::Out);
    EXPECT_EQ(single("outhook A").kind, OperationKind::OutHook);
    EXPECT_EQ(single("tuck + f1 A").kind, OperationKind::Tuck);
    EXPECT_EQ(single("miss + f1 A").kind, OperationKind::Miss);
    EXPECT_EQ(single("xfer f1 b1").kind, OperationKind::Xfer);
    EXPECT_EQ(single("drop f1").kind, OperationKind::Drop);
    EXPECT_EQ(single("amiss f1").kind, OperationKind::Amiss);
    EXPECT_EQ(single("pause").kind, OperationKind::Pause);
    EXPECT_EQ(single("x-yarn-in + f1 A").kind, OperationKind::YarnIn);
    EXPECT_EQ(single("x-yarn-out - f1 A").kind, OperationKind::YarnOut);
}

TEST(KnitoutOperations, WithoutYarnBecomeDropAmissAndXfer) {
    const Operation drop = single("knit - f1");
    EXPECT_EQ(drop.kind, OperationKind::Drop);
    EXPECT_EQ(drop.direction, Direction::Right);
    EXPECT_EQ(single("tuck - f1 ; none").kind, OperationKind::Amiss);
    const Operation xfer = single("split - b1 f1");
    EXPECT_EQ(xfer.kind, OperationKind::Xfer);
    EXPECT_EQ(xfer.target, (Needle{Bed::Front, 1}));
}

TEST(KnitoutOperations, ReadNumbers) {
    EXPECT_EQ(single("rack -0.75").value, -0.75);
    EXPECT_EQ(single("rack +0.25").value, 0.25);
    EXPECT_EQ(single("rack .5").value, 0.5);
    EXPECT_EQ(single("stitch 4 -2.5").value, 4);
    EXPECT_EQ(single("stitch 4 -2.5").value2, -2.5);
    EXPECT_EQ(single("x-stitch-number 102").value, 102);
    EXPECT_EQ(single("x-stitch-number Z").value, 35);
    EXPECT_FALSE(std::signbit(single("rack -0").value));
}

TEST(KnitoutOperations, ReadColoursInEveryForm) {
    for (const char* line : {"x-vis-color #26C6F6 A B", "x-vis-color 26c6f6 A B"}) {
        const Program program = parsed(std::string(";!knitout-2\n;;Carriers: A B\n") + line);
        ASSERT_EQ(program.operations.size(), 1u);
        EXPECT_EQ(program.operations[0].kind, OperationKind::Colour);
        EXPECT_EQ(program.operations[0].carriers, (CarrierSet{0, 1}));
        EXPECT_THAT(program.texts, ElementsAre("#26c6f6"));
    }
    EXPECT_THAT(parsed(";!knitout-2\n;;Carriers: A\nx-vis-color #1aF A").texts, ElementsAre("#11aaff"));
}

TEST(KnitoutOperations, KeepExtensionsAsTheyAreWritten) {
    const Program program =
        parsed(";!knitout-2\n;;Carriers: 1\n\tx-roller-advance  450 ; now\nx-vis-color #123456 9\n");
    ASSERT_EQ(program.operations.size(), 2u);
    EXPECT_EQ(program.operations[0].kind, OperationKind::Extension);
    EXPECT_EQ(program.operations[1].kind, OperationKind::Extension);
    EXPECT_THAT(program.texts, ElementsAre("x-roller-advance  450", "x-vis-color #123456 9"));
}

TEST(KnitoutComments, OfTheSourceStayWithTheirOperation) {
    const Program program = parsed(";!knitout-2\n;;Carriers: 1\n"
                                   ";!source: one.js:3\n"
                                   "; a comment\n"
                                   "drop f1\n"
                                   "drop f2 ;!source:two \t\n"
                                   "drop f3 ; !source: no\n"
                                   " ;!source: end\r\n");
    EXPECT_THAT(program.sourceComments, ElementsAre(Pair(0, ";!source: one.js:3"), Pair(1, ";!source:two \t"),
                                                    Pair(3, ";!source: end")));
}

TEST(KnitoutBounds, StopAfterTwentyErrors) {
    std::string text = ";!knitout-2\n;;Carriers: 1\n";
    for (int i = 0; i < kMaxProblems; ++i) {
        text += "nonsense\n";
    }
    EXPECT_EQ(parse(text, "a.k").diagnostics().size(), 20u);
    text += "nonsense\nnonsense\n";
    const auto result = parse(text, "a.k");
    ASSERT_EQ(result.diagnostics().size(), 21u);
    EXPECT_EQ(result.diagnostics().back().id, "KS0115");
    EXPECT_EQ(result.diagnostics().back().place.line, 23);
}

TEST(KnitoutBounds, StopListingWarningsAfterAHundred) {
    std::string text = ";!knitout-2\n;;Carriers: 1\n";
    for (int i = 0; i < 150; ++i) {
        text += "x-name-" + std::to_string(i) + "\n";
    }
    const auto result = parse(text, "a.k");
    ASSERT_EQ(result.diagnostics().size(), 101u);
    EXPECT_EQ(result.diagnostics().back().id, "KS0124");
    EXPECT_EQ(result.value().operations.size(), 150u);
}

TEST(KnitoutBounds, RefuseOneEndlessLine) {
    const auto result = parse(std::string(20'000'000, 'k'), "a.k");
    EXPECT_THAT(ids(result.diagnostics()), ElementsAre("KS0101", "KS0116"));
}

TEST(KnitoutBounds, LetASetHoldNoMoreThanItsSize) {
    std::string names;
    for (int i = 0; i <= machine::kMaxCarriersInSet; ++i) {
        names += " c" + std::to_string(i);
    }
    const auto result = parse(";!knitout-2\n;;Carriers:" + names + "\nin" + names + "\n", "a.k");
    EXPECT_THAT(ids(result.diagnostics()), ElementsAre("KS0117"));
}

TEST(KnitoutBounds, ShowNoControlCharactersAndNoLongTexts) {
    const auto result =
        parse(";!knitout-2\n;;Carriers: 1\n\x1b[31mred\xe2\x80\xae\n" + std::string(500, 'y'), "a.k");
    ASSERT_EQ(result.diagnostics().size(), 2u);
    EXPECT_THAT(result.diagnostics()[0].arguments, ElementsAre("?[31mred?"));
    EXPECT_THAT(result.diagnostics()[1].arguments, ElementsAre(std::string(60, 'y') + "..."));
}

TEST(KnitoutBytes, ThatAreNotUtf8BecomeQuestionMarks) {
    const Program program = parsed(";!knitout-2\n;;Carriers: 1\n;;Yarn-1: gr\xFCn \xC3\xBC\npause\n");
    EXPECT_EQ(program.header.carriers[0].yarn, "gr?n \xC3\xBC");
}

TEST(KnitoutBytes, OfOtherFilesGiveAnErrorAndNoProgram) {
    EXPECT_THAT(ids(parse("", "a.k").diagnostics()), ElementsAre("KS0101", "KS0121"));
    EXPECT_FALSE(parse("\xFF\xFE;\0!\0k\0", "a.k"));
    EXPECT_FALSE(parse("<html>\n<body>\n", "a.k"));
}

TEST(KnitoutReader, TellsAMissingFile) {
    const auto result = read("/nowhere/at-all.k");
    EXPECT_THAT(ids(result.diagnostics()), ElementsAre("KS0001"));
}

} // namespace
} // namespace knittsim::formats::knitout
